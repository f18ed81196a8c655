// A study as data: which algorithms run on which questions, and what the source reports of them.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lasius/geometry.h"
#include "lasius/grid.h"
#include "lasius/params.h"

namespace lasius::study {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Parameters by their names in `lasius algorithms`, with values as on the command line.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// One algorithm with its settings. An algorithm that the library does not have is left out of the
/// study, and the report says so.
struct Contender {
  std::string name;   ///< of files and columns: letters, digits and '-'
  std::string label;  ///< in tables and legends
  std::string algorithm;
  Settings settings = {};  ///< over its defaults
  int budget = 1;          ///< times as many iterations
};

/// What the source reports of one contender on one question; kUnknown where it does not.
struct Published {
  std::string contender;
  double length = kUnknown;
  double iterations = kUnknown;  ///< until it converges
  double seconds = kUnknown;
};

/// One start and goal on one map, among the polygons of one world, or of an arm in one scene.
struct Question {
  std::string name;  ///< of files
  std::string map;   ///< a file of maps/, or what is generated
  Cell start, goal;  ///< on a map; worlds and scenes have their own
  std::vector<Published> published = {};
};

/// The paths among which a question's optimum is the shortest.
struct Truth {
  enum class Kind { any_angle, moves } kind = Kind::any_angle;
  Neighbours neighbours = Neighbours::eight;  ///< of `moves`
  Corners corners = Corners::forbid;
};

/// Every contender answers every question once for each seed.
struct Experiment {
  std::string name;   ///< of files
  std::string title;  ///< of the report's section
  std::string text;   ///< what is repeated, and on what
  Truth truth = {};
  std::vector<Contender> contenders =
      {};  ///< the first is the one that the others are compared with
  std::vector<Question> questions = {};
  bool portrait = false;  ///< also draws tracks and pheromone of the first contender's first run
  bool by_ant =
      false;  ///< also draws the first contender's tours ant by ant, for ants one at a time
};

class Findings;

enum class Verdict { confirmed, refuted, open };

/// A sentence of the source, and what the runs say of it.
struct Claim {
  std::string text;
  struct Answer {
    Verdict verdict = Verdict::open;
    std::string figures;
  };
  std::function<Answer(const Findings&)> check;
  std::string reason = {};  ///< the likely reason, printed where it is not confirmed
};

struct Study {
  std::string name;
  std::string summary;
  std::string source;
  std::string text;  ///< what is ours: maps, readings of the text
  std::vector<Experiment> experiments;
  std::vector<Claim> claims;
};

/// The same contender with ten times the iterations, named NAME-x10.
Contender tenfold(const Contender& contender);

}  // namespace lasius::study
