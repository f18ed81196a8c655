// What the command line asks for, as plain data.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lasius/generate.h"
#include "lasius/geometry.h"
#include "lasius/params.h"
#include "tools/options/manual.h"

namespace lasius::tool {

enum class Frame { cell, world };
inline constexpr std::string_view kFrames[] = {"cell", "world"};  ///< their names
enum class ProgressMode { automatic, always, never };

/// How the map file becomes the grid that is planned on.
struct MapOptions {
  std::string file;
  bool unknown_is_free = false;
  double radius = 0;           ///< of the robot, a disc
  bool radius_metres = false;  ///< else cells; so a goal tolerance
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
  std::string algorithm;          ///< empty: the world's first
  Preset preset = Preset::usual;  ///< of a colony on bitmaps
  std::string preset_file;        ///< empty: none
  /// Of that file, before all others.
  std::vector<std::pair<std::string, std::string>> preset_settings;
  std::vector<std::pair<std::string, std::string>> named;  ///< parameters with their own option
  std::vector<std::string> settings;                       ///< NAME=VALUE
  static constexpr int kMostSeeds = 100000;
  std::uint64_t seed = 1;
  int seeds = 1;        ///< runs of `plan` and `batch`, with `seed` and those after it
  bool ranged = false;  ///< seeds were given as a range, also of one
  int threads = 1;
  double target_gap = 0;             ///< fraction
  double goal_tolerance = 0;         ///< in the world's unit; of a bitmap as MapOptions::radius
  std::optional<double> time_limit;  ///< seconds
  bool with_optimum = false;
  bool json = false;
  std::vector<std::string> outputs;
  Messages messages;
  std::vector<std::string> inputs;  ///< files to read, and once they are read those that they name
  std::vector<std::string> notes;   ///< what was asked for and has no effect; with -v what was read
  std::string called;               ///< the command line, for a shell to read
};

/// The options that `plan` and `batch` share on bitmaps.
struct RunOptions : SearchOptions {
  MapOptions map;
  Params params;
  Frame frame = Frame::cell;
  std::vector<int> track_iterations;  ///< of the pictures, rising, from 1; empty: the usual
};

struct PlanCommand {
  RunOptions run;
  Point start, goal;  ///< cells, or metres in the world frame
};

struct DriveCommand : PlanCommand {
  static constexpr double kLeastSense = 1, kMostSense = 1e6;
  static constexpr std::int64_t kMostTicks = 1'000'000'000;

  std::string world = {};            ///< map of what is there; empty: as the map has it
  std::string changes = {};          ///< empty: none
  std::optional<double> sense = {};  ///< as MapOptions::radius
  std::int64_t max_ticks = 1'000'000;
};

/// `batch`; or `plan` with several seeds.
struct BatchCommand {
  RunOptions run;
  std::string queries;    ///< a file; empty: the one query of `plan`
  Point start{}, goal{};  ///< of that
};

struct InfoCommand {
  MapOptions map;
  Frame frame = Frame::cell;
  std::optional<Point> start, goal;  ///< both or none
  Corners corners = Corners::forbid;
  bool json = false;
};

struct AlgorithmsCommand {
  std::string name;  ///< the only one listed; empty: all
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

/// `study run`: a study without a file.
struct ShortStudy {
  std::string map;
  Point start, goal;  ///< as PlanCommand has them
  Frame frame = Frame::cell;
  double radius = 0;  ///< in the same unit
  std::vector<std::string> algorithms;
  std::string preset;  ///< usual, book or a file; empty: usual
  /// Parameters, each with the values that are swept.
  std::vector<std::pair<std::string, std::vector<std::string>>> factors;
  std::optional<double> steps, seconds;  ///< budget of a run
};

struct StudyCommand {
  std::string name;              ///< of one that the program holds, "list", "all", "run", or a file
  std::uint64_t first_seed = 1;  ///< of the runs, where `seeds` is not 0
  int seeds = 0;                 ///< so many; 0: the study's own
  int threads = 1;
  std::string folder;  ///< of the report and its runs
  std::string maps;    ///< folder of the maps; empty: the program's own
  Messages messages = {};
  ShortStudy run = {};      ///< of "run"
  std::string called = {};  ///< as SearchOptions::called
  std::string page = {};    ///< file of the report's page; empty: report.html in `folder`
};

struct TuneCommand {
  std::string file;
  int threads = 1;
  std::string folder;  ///< of the report, the preset and the runs
  std::string maps;    ///< folder of the maps; empty: the program's own
  Messages messages = {};
};

/// What an arm is to reach.
struct ArmGoal {
  enum class Kind { position, pose, joints };
  Kind kind = Kind::position;
  std::vector<double> values;  ///< x, y, z; and roll, pitch, yaw; or a value for each joint
  std::string state;           ///< name of the joint values; empty: `values` says them
};
inline constexpr std::array<std::string_view, 3> kGoalKinds{"position", "pose", "joints"};

struct ArmCommand : SearchOptions {
  static constexpr double kLeastClearance = 1e-6, kMostClearance = 1;
  static constexpr double kLeastRate = 1e-3, kMostRate = 1e5;
  static constexpr double kLeastDuration = 1e-3, kMostDuration = 1e6;
  static constexpr double kLeastTolerance = 1e-7, kMostTolerance = 10;
  static constexpr int kMostRecheck = 1000000;

  std::string robot;
  std::string base_link, tip_link;  ///< of a URDF's chain; empty: the root, the only leaf
  std::string srdf, joint_limits;   ///< files; empty: none
  std::map<std::string, std::string> packages;                ///< their folders by name
  std::vector<std::pair<std::string, std::string>> contacts;  ///< links that may touch
  std::map<std::string, double> joint_values;                 ///< of joints beside the chain
  bool visual = false;    ///< visual geometry stands for collision geometry that is missing
  bool bodiless = false;  ///< a robot without any body will do
  std::string scene;
  std::vector<double> start;  ///< a value for each joint
  std::string start_state;    ///< their name; empty: `start` says them
  std::vector<ArmGoal> goals;
  double position_tolerance = kLeastTolerance;  ///< metres, of poses
  double angle_tolerance = kLeastTolerance;     ///< radians, likewise
  double clearance = 0;                         ///< metres; 0: the sensor's own
  double duration = 0;                          ///< seconds; 0: as few as the limits allow
  double rate = 100;                            ///< samples of the trajectory a second
  int recheck = 0;                              ///< samples of the independent check
};

/// Corners of grown obstacles, in the order of polygon::Join.
inline constexpr std::array<std::string_view, 4> kJoins{"mitre", "round", "bevel", "chords"};
/// What the margin does to the boundary, in the order of polygon::Boundary.
inline constexpr std::array<std::string_view, 2> kBoundaries{"shrink", "keep"};

/// A polygon world, and what the command line says in place of what it holds.
struct WorldOptions {
  static constexpr double kMostMargin = 1e12;  ///< as polygon::GrowOptions has it
  std::string file;
  bool repair = false;
  std::optional<double> margin;
  int join = 1;      ///< index in kJoins
  int boundary = 0;  ///< index in kBoundaries
  friend bool operator==(const WorldOptions&, const WorldOptions&) = default;
};

/// `plan` on a polygon world.
struct PolygonCommand : SearchOptions {
  WorldOptions world;
  std::optional<Point> start, goal;  ///< in place of the world's
};

/// `batch` on a polygon world.
struct PolygonBatchCommand {
  PolygonCommand plan;
  std::string queries;  ///< a file; empty: the one that `plan` asks
};

struct WorldInfoCommand {
  WorldOptions world;
  bool json = false;
};

/// Text that was asked for, as by --version: printed on stdout.
struct Text {
  std::string text;
};

using Command = std::variant<Text, PlanCommand, DriveCommand, BatchCommand, InfoCommand,
                             AlgorithmsCommand, GenerateCommand, VerifyCommand, StudyCommand,
                             TuneCommand, ArmCommand, PolygonCommand, PolygonBatchCommand,
                             WorldInfoCommand, HelpCommand, CompleteCommand>;

}  // namespace lasius::tool
