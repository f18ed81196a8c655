// Many questions at once: arrays in, arrays out.
#include "lasius/batch.h"

#include <chrono>

#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/own_rules.h"

namespace lasius::python {
namespace {

/// The answers by column; paths one after another, `offsets` telling where each begins.
class Columns {
 public:
  explicit Columns(std::size_t answers) {
    for (auto* column : {&lengths_, &bounds_, &seconds_}) column->reserve(answers);
    offsets_.reserve(answers + 1);
    offsets_.push_back(0);
  }

  void add(const BatchAnswer& answer) {
    const Result& result = answer.result;
    index_.push_back(static_cast<std::int64_t>(answer.index));
    seeds_.push_back(answer.seed);
    status_.push_back(static_cast<std::int8_t>(result.status));
    lengths_.push_back(result.length);
    bounds_.push_back(result.lower_bound.value_or(std::numeric_limits<double>::quiet_NaN()));
    optimal_.push_back(result.optimal);
    iterations_.push_back(result.iterations);
    seconds_.push_back(answer.elapsed.count());
    points_.insert(points_.end(), result.path.begin(), result.path.end());
    offsets_.push_back(static_cast<std::int64_t>(points_.size()));
    if (!result.error.empty()) errors_.emplace_back(index_.size() - 1, result.error);
  }
  std::size_t size() const noexcept { return index_.size(); }

  /// In the order of the fields of lasius.BatchResult.
  py::tuple arrays() const {
    return py::make_tuple(to_array(index_), to_array(seeds_), to_array(status_), to_array(lengths_),
                          to_array(bounds_), to_array(optimal_), to_array(iterations_),
                          to_array(seconds_), to_array(std::span(points_)), to_array(offsets_),
                          errors());
  }

 private:
  py::dict errors() const {
    py::dict sentences;
    for (const auto& [row, sentence] : errors_) sentences[py::int_(row)] = sentence;
    return sentences;
  }

  std::vector<std::int64_t> index_, offsets_;
  std::vector<std::uint64_t> seeds_;
  std::vector<std::int8_t> status_;
  std::vector<double> lengths_, bounds_, seconds_;
  std::vector<std::uint8_t> optimal_;
  std::vector<int> iterations_;
  std::vector<Point> points_;
  std::vector<std::pair<std::size_t, std::string>> errors_;
};

std::vector<Request> requests_from(const IntRows& starts, const IntRows& goals, double target_gap) {
  const auto from = cells_from(starts, "starts");
  const auto to = cells_from(goals, "goals");
  if (from.size() != to.size())
    throw py::value_error(std::to_string(from.size()) + " starts and " + std::to_string(to.size()) +
                          " goals: give as many of both");
  std::vector<Request> requests;
  requests.reserve(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    requests.push_back({from[i], to[i]});
    requests.back().target_gap = target_gap;
  }
  return requests;
}

/// Tells a callback how many answers there are, some times a second.
class Teller {
 public:
  Teller(Call& call, const py::object& callback) : call_(call), callback_(callback) {}

  void tell(std::size_t answers, bool last) {
    const auto now = Clock::now();
    if (callback_.is_none() || (now < next_ && !last)) return;
    next_ = now + std::chrono::milliseconds(100);
    call_.call_back([&] { callback_(answers); });
  }

 private:
  Call& call_;
  const py::object& callback_;
  Clock::time_point next_ = Clock::time_point::min();
};

py::tuple batch(const Planner& planner, const IntRows& starts, const IntRows& goals,
                const Params& params, int threads, int seeds, std::optional<double> time_limit,
                double target_gap, const py::object& callback, const OwnTable& heuristic,
                const py::object& update, const py::object& schedule) {
  Call call;
  const Given given{heuristic, update, schedule};
  const OwnRules own = own_rules(given, params, call);
  const auto requests = requests_from(starts, goals, target_gap);
  BatchOptions options{
      .threads = threads, .token = call.condition().token, .seeds = seeds, .own_rules = &own};
  if (time_limit) options.time_limit = std::chrono::duration<double>(*time_limit);
  const std::size_t wanted = requests.size() * static_cast<std::size_t>(std::max(seeds, 1));
  Columns columns(requests.size());
  Teller teller(call, callback);
  call.run_kept([&] {
    plan_batch(planner, requests, params, options, [&](const BatchAnswer& answer) {
      columns.add(answer);
      teller.tell(columns.size(), columns.size() == wanted);
    });
  });
  return py::make_tuple(call.error(), columns.arrays());
}

}  // namespace

void bind_batch(py::module_& module) {
  py::list names;  // of the values of the column `status`
  for (int i = 0; i <= static_cast<int>(Status::invalid); ++i)
    names.append(text(to_string(static_cast<Status>(i))));
  module.attr("status_names") = names;
  module.def("batch", &batch);
}

}  // namespace lasius::python
