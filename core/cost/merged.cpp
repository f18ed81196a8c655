#include "core/cost/merged.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/cost/path_cost.h"

namespace lasius::cost {
namespace {

constexpr double kStraight = 1e-6;   // cells beside the line
constexpr double kRounding = 1e-12;  // of a cost

class Merger {
 public:
  Merger(const Terrain& terrain, std::span<const Point> path) : terrain_(terrain), path_(path) {}

  /// Appends what remains of the vertices behind `first`, up to `last`.
  void merge(std::size_t first, std::size_t last, std::vector<Point>& to) const {
    const std::size_t split = farthest(first, last);
    if (split == first || cheap(first, last)) {
      to.push_back(path_[last]);
      return;
    }
    merge(first, split, to);
    merge(split, last, to);
  }

 private:
  /// The vertex between them that is farthest from their line, in the middle where all are on it;
  /// `first` if there is none between them.
  std::size_t farthest(std::size_t first, std::size_t last) const {
    std::size_t split = first + (last - first) / 2;
    double most = kStraight;
    for (std::size_t i = first + 1; i < last; ++i) {
      if (const double beside = distance_to_line(i, first, last); beside > most) {
        most = beside;
        split = i;
      }
    }
    return split;
  }
  double distance_to_line(std::size_t i, std::size_t first, std::size_t last) const {
    const Point a = path_[first], b = path_[last], p = path_[i];
    const double dx = b.x - a.x, dy = b.y - a.y, length = distance(a, b);
    if (length == 0) return distance(a, p);
    const double along =
        std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (length * length), 0.0, 1.0);
    return distance({a.x + along * dx, a.y + along * dy}, p);
  }
  bool cheap(std::size_t first, std::size_t last) const {
    for (std::size_t i = first + 1; i < last; ++i)
      if (distance_to_line(i, first, last) > kStraight) return false;
    const std::array straight{path_[first], path_[last]};
    return cost_of(terrain_, straight) <=
           cost_of(terrain_, path_.subspan(first, last - first + 1)) * (1 + kRounding);
  }

  const Terrain& terrain_;
  std::span<const Point> path_;
};

}  // namespace

std::vector<Point> merged(const Terrain& terrain, const std::vector<Point>& path) {
  if (path.size() < 3) return path;
  std::vector<Point> result{path.front()};
  Merger(terrain, path).merge(0, path.size() - 1, result);
  return result;
}

}  // namespace lasius::cost
