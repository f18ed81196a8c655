#include "core/plan/alternatives.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/special_values.h"
#include "core/exact/alternatives.h"
#include "core/grid/grid_view.h"
#include "core/loop/run_status.h"
#include "lasius/path/path.h"

namespace lasius {

void check_alternatives(const Request& request, const Algorithm& algorithm, Disc robot) {
  const int count = request.alternatives;
  if (count == 0) return;  // and nothing is allocated
  require_parameter(count >= 0 && count <= Request::kMostAlternatives, "alternatives", count,
                    "it must be 0 to " + std::to_string(Request::kMostAlternatives));
  const auto refuse = [](const std::string& why, const std::string& remedy) {
    throw invalid_parameter("alternatives are asked for " + why, remedy);
  };
  if (algorithm.kind != Algorithm::Kind::exact)
    refuse("of " + std::string(algorithm.name), "ask exact: they are ways beside a shortest path");
  if (robot.radius != 0)
    refuse("of a disc", "plan for a point: there are no alternatives to a disc's curve");
  if (request.target_gap > 0)
    refuse("with a target gap", "leave it 0: they are ways beside a path that is proven shortest");
  if (!request.via.empty())
    refuse("of a path through points", "ask for those of each part, from one point to the next");
}

void add_alternatives(const PlanningMap& map, const Request& request, const Places& places,
                      WorkspaceMemory& memory, Result& result) {
  if (places.from == places.to) return;
  const auto row = [&](Point from, Point to, exact::TautRow& corners) {
    const double bound = exact::kMostDetour * result.length;
    return map.graph != nullptr
               ? memory.prepared.row(map.grid, *map.graph, from, to, bound, request.stop, corners)
               : memory.exact.row(map.grid, from, to, bound, request.stop, corners);
  };
  bool stopped = false;
  const auto shortest = [&](Point from, Point to) {
    ExactAnswer& answer = memory.exact_answer;
    if (map.graph != nullptr)
      memory.prepared.search(map.grid, *map.graph, from, to, {}, request.stop, answer);
    else
      memory.exact.search(map.grid, from, to, {}, request.stop, answer);
    stopped = stopped || answer.end != ExactEnd::proven;
    return stopped ? kInfinity : answer.length;
  };
  exact::TautRow out, back;
  Poller poller(request.stop);
  stopped = row(places.from, places.to, out) || row(places.to, places.from, back);
  if (!stopped) {
    const kernels::BitmapView view = view_of(map.grid);
    for (auto& path : exact::alternatives(view, out, back, result.path, request.alternatives,
                                          shortest, poller)) {
      if (const auto fault = path_fault(map.grid, path))
        throw std::logic_error("an alternative is not valid: " + *fault);
      const double length = path_length(path);
      result.alternatives.push_back({std::move(path), length});
    }
  }
  if (stopped || poller.stopped()) end_run(result, request.stop.poll(), Status::solved);
}

}  // namespace lasius
