#include "lasius/path/poses.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/invalid_parameter.h"
#include "core/disc/curve.h"
#include "kernels/base/arctangent.h"
#include "kernels/base/sine.h"

namespace lasius {
namespace {

constexpr double kMostParts = 1e8;

/// A piece by the share of it that is gone.
struct Stretch {
  CurvePiece piece;

  double length() const noexcept { return disc::curve_length({&piece, 1}); }
  Pose at(double share) const noexcept {
    const auto& [from, to, turn, middle, angle, radius] = piece;
    if (turn == 0) {
      const double x = to.x - from.x, y = to.y - from.y;
      const double yaw = kernels::direction(y, x);
      if (share == 1) return {to.x, to.y, yaw};
      return {from.x + share * x, from.y + share * y, yaw};
    }
    const double x = from.x - middle.x, y = from.y - middle.y;
    const auto [sine, cosine] = kernels::sine_cosine(turn * share * angle);
    const double right = x * cosine - y * sine, down = x * sine + y * cosine;
    const double yaw = kernels::direction(turn * right, -turn * down);
    if (share == 0) return {from.x, from.y, yaw};
    if (share == 1) return {to.x, to.y, yaw};
    return {middle.x + right, middle.y + down, yaw};
  }
};

/// `piece(i)`: the i-th of `count`.
template <class Piece>
std::vector<Pose> along(std::size_t count, const Piece& piece, double spacing) {
  require_parameter(spacing > 0 && std::isfinite(spacing), "spacing of poses", spacing,
                    "give a length above 0");
  double parts = 0;
  const auto parts_of = [&](const Stretch& stretch) {
    return std::ceil(stretch.length() / spacing);
  };
  for (std::size_t i = 0; i < count; ++i) parts += parts_of({piece(i)});
  require_parameter(parts <= kMostParts, "spacing of poses", spacing,
                    "the path has more than 10^8 parts so long; give a larger one");
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(parts) + 1);
  std::optional<Stretch> last;
  for (std::size_t i = 0; i < count; ++i) {
    const Stretch stretch{piece(i)};
    const double steps = parts_of(stretch);
    for (double k = 0; k < steps; ++k) poses.push_back(stretch.at(k / steps));
    if (steps > 0) last = stretch;
  }
  if (last) poses.push_back(last->at(1));
  return poses;
}

}  // namespace

std::vector<Pose> poses(std::span<const Point> path, double spacing) {
  const auto piece = [&](std::size_t i) { return CurvePiece{.from = path[i], .to = path[i + 1]}; };
  auto found = along(path.empty() ? 0 : path.size() - 1, piece, spacing);
  if (found.empty() && !path.empty()) found.push_back({path.front().x, path.front().y, 0});
  return found;
}

std::vector<Pose> poses(std::span<const CurvePiece> curve, double spacing) {
  auto found = along(
      curve.size(), [&](std::size_t i) { return curve[i]; }, spacing);
  if (found.empty() && !curve.empty())
    found.push_back({curve.front().from.x, curve.front().from.y, 0});
  return found;
}

std::vector<Pose> poses(const Result& result, double spacing) {
  return result.curve.empty() ? poses(std::span(result.path), spacing)
                              : poses(std::span(result.curve), spacing);
}

Pose to_world(const WorldFrame& frame, const Pose& cells, int height) noexcept {
  const Point at = frame.to_world({cells.x, cells.y}, height);
  const double yaw = std::remainder(frame.yaw - cells.yaw, 2 * std::numbers::pi);
  return {at.x, at.y, yaw > -std::numbers::pi ? yaw : std::numbers::pi};
}

}  // namespace lasius
