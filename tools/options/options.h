// What the command line asks for, as plain data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/params/params.h"
#include "lasius/tour/ants.h"

namespace lasius::tool {

enum class Frame { cell, world };
inline constexpr std::string_view kFrames[] = {"cell", "world"};  ///< their names
enum class ProgressMode { automatic, always, never };

/// What cells cost.
struct CostLayers {
  struct Layer {
    std::string file;
    double factor = 1;
    friend bool operator==(const Layer&, const Layer&) = default;
  };
  std::vector<Layer> layers;
  /// Radius, scaling, weight; lengths in the unit of MapOptions::radius.
  std::optional<std::array<double, 3>> inflation;
  bool eight_moves = false;  ///< walks of these, in place of paths of any angle
  bool proof = false;        ///< kept, to be written

  bool asked() const noexcept { return !layers.empty() || inflation || eight_moves; }
  friend bool operator==(const CostLayers&, const CostLayers&) = default;
};

/// How the map file becomes the grid that is planned on.
struct MapOptions {
  std::string file;
  bool unknown_is_free = false;
  double radius = 0;           ///< of the robot, a disc
  bool radius_metres = false;  ///< else cells; so a goal tolerance
  bool prepare = false;        ///< make the visibility graph
  bool labels = false;         ///< and hub labels of its vertices
  std::string prepared = {};   ///< file that keeps both; empty: none
  CostLayers costs = {};

  /// Says that nothing is prepared over costs, by the option that asked for it.
  std::string unprepared_note() const {
    return std::string(prepared.empty() ? "--prepare" : "--prepared") + " has no effect over costs";
  }
};

/// `--part I/N`: of the queries or runs those whose number, from 0, leaves I - 1 by N.
struct Part {
  static constexpr int kMost = 1'000'000;
  int number = 1;
  int of = 0;                ///< 0: undivided
  std::size_t whole = 0;     ///< how many queries all parts have
  std::string queries = {};  ///< hash of their file

  bool divided() const noexcept { return of > 0; }
  bool holds(std::size_t i) const noexcept { return !divided() || i % of == number - 1u; }
  /// The number among all of one that is the i-th here.
  std::size_t among_all(std::size_t i) const noexcept {
    return divided() ? i * of + (number - 1) : i;
  }
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
  /// All parameters of the algorithm as they were asked for, once they are made.
  std::map<std::string, std::string> asked;
  static constexpr int kMostSeeds = 100000;
  std::uint64_t seed = 1;
  int seeds = 1;        ///< runs of `plan` and `batch`, with `seed` and those after it
  bool ranged = false;  ///< seeds were given as a range, also of one
  Part part;            ///< of a batch
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

/// A start or goal on a bitmap, as it was given: cells, or metres in the world frame.
struct End : Point {
  bool point = false;  ///< the path goes there; else to the centre of the cell that holds it
};

/// A start or goal of a vehicle.
struct PoseEnd : End {
  double yaw = 0;  ///< radians, from +x towards +y of the frame in use
};

/// The options that `plan` and `batch` share on bitmaps.
struct RunOptions : SearchOptions {
  MapOptions map;
  Params params;
  Frame frame = Frame::cell;
  std::vector<int> track_iterations;  ///< of the pictures, rising, from 1; empty: the usual
  std::optional<double> spacing;      ///< of poses; as MapOptions::radius
  std::vector<End> via;               ///< on the way from start to goal, in order
  int alternatives = 0;               ///< other ways wanted
};

/// `plan` and `batch`.
struct PlanCommand {
  RunOptions run;
  End start, goal;
  std::string queries = {};  ///< of `batch`: a file, in place of these
};

/// `plan` and `batch` of a vehicle.
struct VehicleCommand {
  RunOptions run;
  std::string file = {};
  PoseEnd start = {};
  std::vector<PoseEnd> goals = {};  ///< at least one; one of them is met
  std::string queries = {};         ///< of `batch`: a file, in place of these
  double heading_tolerance = 0;     ///< radians; pi: any heading
  bool smooth = true;               ///< shorten what the search finds
};

struct DriveCommand : PlanCommand {
  static constexpr double kLeastSense = 1, kMostSense = 1e6;
  static constexpr std::int64_t kMostTicks = 1'000'000'000;

  std::string world = {};            ///< map of what is there; empty: as the map has it
  std::string changes = {};          ///< empty: none
  std::optional<double> sense = {};  ///< as MapOptions::radius
  std::int64_t max_ticks = 1'000'000;
  std::optional<VehicleCommand> vehicle =
      {};  ///< what drives, and from where to where; not its run
};

/// Stops of a tour, and what is given of their order. The lists are one entry a stop, or empty.
struct TourStops {
  std::vector<End> points = {};
  std::vector<std::string> names = {};       ///< empty text: without a name
  std::vector<std::vector<int>> after = {};  ///< stops that come before each
  std::vector<int> loads = {};
  std::vector<std::string> groups = {};          ///< of which one stop is visited; empty text: none
  std::vector<std::optional<double>> yaws = {};  ///< of a vehicle, as PoseEnd has them
  std::vector<std::string> notes = {};           ///< of what the file holds and is not read
};

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

struct TourCommand {
  static constexpr int kMostGenerations = 1'000'000;
  static constexpr int kMostLoad = 1'000'000;  ///< of a stop; of the capacity

  /// Its map may be a problem of TSPLIB, or a polygon world; its `params` are of legs.
  RunOptions run = {};
  WorldOptions world = {};    ///< a polygon world's
  tour::AntParams ants = {};  ///< who finds the order
  std::string stops_file = {};
  TourStops stops = {};  ///< without a file
  bool open = false;
  std::optional<int> capacity = {};
  std::optional<double> cover = {};  ///< a width, as MapOptions::radius; then there are no stops
  std::optional<PoseEnd> start = {}, goal = {};  ///< yaws of a vehicle alone
  std::vector<End> robots = {};                  ///< where each of several begins
  std::optional<int> most_stops = {};            ///< of a robot
  std::optional<VehicleCommand> vehicle = {};    ///< what drives; not its run and ends
  int generations = 20;
};

/// `study run`: a study without a file.
struct ShortStudy {
  std::string map;
  Point start, goal;  ///< as PlanCommand has them
  Frame frame = Frame::cell;
  double radius = 0;      ///< in the same unit
  CostLayers costs = {};  ///< likewise
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
  Part part = {};
  bool joined = false;  ///< its parts were: all runs are there
};

struct TuneCommand {
  std::string file;
  int threads = 1;
  std::string folder;  ///< of the report, the preset and the runs
  std::string maps;    ///< folder of the maps; empty: the program's own
  Messages messages = {};
};

/// Corners of grown obstacles, in the order of polygon::Join.
inline constexpr std::array<std::string_view, 4> kJoins{"mitre", "round", "bevel", "chords"};
/// What the margin does to the boundary, in the order of polygon::Boundary.
inline constexpr std::array<std::string_view, 2> kBoundaries{"shrink", "keep"};

/// `plan` and `batch` on a polygon world.
struct PolygonCommand : SearchOptions {
  WorldOptions world;
  std::optional<Point> start, goal;  ///< in place of the world's
  std::string queries = {};          ///< of `batch`: a file, in place of these
};

struct WorldInfoCommand {
  WorldOptions world;
  bool json = false;
};

}  // namespace lasius::tool
