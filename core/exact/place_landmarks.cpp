#include "core/exact/place_landmarks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/exact/corner_graph.h"
#include "core/exact/corner_view.h"
#include "core/exact/prepared_search.h"
#include "core/grid/grid_view.h"
#include "kernels/sight/sight.h"

namespace lasius::exact {
namespace {

constexpr std::uint32_t kBlock = 256;  // corners that one thread looks from in turn
constexpr std::uint32_t kTries = 8;    // places to start from, until one is in the largest region
constexpr std::int64_t kWords = sizeof(Landmarks::Distances) / 8;  // of a corner

// The cell at a corner that lies across from its block: always free.
Cell cell_across(const GraphCorner& c) {
  return {c.block_x() > 0 ? c.x() - 1 : c.x(), c.block_y() > 0 ? c.y() - 1 : c.y()};
}

// Where landmarks go, and floods from them.
class Placement {
 public:
  Placement(const Grid& grid, const CornerGraph& graph, const StopCondition& stop)
      : grid_(grid), graph_(graph), stop_(stop), poller_(stop) {}

  // False if stopped.
  bool run() {
    const double sides = grid_.width() + grid_.height();
    grain = Landmarks::grain(sides);
    if (!forget_distances() || !flood_largest_region() || !find_farthest()) return false;
    // No two corners of the region are farther from each other.
    if (farthest_ != kNone) grain = Landmarks::grain(std::max(sides, 2 * nearest_[farthest_] + 1));
    for (std::size_t i = 0; i < Landmarks::kCount; ++i) {
      if (!find_farthest()) return false;
      if (farthest_ == kNone) break;
      cells.push_back(cell_across(graph_.corner(farthest_)));
      if (!flood(cells.back())) return false;
      for (std::uint32_t v = 0; v < graph_.size(); ++v) {
        if (poller_.stop_after(kWords)) return false;
        if (std::isfinite(lengths_[v])) distances[v][i] = static_cast<float>(lengths_[v]);
        // What the first was far from counts no longer.
        nearest_[v] = i == 0 ? lengths_[v] : std::min(nearest_[v], lengths_[v]);
      }
      nearest_[farthest_] = 0;
    }
    return true;
  }

  std::vector<Cell> cells;
  std::vector<Landmarks::Distances> distances;
  double grain = 0;

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  bool flood(Cell from) { return !search_.flood(grid_, graph_, from, grain, stop_, lengths_); }

  // This and the next two: false if stopped.
  bool forget_distances() {
    Landmarks::Distances unknown;
    unknown.fill(Landmarks::kUnknown);
    distances.reserve(graph_.size());
    while (distances.size() < graph_.size()) {
      if (poller_.stop_after(kWords)) return false;
      distances.push_back(unknown);
    }
    return true;
  }

  bool flood_largest_region() {
    std::int64_t most = 0;
    for (std::uint32_t i = 0; i < kTries && most * 2 < graph_.size(); ++i) {
      const auto from = static_cast<std::uint32_t>(std::uint64_t{graph_.size()} * i / kTries);
      if (!flood(cell_across(graph_.corner(from)))) return false;
      std::int64_t reached = 0;
      for (const double length : lengths_) {
        if (poller_.stop_after(1)) return false;
        reached += std::isfinite(length);
      }
      if (reached > most) nearest_.swap(lengths_);
      most = std::max(most, reached);
    }
    return true;
  }

  // The corner farthest from all landmarks, kNone if there is none left.
  bool find_farthest() {
    farthest_ = kNone;
    double distance = 0;
    for (std::uint32_t v = 0; v < nearest_.size(); ++v) {
      if (poller_.stop_after(1)) return false;
      if (!std::isfinite(nearest_[v]) || nearest_[v] <= distance) continue;
      distance = nearest_[v];
      farthest_ = v;
    }
    return true;
  }

  const Grid& grid_;
  const CornerGraph& graph_;
  const StopCondition& stop_;
  Poller poller_;
  PreparedSearch search_;
  std::vector<double> nearest_;  // distance to the nearest landmark
  std::vector<double> lengths_;  // of the last flood
  std::uint32_t farthest_ = kNone;
};

// A look from one corner across from its block.
class alignas(64) LookAcross {
 public:
  LookAcross(const Grid& grid, const CornerGraph& graph, const Placement& placed,
             const StopCondition& stop)
      : map_(view_of(grid)), graph_(graph), placed_(placed), poller_(stop) {}

  // False if stopped.
  bool from(std::uint32_t index, Landmarks::Distances& result) {
    corner_ = graph_.corner(index);
    result_ = &result;
    const Quadrant across{corner_.x(), corner_.y(), -corner_.block_x(), -corner_.block_y()};
    if (across.right > 0)
      view_quadrant<1>(map_, across, {}, true, stack_, *this);
    else
      view_quadrant<-1>(map_, across, {}, true, stack_, *this);
    look_along_column();
    look_at_landmarks();
    return !poller_.stopped();
  }

  void corner(int x, int y) {
    const Landmarks::Distances& known = placed_.distances[graph_.index(x, y)];
    const double way = exact::distance(2 * corner_.x(), 2 * corner_.y(), 2 * x, 2 * y);
    for (std::size_t i = 0; i < known.size(); ++i) shorten(i, known[i] + way);
  }
  bool go_on(std::int64_t words) { return !poller_.stop_after(words); }

 private:
  void shorten(std::size_t i, double length) {
    if (std::isnan(length)) return;
    float& known = (*result_)[i];
    length = Landmarks::whole_grains(length, placed_.grain);
    if (!(known <= length)) known = static_cast<float>(length);
  }

  // The quadrant's vertical side. Blocks on either side may touch it, which ends a cone, and from
  // the far end no path bends at this corner: no edge of the graph comes along here.
  void look_along_column() {
    const int x = corner_.x(), down = -corner_.block_y();
    bool left_behind = false, right_behind = false;
    for (int y = corner_.y();; y += down) {
      const int row = down > 0 ? y : y - 1;
      const bool left = map_.blocked(x - 1, row), right = map_.blocked(x, row);
      if (poller_.stop_after(1) || ((left || left_behind) && (right || right_behind))) return;
      if (left_behind != right_behind && !left && !right) corner(x, y);
      left_behind = left;
      right_behind = right;
    }
  }

  void look_at_landmarks() {
    const kernels::HalfPoint here{2 * corner_.x(), 2 * corner_.y()};
    for (std::size_t i = 0; i < placed_.cells.size(); ++i) {
      const kernels::HalfPoint at{2 * placed_.cells[i].x + 1, 2 * placed_.cells[i].y + 1};
      const bool across =
          (at.x - here.x) * corner_.block_x() < 0 && (at.y - here.y) * corner_.block_y() < 0;
      const double straight = exact::distance(here.x, here.y, at.x, at.y);
      if (!across || (*result_)[i] <= straight) continue;
      if (poller_.stop_after(std::abs(at.y - here.y) / 2)) return;
      if (kernels::sees(map_, here, at)) shorten(i, straight);
    }
  }

  const kernels::BitmapView map_;
  const CornerGraph& graph_;
  const Placement& placed_;
  Poller poller_;
  std::vector<kernels::Interval> stack_;
  GraphCorner corner_;
  Landmarks::Distances* result_ = nullptr;
};

/// Restores what Landmarks promise along all edges of some corners, by raising alone. Precondition:
/// the promise holds along edges between other corners.
class Raising {
 public:
  Raising(const CornerGraph& graph, Landmarks& landmarks) : graph_(graph), landmarks_(landmarks) {}

  void run(std::span<const std::uint32_t> corners) {
    for (landmark_ = 0; landmark_ < landmarks_.cells().size(); ++landmark_) {
      queue_.clear();
      for (const std::uint32_t corner : corners)
        for_each_neighbour(corner,
                           [&](std::uint32_t other, float way) { raise(other, corner, way); });
      for (std::size_t next = 0; next < queue_.size(); ++next) {
        const std::uint32_t corner = queue_[next];
        for_each_neighbour(corner,
                           [&](std::uint32_t other, float way) { raise(corner, other, way); });
      }
    }
  }

 private:
  // f(other, way) for each corner that an edge joins with this one.
  template <class F>
  void for_each_neighbour(std::uint32_t corner, const F& f) const {
    const int x = graph_.corner(corner).x(), y = graph_.corner(corner).y();
    for (const GraphEdge& edge : graph_.edges(corner))
      f(edge.to(), landmarks_.way(x - edge.x, y - edge.y));
    graph_.for_each_one_way(corner, [&](std::uint32_t from) {
      const GraphCorner& there = graph_.corner(from);
      f(from, landmarks_.way(there.x() - x, there.y() - y));
    });
  }
  // One end of an edge tells the other what it is to be at least.
  void raise(std::uint32_t from, std::uint32_t to, float way) {
    const float value = landmarks_.at(from, landmark_) - way;
    if (!(value > landmarks_.at(to, landmark_))) return;
    landmarks_.at(to, landmark_) = value;
    queue_.push_back(to);
  }

  const CornerGraph& graph_;
  Landmarks& landmarks_;
  std::size_t landmark_ = 0;  // in hand
  std::vector<std::uint32_t> queue_;
};

}  // namespace

double measure_detour(const CornerGraph& graph) {
  constexpr std::uint32_t kCorners = 8192;  // looked at
  constexpr double kNear = 16;              // cells: too near to tell
  const std::uint32_t step = std::max<std::uint32_t>(1, graph.size() / kCorners);
  std::vector<double> ratios;
  for (std::uint32_t v = 0; v < graph.size(); v += step) {
    const GraphCorner& corner = graph.corner(v);
    const Landmarks::Distances& distances = graph.landmarks().distances(v);
    for (std::size_t i = 0; i < graph.landmarks().cells().size(); ++i) {
      const Cell at = graph.landmarks().cells()[i];
      const double straight =
          exact::distance(2 * corner.x(), 2 * corner.y(), 2 * at.x + 1, 2 * at.y + 1);
      if (straight >= kNear && !std::isnan(distances[i])) ratios.push_back(distances[i] / straight);
    }
  }
  if (ratios.empty()) return kInfinity;
  const auto most = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() * 9 / 10);
  std::nth_element(ratios.begin(), most, ratios.end());
  return *most;
}

Landmarks place_landmarks(const Grid& grid, const CornerGraph& graph, int threads,
                          const StopCondition& stop) {
  Placement placed(grid, graph, stop);
  if (!placed.run()) return {};
  // Looks read what the floods found, so that their order does not matter.
  std::vector<Landmarks::Distances> distances;
  distances.reserve(placed.distances.size());
  Poller poller(stop);
  for (const Landmarks::Distances& known : placed.distances) {
    if (poller.stop_after(kWords)) return {};
    distances.push_back(known);
  }
  std::vector<LookAcross> team(static_cast<std::size_t>(threads),
                               LookAcross(grid, graph, placed, stop));
  const auto blocks = static_cast<int>((graph.size() + kBlock - 1) / kBlock);
  parallel_for(blocks, threads, [&](int block, int thread) {
    LookAcross& look = team[static_cast<std::size_t>(thread)];
    const std::uint32_t begin = static_cast<std::uint32_t>(block) * kBlock;
    const std::uint32_t end = std::min(begin + kBlock, graph.size());
    for (std::uint32_t v = begin; v < end; ++v)
      if (!look.from(v, distances[v])) return;
  });
  std::vector<std::uint32_t> shortened;
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    if (poller.stop_after(kWords)) return {};
    if (distances[v] != placed.distances[v]) shortened.push_back(v);
  }
  Landmarks landmarks(std::move(placed.cells), std::move(distances), placed.grain);
  Raising(graph, landmarks).run(shortened);
  return landmarks;
}

}  // namespace lasius::exact
