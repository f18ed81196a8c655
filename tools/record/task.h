// A question to a planner, whatever the world: from reading its inputs to what is printed. One
// skeleton for all kinds of world; a kind derives from Task and adds what is its own.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "lasius/geometry.h"
#include "lasius/params.h"
#include "lasius/progress.h"
#include "lasius/search_result.h"
#include "lasius/stop.h"
#include "tools/options/options.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

inline constexpr const char* kPlanFormat = "lasius-plan/1";
inline constexpr const char* kArmFormat = "lasius-arm-plan/1";
inline constexpr const char* kDriveFormat = "lasius-drive/1";

/// One question. The first four functions are its life, called in their order; the others tell of
/// it, those of the result after plan(). A new kind of world is one class that writes the pure
/// ones, a line in worlds(), and a `recorded_...` function for `verify`.
class Task {
 public:
  /// Gets the world's own kind of Progress.
  using Watch = std::function<void(const Progress&)>;

  Task() = default;
  virtual ~Task();
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  /// Reads what may be ended at any moment, by the end of the program. @throws Error, UsageError
  virtual void open() {}
  /// Reads the rest and makes it ready; told to stop, it leaves that to plan() to say.
  virtual void load(const std::stop_token&) {}
  /// Says, unless all is to be quiet, what has no effect, and with -v what was read.
  virtual void announce() const;
  /// Plans, and does what was asked beside. `watch` may be empty.
  virtual void plan(const StopCondition& stop, const Watch& watch) = 0;

  // What was asked.
  virtual const SearchOptions& options() const = 0;
  /// Those to read, and once they are read those that they name.
  virtual std::vector<std::string> input_files() const = 0;
  virtual const Algorithm& algorithm() const = 0;
  virtual std::string parameter(std::string_view name) const = 0;  ///< its value
  virtual std::int64_t iterations() const = 0;                     ///< at most
  virtual bool iterates() const { return algorithm().has("iterations"); }

  // What came of it.
  virtual const SearchResult& result() const = 0;
  virtual std::string error() const { return result().error; }
  virtual std::optional<double> optimum() const { return {}; }  ///< found for --gap
  virtual double elapsed_ms() const = 0;
  bool has_path() const;
  /// What was asked for is there: else the exit code is that of no path.
  virtual bool found() const { return has_path(); }
  /// How far a run came that something ended, as in " after 7 iterations, no path yet".
  virtual std::string reached() const;

  // How it is shown. Lengths are in cells or the world's unit, unless `unit` says other.
  virtual double shown(double length) const { return length; }
  virtual std::string unit() const { return {}; }
  virtual std::string progress_note(const Progress& progress) const;
  /// Says what else people are to know, unless all is to be quiet.
  virtual void remark() const {}
  /// The path, a point a line.
  virtual void write_path(std::ostream& out, const char* between) const = 0;
  /// The convergence by iteration; the path for algorithms without iterations.
  virtual void write_csv(std::ostream& out) const;
  /// The motion for other programs; only for worlds whose outputs may end in .yaml.
  virtual void write_yaml(std::ostream&) const {}
  virtual void write_picture(const std::string& file) const = 0;
  /// Only for tasks whose outputs may end in .gif.
  virtual void write_film(std::ostream&) const {}
  /// Only for tasks whose outputs may end in .html.
  virtual void write_report(std::ostream&) const {}

  /// Its number, where it is a query of a batch.
  std::optional<std::size_t> index() const { return index_; }
  void set_index(std::size_t index) { index_ = index; }

  // What it adds to the JSON, in the order of the contract; Task writes the rest.
  virtual const char* format() const { return kPlanFormat; }
  virtual Json inputs() const = 0;                 ///< files by role, each with its name and hash
  virtual std::pair<Json, Json> ends() const = 0;  ///< start and goal
  /// Beside the algorithm's parameters: all that decides the result; add_limits is part of it.
  virtual void add_settings(Json& json) const = 0;
  /// What came of it, from "length" on.
  virtual void add_answer(Json& json) const;
  /// "path", and what goes with it.
  virtual void add_path(Json& json) const = 0;
  /// Between the curves and the bound: what the search took.
  virtual void add_effort(Json&) const {}
  /// At the end: what else was found.
  virtual void add_findings(Json&) const {}

 protected:
  /// With -v: what plans, and from which seed.
  void announce_algorithm(bool with_threads) const;
  void add_limits(Json& json) const;

 private:
  std::optional<std::size_t> index_;
};

/// Points as write_path gives them.
void write_points(std::ostream& out, const char* between, const std::vector<Point>& points);

/// The exit code of a run that is planned.
int exit_code(const Task& task);
/// One sentence for people: why a run has no path, or is not final; empty for `solved`.
std::string explain(const Task& task);

/// Runs a task: outputs are checked, inputs read, progress is shown, and what was asked for is
/// printed and written. The program's exit code.
int run(Task& task);

/// A result, keys in the order of the contract; and as a line of text.
Json result_json(const Task& task);
std::string json_line(const Task& task);

/// A result that is to be planned again.
struct Recorded {
  const Json& result;
  std::function<std::string(const std::string&)> found;  ///< where a file is that it names
  int threads = 1;
  std::string map = {};  ///< in place of the map that it names; empty: none

  std::string map_file() const;
};

/// The inputs of planning that all results record. @throws UsageError for what is missing.
void read_recorded(const Recorded& recorded, const Algorithm& algorithm, SearchOptions& options);

/// Plans a task again that was made from `recorded`. @throws Error or UsageError where inputs are
/// not usable, or are not those recorded.
Json replay(Task& task, const Recorded& recorded);

}  // namespace lasius::tool
