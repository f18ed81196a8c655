#include "core/arm/blends.h"

#include <algorithm>

#include "core/arm/ends.h"

namespace lasius::arm {

double largest_blend(const std::vector<JointVector>& way, std::size_t i) {
  return 0.5 * std::min(joint_travel(way[i - 1], way[i]), joint_travel(way[i], way[i + 1]));
}

PathPiece blend_at(const std::vector<JointVector>& way, std::size_t i, double size) {
  const JointVector in = (way[i] - way[i - 1]) / joint_travel(way[i - 1], way[i]);
  const JointVector out = (way[i + 1] - way[i]) / joint_travel(way[i], way[i + 1]);
  return {way[i] - size * in, in, (out - in) / (2 * size), 2 * size};
}

std::vector<PathRun> rounded(const std::vector<JointVector>& way, std::span<const double> sizes) {
  std::vector<PathRun> runs(1);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = joint_travel(way[i - 1], way[i]);
    const JointVector along = (way[i] - way[i - 1]) / length;
    const double left = length - sizes[i - 1] - sizes[i];
    if (left > 1e-9 * length)
      runs.back().push_back({way[i - 1] + sizes[i - 1] * along, along, {}, left});
    if (i + 1 == way.size()) break;
    if (sizes[i] > 0)
      runs.back().push_back(blend_at(way, i, sizes[i]));
    else
      runs.emplace_back();
  }
  return runs;
}

}  // namespace lasius::arm
