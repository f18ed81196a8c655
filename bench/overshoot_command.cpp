// lasius_bench overshoot: what plans go on doing when their time is up.
#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/base/stop.h"
#include "lasius/plan/planner.h"

namespace lasius::bench {
namespace {

struct OvershootOptions : Reported {
  MapOptions maps;
  std::vector<std::string> algorithms;
  int cuts = 1000;
  double limit = 10;  // ms
};

double milliseconds(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// The clock of one call on this thread. At each look it notes the processor time of the thread,
/// which when the deadline came was at least that of the last look before, and at least that of the
/// next look less the time in between: from there on it counts. So it says what the call has taken
/// at most, however seldom the call looks. (A thread that watched would wake late on a busy
/// machine, and count too little.)
class CallClock final : public TimeSource {
 public:
  explicit CallClock(double limit_ms)
      : deadline_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double, std::milli>(limit_ms))) {}

  Clock::time_point now() const noexcept override {
    const Clock::time_point now = Clock::now();
    if (passed_) return now;
    const double spent = 1e3 * processor_.seconds();
    passed_ = now >= deadline_;
    at_deadline_ = passed_ ? std::max(at_deadline_, spent - milliseconds(now - deadline_)) : spent;
    return now;
  }
  StopCondition condition() const { return {.deadline = deadline_, .time = this}; }

  /// Milliseconds past the deadline when the call has returned.
  struct Overshoot {
    double processor, wall;
  };
  /// Nothing if it has returned in time.
  std::optional<Overshoot> overshoot() const {
    const Clock::time_point end = now();
    if (end < deadline_) return std::nullopt;
    return Overshoot{1e3 * processor_.seconds() - at_deadline_, milliseconds(end - deadline_)};
  }

 private:
  Clock::time_point deadline_;
  ThreadStopwatch processor_;
  mutable double at_deadline_ = 0;
  mutable bool passed_ = false;
};

class Overshoots {
 public:
  void add(const CallClock& clock) {
    const auto overshoot = clock.overshoot();
    if (!overshoot) return;
    processor_.push_back(overshoot->processor);
    wall_.push_back(overshoot->wall);
  }
  /// The row of a map and what ran on it; `more` is its last cell.
  std::vector<std::string> row(const std::string& map, const std::string& what,
                               const std::string& more) const {
    std::vector<std::string> cells{map, what, std::to_string(wall_.size())};
    for (const auto* values : {&processor_, &wall_})
      for (const double share : {0.5, 0.999, 1.0})
        cells.push_back(values->empty() ? "-" : short_number(quantile(*values, share)));
    cells.push_back(more);
    return cells;
  }

 private:
  std::vector<double> processor_, wall_;
};

/// Cuts calls of `run` short, at random, with `before` before each.
Overshoots cut_short(const OvershootOptions& options, const std::function<void()>& before,
                     const std::function<void(int, const StopCondition&)>& run) {
  std::mt19937_64 random(options.maps.seed);
  std::uniform_real_distribution<> limit(0, options.limit);
  Overshoots overshoots;
  for (int i = 0; i < options.cuts; ++i) {
    before();
    const CallClock clock(limit(random));
    run(i, clock.condition());
    overshoots.add(clock);
  }
  return overshoots;
}

/// What the machine does to a loop that only looks at the clock.
std::vector<std::string> timer_row(const OvershootOptions& options) {
  const auto wait = [](int, const StopCondition& stop) {
    while (stop.poll() == StopCondition::Cause::none) continue;
  };
  return cut_short(
             options, [] {}, wait)
      .row("", "a loop that looks at the clock", "");
}

/// One algorithm, in one workspace or in a fresh one each time, whose end is not counted.
std::vector<std::string> algorithm_row(const OvershootOptions& options, const Planner& planner,
                                       const QuerySet& set, const std::string& algorithm,
                                       bool reused) {
  Params params(algorithm);
  params.threads = 1;
  if (find_algorithm(algorithm).has("iterations")) params.iterations = 1'000'000;
  std::optional<Workspace> workspace(std::in_place);
  std::int64_t most_bytes = 0;
  const auto before = [&] {
    most_bytes = std::max(most_bytes, workspace->bytes());
    if (!reused) workspace.emplace();
  };
  const auto plan = [&](int i, const StopCondition& stop) {
    const Query& query = set.queries[static_cast<std::size_t>(i) % set.queries.size()];
    params.seed = static_cast<std::uint64_t>(i) + 1;
    planner.plan({.start = query.start, .goal = query.goal, .stop = stop}, params,
                 {.workspace = &*workspace});
  };
  const Overshoots overshoots = cut_short(options, before, plan);
  before();
  return overshoots.row(set.name, "`" + algorithm + "`, " + (reused ? "one" : "fresh"),
                        short_number(static_cast<double>(most_bytes) / 1e6));
}

void run_overshoot(const OvershootOptions& options) {
  constexpr auto kText = Table::Align::left;
  Table table(
      std::to_string(options.cuts) + " limits of up to " + short_number(options.limit) +
          " ms, one thread; milliseconds past the limit, of those that were passed. Aim: at "
          "most 5 ms of processor time.",
      {"map",
       {"algorithm, workspace", kText},
       "passed",
       "processor, median",
       "99.9%",
       "worst",
       "wall clock, median",
       "99.9%",
       "worst",
       "workspace, MB"},
      options.markdown);
  for (const QuerySource& source :
       sources_of(or_generated(options.maps, {512, 2048, 8192, 16384}, {"blobs"}))) {
    const QuerySet set = load(source, 100);
    const Planner planner(set.grid);
    table.row(timer_row(options));
    for (const std::string& algorithm : options.algorithms) {
      for (const bool reused : {false, true}) {
        table.row(algorithm_row(options, planner, set, algorithm, reused));
      }
    }
  }
}

}  // namespace

void add_overshoot_command(CLI::App& app) {
  const auto [command, options] = add_command(
      app, "overshoot", "What plans go on doing when their time is up; on blobs if not told",
      run_overshoot);
  for (const Algorithm& algorithm : algorithms()) options.algorithms.emplace_back(algorithm.name);
  add_map_options(command, options.maps);
  command.add_option("--algorithms", options.algorithms, "Only these")
      ->delimiter(',')
      ->check(CLI::IsMember(options.algorithms));
  add_number(command, "--cuts", options.cuts, "Plans of each algorithm and map", 1, 1000000);
  add_number(command, "--limit", options.limit, "Longest time limit, ms", 0.1, 1e6);
}

}  // namespace lasius::bench
