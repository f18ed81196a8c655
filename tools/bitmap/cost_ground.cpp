#include "tools/bitmap/cost_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "tools/bitmap/level_lines.h"
#include "tools/console/elapsed.h"
#include "tools/draw/axes.h"
#include "tools/draw/colours.h"
#include "tools/report/packed.h"

namespace lasius::tool {
namespace {

constexpr Colour kCosts[] = {{1, 1, 1}, {1, 0.94, 0.74}, {0.99, 0.77, 0.5}, {0.85, 0.5, 0.42}};
constexpr int kLevelLines = 24;

/// The mean weight of the free cells; NaN: there is none.
double mean_weight(const CostField& costs, const Grid& map, Span columns, Span rows) {
  double sum = 0;
  int free = 0;
  for (int y = rows.from; y < rows.to; ++y) {
    for (int x = columns.from; x < columns.to; ++x) {
      if (map.blocked({x, y})) continue;
      sum += costs.weight({x, y});
      ++free;
    }
  }
  return free > 0 ? sum / free : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ColourScale cost_scale(const CostField& costs, const Grid& map) {
  const auto [least, most] = costs.range(map);
  return {{least, most}, most > 10 * least, kCosts};
}

Colour cost_ground(const CostField& costs, const Grid& map, const ColourScale& scale, Span columns,
                   Span rows) {
  const double weight = mean_weight(costs, map, columns, rows);
  return weight == weight ? scale.at(weight) : kFree;
}

std::shared_ptr<const CostProof> shown_proof(const LoadedMap& map, const RunOptions& run,
                                             const Answer& answer, const StopCondition& stop) {
  const auto& found = answer.over_costs;
  if (!found || found->path.empty() || !run.via.empty()) return nullptr;
  if (found->proof) return found->proof;
  const Request request{.start = answer.start.cell,
                        .goal = found->goal_reached.value_or(answer.goal.cell),
                        .stop = again(stop, run.time_limit)};
  const CostPlanner planner(Planner(map.as_read()), map.costs->field);
  return planner.plan(request, {.params = optimum_params(run), .proof = true}).proof;
}

ShownLines shown_lines(const CostProof& proof, const Grid& map) {
  const CornerValues corners = corner_values(proof, map);
  if (!(corners.most > 0)) return {};
  const double apart = ticks(0, corners.most, kLevelLines)[1];
  return {apart, level_lines(corners, apart)};
}

Json weights_view_json(const CostField& costs, const Grid& map, const Window& window) {
  constexpr int kMostPixels = 512;  // a side
  const double shrink =
      std::min(1.0, 1.0 * kMostPixels / std::max(window.width(), window.height()));
  const auto pixels = [&](int cells) {
    return std::max(1, static_cast<int>(std::lround(shrink * cells)));
  };
  const int width = pixels(window.width()), height = pixels(window.height());
  const ColourScale scale = cost_scale(costs, map);
  std::vector<std::uint8_t> shares;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double weight = mean_weight(costs, map, cells_under(x, width, window.columns),
                                        cells_under(y, height, window.rows));
      const double share = weight == weight ? scale.share(weight) : 0;
      shares.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  }
  return {{"width", width},
          {"height", height},
          {"shares", packed(shares)},
          {"least", scale.range.low},
          {"most", scale.range.high}};
}

}  // namespace lasius::tool
