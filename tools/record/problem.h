// A question to a planner, whatever its kind: from reading its inputs to what is printed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "lasius/base/stop.h"
#include "lasius/params/params.h"
#include "tools/options/options.h"
#include "tools/record/outputs.h"
#include "tools/record/record.h"

namespace lasius::tool {

/// One question of one kind. Its functions are called in their order.
class Problem {
 public:
  /// Told how much is done, and a note on it.
  using Watch = std::function<void(std::int64_t done, const std::string& note)>;

  Problem() = default;
  virtual ~Problem();
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  /// Reads its inputs, and makes them ready unless told to stop. Notes in the options what has no
  /// effect and, with -v, what was read, and the files that inputs name. What it reads without a
  /// look at the token a signal is to end at once (EndAtOnce).
  /// @return the iterations at most, of an algorithm that has any. @throws Error, UsageError
  virtual std::optional<std::int64_t> read(const std::stop_token& token) = 0;
  /// Plans, and does what was asked beside. `watch` may be empty.
  virtual void plan(const StopCondition& stop, const Watch& watch) = 0;
  virtual Record record() const = 0;
  /// The forms of its files. JSON is of all kinds alike, and so is the table that has no form here.
  virtual Forms show(const Record& run) const = 0;
  virtual SearchOptions& options() = 0;  ///< of its command
};

/// One whose command is, or has in `run`, its options.
template <class Command>
class ProblemOf : public Problem {
 public:
  explicit ProblemOf(Command command) : command_(std::move(command)) {}
  SearchOptions& options() final {
    if constexpr (requires { command_.run; })
      return command_.run;
    else
      return command_;
  }

 protected:
  Command command_;
};

/// Runs a question: outputs are checked, inputs read, progress is shown, and what was asked for is
/// printed and written. The program's exit code.
int run(Problem& problem);

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

/// Plans a question again that was made of `recorded`. @throws Error or UsageError where inputs are
/// not usable, or are not those recorded.
Json replay(Problem& problem, const Recorded& recorded);

}  // namespace lasius::tool
