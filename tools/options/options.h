// What the command line asks for, as plain data.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lasius/generate.h"
#include "lasius/geometry.h"
#include "lasius/params.h"

namespace lasius::tool {

enum class Frame { cell, world };
inline constexpr std::string_view kFrames[] = {"cell", "world"};  ///< their names
enum class ProgressMode { automatic, always, never };

/// How the map file becomes the grid that is planned on.
struct MapOptions {
  std::string file;
  bool unknown_is_free = false;
  double radius = 0;           ///< obstacles grow by it
  bool radius_metres = false;  ///< else cells
  bool prepare = false;        ///< make the visibility graph
  int threads = 1;             ///< that make it
};

/// How much is said on stderr.
struct Messages {
  ProgressMode progress = ProgressMode::automatic;
  bool quiet = false;
  bool verbose = false;
};

/// The options of every command that plans.
struct SearchOptions {
  std::string algorithm;                                   ///< empty: the world's first
  std::vector<std::pair<std::string, std::string>> named;  ///< parameters with their own option
  std::vector<std::string> settings;                       ///< NAME=VALUE
  std::uint64_t seed = 1;
  int threads = 1;
  double target_gap = 0;             ///< fraction
  std::optional<double> time_limit;  ///< seconds
  bool with_optimum = false;
  bool json = false;
  std::vector<std::string> outputs;
  Messages messages;
  std::vector<std::string> notes;  ///< what was asked for and has no effect
};

/// The options that `plan` and `batch` share on bitmaps.
struct RunOptions : SearchOptions {
  MapOptions map;
  Params params;
  Frame frame = Frame::cell;
  std::vector<int> track_iterations;  ///< of the pictures, rising, from 1
};

struct PlanCommand {
  RunOptions run;
  Point start, goal;  ///< cells, or metres in the world frame
};

struct BatchCommand {
  RunOptions run;
  std::string queries;
};

struct InfoCommand {
  MapOptions map;
  Corners corners = Corners::forbid;
  bool json = false;
};

struct AlgorithmsCommand {
  bool json = false;
};

struct GenerateCommand {
  MapKind kind{};
  GenerateOptions options;
  std::string output;
};

struct VerifyCommand {
  std::string result;
  std::string map;  ///< empty: the one that the result names
  int threads = 1;
  bool quiet = false;
};

struct StudyCommand {
  std::string name;  ///< or "list"
  int seeds = 30;
  int threads = 1;
  std::string folder;  ///< of the report and its runs
  std::string maps;    ///< folder of the maps; empty: the program's own
  Messages messages = {};
};

struct ArmCommand : SearchOptions {
  static constexpr double kLeastClearance = 1e-6, kMostClearance = 1;
  static constexpr double kLeastRate = 1e-3, kMostRate = 1e5;
  static constexpr int kMostRecheck = 1000000;

  std::string robot;
  std::string base_link, tip_link;  ///< of a URDF's chain; empty: the root, the only leaf
  std::string scene;
  std::vector<double> start;  ///< a value for each joint
  std::array<double, 3> goal{};
  double clearance = 0;  ///< metres; 0: the sensor's own
  double rate = 100;     ///< samples of the trajectory a second
  int recheck = 0;       ///< samples of the independent check
};

/// Corners of grown obstacles, in the order of polygon::Join.
inline constexpr std::array<std::string_view, 3> kJoins{"mitre", "round", "bevel"};

/// A polygon world, and what the command line says in place of what it holds.
struct WorldOptions {
  static constexpr double kMostMargin = 1e12;  ///< as polygon::GrowOptions has it
  std::string file;
  bool repair = false;
  std::optional<double> margin;
  int join = 0;  ///< index in kJoins
};

/// `plan` on a polygon world.
struct PolygonCommand : SearchOptions {
  WorldOptions world;
  std::optional<Point> start, goal;  ///< in place of the world's
};

struct WorldInfoCommand {
  WorldOptions world;
  bool json = false;
};

/// Text that was asked for, as by --help: printed on stdout.
struct Text {
  std::string text;
};

using Command =
    std::variant<Text, PlanCommand, BatchCommand, InfoCommand, AlgorithmsCommand, GenerateCommand,
                 VerifyCommand, StudyCommand, ArmCommand, PolygonCommand, WorldInfoCommand>;

}  // namespace lasius::tool
