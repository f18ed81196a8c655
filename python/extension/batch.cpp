#include "python/extension/batch.h"

#include "lasius/plan/batch.h"
#include "python/extension/modules.h"
#include "python/extension/own_rules.h"

namespace lasius::python {

py::tuple Columns::arrays() const {
  py::dict errors;
  for (const auto& [row, sentence] : errors_) errors[py::int_(row)] = sentence;
  return py::make_tuple(to_array(index_), to_array(seeds_), to_array(status_), to_array(lengths_),
                        to_array(bounds_), to_array(optimal_), to_array(iterations_),
                        to_array(seconds_), to_array(std::span(points_)), to_array(offsets_),
                        errors);
}

void Teller::tell(std::size_t answers, bool last) {
  const auto now = Clock::now();
  if (callback_.is_none() || (now < next_ && !last)) return;
  next_ = now + std::chrono::milliseconds(100);
  call_.call_back([&] { callback_(answers); });
}

namespace {

py::tuple batch(const Planner& planner, const IntRows& starts, const IntRows& goals,
                const Params& params, int threads, int seeds, std::optional<double> time_limit,
                double target_gap, double goal_tolerance, const py::object& callback,
                const OwnTable& heuristic, const py::object& update, const py::object& schedule) {
  Call call;
  const Given given{heuristic, update, schedule};
  const OwnRules own = own_rules(given, params, call);
  const auto requests = requests_from<Request>(
      cells_from(starts, "starts"), cells_from(goals, "goals"), target_gap, goal_tolerance);
  return run_batch(call, requests.size(), threads, seeds, time_limit, callback,
                   [&](const BatchOptions& options, const BatchReceiver& receive) {
                     plan_batch(planner, requests, params, options, receive, own);
                   });
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
