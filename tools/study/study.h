// A study as data: which algorithms run on which questions, and what the source reports of them.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lasius/cost/field.h"
#include "lasius/grid/geometry.h"
#include "lasius/params/params.h"
#include "tools/options/options.h"

namespace lasius::study {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Parameters by their names in `lasius algorithms`, with values as on the command line.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Where a run ends, whichever comes first, beside the contender's own iterations. It is looked at
/// after each iteration, so what a run did depends on `steps` alone, but with `seconds` on the
/// machine, too.
struct Budget {
  double steps = std::numeric_limits<double>::infinity();    ///< of all ants
  double seconds = std::numeric_limits<double>::infinity();  ///< of processor time
};

/// One algorithm with its settings. An algorithm that the library does not have is left out of the
/// study, and the report says so.
struct Contender {
  std::string name = {};   ///< of files and columns: letters, digits and '-'
  std::string label = {};  ///< in tables and legends
  std::string algorithm = {};
  Preset preset = Preset::usual;
  Settings settings = {};  ///< over its defaults
  Settings factors = {};   ///< those of the settings that a sweep has set
  Budget budget = {};
  std::string preset_file = {};  ///< whose settings are among those above; empty: none
};

/// What the source reports of one contender on one question; kUnknown where it does not.
struct Published {
  std::string contender;
  double length = kUnknown;
  double iterations = kUnknown;  ///< until it converges
  double seconds = kUnknown;
};

/// Starts and goals drawn once the map is there: joined cells; equal draws on equal maps are equal.
struct Draw {
  int count = 1;
  std::uint64_t seed = 1;
  double apart = 0.5;  ///< at least, as a share of the map's diagonal
};

/// One start and goal on a map, among the polygons of a world, of an arm in a scene, or of a drive.
struct Question {
  std::string name;  ///< of files
  std::string map;   ///< a file of maps/, or what is generated
  Cell start, goal;  ///< on a map; worlds, scenes and drives have their own
  std::vector<Published> published = {};
  std::optional<Draw> draw = {};  ///< in place of start and goal: see draw_questions()
  int line = 0;                   ///< of the study's file, for messages
  double radius = 0;              ///< by which obstacles grow: cells once draw_questions() is done
  /// Costs from 1 on: layers, files of maps/, and around what is blocked, see Inflation, whose
  /// lengths are as the radius. What contenders find is then told by cost, not length.
  std::vector<tool::CostLayers::Layer> layers = {};
  std::optional<Inflation> inflation = {};
  /// Until then radius, start and goal may be in metres of the map's frame.
  bool in_metres = false;
  Point start_m{}, goal_m{};

  bool has_costs() const { return inflation || !layers.empty(); }
  std::pair<std::string, double> ground() const;  ///< names what it is asked on
};

/// What a question's optimum is: the shortest of all paths, or of all walks by these moves.
struct Optimum {
  enum class Kind { any_angle, moves } kind = Kind::any_angle;
  Neighbours neighbours = Neighbours::eight;  ///< of `moves`
  Corners corners = Corners::forbid;
};

/// Every contender answers every question once for each seed.
struct Experiment {
  std::string name;   ///< of files
  std::string title;  ///< of the report's section
  std::string text;   ///< what is repeated, and on what
  Optimum optimum = {};
  std::vector<Contender> contenders =
      {};  ///< the first is the one that the others are compared with
  std::vector<Question> questions = {};
  /// Of run-length distributions: this close to the optimum, fractions; pictures show the first.
  std::vector<double> targets = {0.01};
  bool portrait = false;  ///< also draws tracks and pheromone of the first contender's first run
  bool by_ant =
      false;  ///< also draws the first contender's tours ant by ant, for ants one at a time
  /// Contenders that share a chart over all questions; none: a chart a question, of all of them.
  std::vector<std::pair<std::string, std::vector<std::string>>> charts = {};
};

/// A number that is taken of each run, by a name of value_names().
struct Value {
  std::string name = "length";
  std::string at = "end";    ///< or a budget common to both: "steps", "time", "paths", "iterations"
  double budget = kUnknown;  ///< that budget; unknown: what both contenders spend
  double target = 0;         ///< of "effort": how close to the optimum, a fraction
  int best_of = 1;           ///< the least of so many runs counts, by seed
  bool own_limit = false;    ///< of "effort": to the run's own limit, not to the optimum
};

/// A hypothesis about the source, with its statistic and its control, fixed before the runs.
struct Claim {
  enum class Test {
    less,        ///< `factor` times the value of a is less than that of b
    similar,     ///< the values of a and b differ by at most the fraction `within`
    most,        ///< more than `share` of a's runs have a value from `from` to `to`
    arithmetic,  ///< it holds whatever the runs are: listed, with the number of exceptions
    none,        ///< cannot be repeated: listed
  };
  std::string text, place;  ///< what the source says, and where
  Test test = Test::none;
  Value value = {};
  std::vector<std::string> in = {};  ///< experiments, whose questions count together
  std::string a = {}, b = {};
  double factor = 1, within = 0, share = 0.5;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  std::string note = {};  ///< of `arithmetic` and `none`: why
  /// What the control has to show before it says anything of a; without: nothing.
  std::vector<Claim> baseline = {};
};

/// What a study's questions are about: `world` in its file. online: drives; tours: over stops.
enum class ProblemKind { bitmap, polygon, arm, online, tours };

/// Runs of every contender: seeds `first` to `first` + `count` - 1.
inline constexpr int kMostSeeds = 100000;

struct Seeds {
  std::uint64_t first = 1;
  int count = 30;
};

struct Study {
  std::string name;
  std::string summary;
  std::string source;
  std::string text;  ///< what is ours: maps, readings of the text
  ProblemKind kind = ProblemKind::bitmap;
  std::string unit = "cells";
  Seeds seeds = {};  ///< by default
  std::vector<Experiment> experiments = {};
  std::vector<Claim> claims = {};
  std::string file = {};  ///< of a user; empty: the program holds it

  /// As `lasius study` takes it.
  const std::string& asked() const { return file.empty() ? name : file; }
  /// What a report is headed with.
  std::string title() const { return summary.empty() ? name : name + ": " + summary; }
};

}  // namespace lasius::study
