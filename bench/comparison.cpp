#include "bench/comparison.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "bench/clocks.h"
#include "bench/statistics.h"
#include "lasius/path/path.h"

namespace lasius::bench {
namespace {

std::string fault_of(const Grid& grid, const Query& query, const std::vector<Point>& path,
                     double length) {
  if (path.empty()) return "no path";
  if (path.front() != centre(query.start) || path.back() != centre(query.goal)) {
    return "the path does not join start and goal";
  }
  if (std::abs(path_length(path) - length) > 1e-6 * std::max(1.0, length)) {
    return "the length is not the path's";
  }
  return path_fault(grid, path).value_or("");
}

// A planner with what it has spent and found on this map.
struct Contender {
  std::unique_ptr<peers::QueryPlanner> planner;
  double spent = 0;  // microseconds
  std::vector<std::vector<double>> times;
};

constexpr double kLengthy = 50;  // microseconds

// Microseconds and length of one query.
template <typename Watch>
std::pair<double, double> timed(peers::QueryPlanner& planner, const Query& query,
                                std::vector<Point>& path) {
  const Watch watch;
  const double length = planner.plan(query.start, query.goal, path);
  return {1e6 * watch.seconds(), length};
}

void run_round(const QuerySet& set, Contender& contender, PlannerRun& run) {
  std::vector<Point> path;
  for (std::size_t q = 0; q < set.queries.size(); ++q) {
    const Query& query = set.queries[q];
    // A query that other programs interrupt counts the processor time that it used. Reading that
    // clock disturbs very short ones, which are hardly ever interrupted.
    const bool lengthy = !contender.times[q].empty() && contender.times[q].back() > kLengthy;
    const auto [elapsed, length] = lengthy ? timed<ThreadStopwatch>(*contender.planner, query, path)
                                           : timed<Stopwatch>(*contender.planner, query, path);
    contender.spent += elapsed;
    contender.times[q].push_back(elapsed);
    Measurement& m = run.queries[q];
    m.length = length;
    if (++m.rounds == 1) m.fault = fault_of(set.grid, query, path, length);
  }
}

// Fills in the optima that the table does not give, and holds the lengths against them.
void judge(const QuerySet& set, std::span<const peers::Peer> planners, MapComparison& result) {
  for (std::size_t q = 0; q < set.queries.size(); ++q) {
    double optimum = set.queries[q].optimum;
    for (std::size_t p = 0; p < planners.size() && std::isnan(optimum); ++p) {
      const Measurement& m = result.planners[p].queries[q];
      if (planners[p].optimality == peers::Optimality::any_angle && m.fault.empty()) {
        optimum = m.length;
      }
    }
    result.optima.push_back(optimum);
    if (std::isnan(optimum)) continue;
    for (std::size_t p = 0; p < planners.size(); ++p) {
      Measurement& m = result.planners[p].queries[q];
      if (!m.fault.empty()) continue;
      const double gap = (m.length - optimum) / std::max(1.0, optimum);
      if (gap < -1e-6) m.fault = "shorter than the optimum";
      if (gap > 1e-6 && planners[p].optimality == peers::Optimality::any_angle) {
        m.fault = "longer than the optimum";
      }
    }
  }
}

}  // namespace

double PlannerRun::mean_microseconds() const {
  double sum = 0;
  for (const Measurement& m : queries) sum += m.microseconds;
  return sum / static_cast<double>(queries.size());
}

double PlannerRun::median_microseconds() const {
  std::vector<double> values;
  for (const Measurement& m : queries) values.push_back(m.microseconds);
  return median(values);
}

double MapComparison::mean_gap(std::size_t planner) const {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t q = 0; q < optima.size(); ++q) {
    const Measurement& m = planners[planner].queries[q];
    if (std::isnan(optima[q]) || optima[q] == 0 || !std::isfinite(m.length)) continue;
    sum += std::max(0.0, (m.length - optima[q]) / optima[q]);
    ++count;
  }
  return count == 0 ? kUnknown : sum / static_cast<double>(count);
}

MapComparison compare(const QuerySet& set, std::span<const peers::Peer> planners,
                      const ComparisonOptions& options) {
  MapComparison result{set.name, {}, {}};
  result.planners.resize(planners.size());
  std::vector<Contender> contenders(planners.size());
  for (std::size_t p = 0; p < planners.size(); ++p) {
    const Stopwatch watch;
    contenders[p].planner = planners[p].make(set.grid);
    result.planners[p].preparation_ms = 1000 * watch.seconds();
    result.planners[p].prepared_bytes = contenders[p].planner->prepared_bytes();
    result.planners[p].queries.resize(set.queries.size());
    contenders[p].times.resize(set.queries.size());
  }
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t i = 0; i < planners.size(); ++i) {
      const std::size_t p = (i + static_cast<std::size_t>(round)) % planners.size();
      if (round > 0 && contenders[p].spent > 1e6 * options.seconds) continue;
      run_round(set, contenders[p], result.planners[p]);
    }
  }
  for (std::size_t p = 0; p < planners.size(); ++p) {
    for (std::size_t q = 0; q < set.queries.size(); ++q) {
      result.planners[p].queries[q].microseconds = median(contenders[p].times[q]);
    }
  }
  judge(set, planners, result);
  return result;
}

}  // namespace lasius::bench
