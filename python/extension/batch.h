// Many questions at once: arrays in, arrays out, whatever the world.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lasius/plan/batch_options.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"

namespace lasius::python {

/// The answers by column; paths one after another, `offsets` telling where each begins.
class Columns {
 public:
  template <class Result>
  void add(const BatchAnswerOf<Result>& answer) {
    const Result& result = answer.result;
    index_.push_back(static_cast<std::int64_t>(answer.index));
    seeds_.push_back(answer.seed);
    status_.push_back(static_cast<std::int8_t>(result.status));
    lengths_.push_back(result.length);
    bounds_.push_back(result.lower_bound.value_or(std::numeric_limits<double>::quiet_NaN()));
    optimal_.push_back(result.optimal);
    iterations_.push_back(result.curves.iterations);
    seconds_.push_back(answer.elapsed.count());
    points_.insert(points_.end(), result.path.begin(), result.path.end());
    offsets_.push_back(static_cast<std::int64_t>(points_.size()));
    if (!result.error.empty()) errors_.emplace_back(index_.size() - 1, result.error);
  }
  std::size_t size() const noexcept { return index_.size(); }

  /// In the order of the fields of lasius.BatchResult.
  py::tuple arrays() const;

 private:
  std::vector<std::int64_t> index_, offsets_{0};
  std::vector<std::uint64_t> seeds_;
  std::vector<std::int8_t> status_;
  std::vector<double> lengths_, bounds_, seconds_;
  std::vector<std::uint8_t> optimal_;
  std::vector<int> iterations_;
  std::vector<Point> points_;
  std::vector<std::pair<std::size_t, std::string>> errors_;
};

/// Tells a callback how many answers there are, some times a second.
class Teller {
 public:
  Teller(Call& call, const py::object& callback) : call_(call), callback_(callback) {}
  void tell(std::size_t answers, bool last);

 private:
  Call& call_;
  const py::object& callback_;
  Clock::time_point next_ = Clock::time_point::min();
};

/// A request for each start and goal. @throws py::value_error unless there are as many of both.
template <class Request, class Place>
std::vector<Request> requests_from(const std::vector<Place>& starts,
                                   const std::vector<Place>& goals, double target_gap,
                                   double goal_tolerance = 0) {
  if (starts.size() != goals.size())
    throw py::value_error(std::to_string(starts.size()) + " starts and " +
                          std::to_string(goals.size()) + " goals: give as many of both");
  std::vector<Request> requests;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    requests.push_back({.start = starts[i], .goal = goals[i], .target_gap = target_gap});
    if constexpr (requires { requests.back().goal_tolerance; })
      requests.back().goal_tolerance = goal_tolerance;
  }
  return requests;
}

/// (error, arrays) of a batch of so many requests: plan(options, receive) is the plan_batch.
template <class Plan>
py::tuple run_batch(Call& call, std::size_t requests, int threads, int seeds,
                    std::optional<double> time_limit, const py::object& callback,
                    const Plan& plan) {
  BatchOptions options{.threads = threads, .token = call.condition().token, .seeds = seeds};
  if (time_limit) options.time_limit = std::chrono::duration<double>(*time_limit);
  const std::size_t wanted = requests * static_cast<std::size_t>(std::max(seeds, 1));
  Columns columns;
  Teller teller(call, callback);
  call.run_kept([&] {
    plan(options, [&](const auto& answer) {
      columns.add(answer);
      teller.tell(columns.size(), columns.size() == wanted);
    });
  });
  return py::make_tuple(call.error(), columns.arrays());
}

}  // namespace lasius::python
