// Fast marching: arrival times at the centres of cells, and the way down them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "bench/peers/cost_peers.h"

namespace lasius::peers {
namespace {

/// Fast marching (Sethian 1996) from the goal until the start is reached: each cell's weight is the
/// gradient of the time there. The path goes down the gradient of the times interpolated between
/// centres, a third of a cell a step; where that leads nowhere, as beside what is blocked, to the
/// best centre around.
class FastMarching final : public QueryPlanner {
 public:
  explicit FastMarching(const WeightedMap& map) : map_(&map), integral_(map), time_(map.size()) {}

  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    path.clear();
    march(start, goal);
    const double cost = time_[map_->index(start)];
    return cost == kNoPath || !descend(start, goal, path) ? kNoPath : cost;
  }

 private:
  struct Item {
    double time;
    std::uint32_t index;
    bool operator<(const Item& o) const noexcept { return time > o.time; }
  };

  void march(Cell start, Cell goal) {
    heap_.clear();
    std::ranges::fill(time_, kNoPath);
    done_.assign(map_->size(), 0);
    const std::size_t last = map_->index(start);
    time_[map_->index(goal)] = 0;
    heap_.push_back({0, static_cast<std::uint32_t>(map_->index(goal))});
    const std::size_t across = map_->stride();
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end());
      const std::size_t at = heap_.back().index;
      heap_.pop_back();
      if (done_[at] != 0) continue;
      done_[at] = 1;
      if (at == last) return;
      for (const std::size_t to : {at - 1, at + 1, at - across, at + across}) {
        const Cell c = map_->cell(to);
        if (done_[to] != 0 || !map_->free(c.x, c.y)) continue;
        const double time =
            solve(std::min(known(to - 1), known(to + 1)),
                  std::min(known(to - across), known(to + across)), map_->weight(c.x, c.y));
        if (time >= time_[to]) continue;
        time_[to] = time;
        heap_.push_back({time, static_cast<std::uint32_t>(to)});
        std::push_heap(heap_.begin(), heap_.end());
      }
    }
  }
  double known(std::size_t at) const noexcept { return done_[at] != 0 ? time_[at] : kNoPath; }
  /// The time t with (t - a)^2 + (t - b)^2 = w^2, or that from the lower one alone.
  static double solve(double a, double b, double weight) {
    if (std::abs(a - b) >= weight || a == kNoPath || b == kNoPath) return std::min(a, b) + weight;
    const double apart = a - b;
    return (a + b + std::sqrt(2 * weight * weight - apart * apart)) / 2;
  }

  double time(int x, int y) const noexcept { return time_[map_->index({x, y})]; }
  /// Time and its gradient, interpolated between four centres; infinite where one has none.
  double slope(Point p, Point& gradient) const noexcept {
    const int x = static_cast<int>(std::floor(p.x - 0.5)),
              y = static_cast<int>(std::floor(p.y - 0.5));
    const double fx = p.x - 0.5 - x, fy = p.y - 0.5 - y;
    if (x < -1 || y < -1 || x >= map_->width() || y >= map_->height()) return kNoPath;
    const double a = time(x, y), b = time(x + 1, y), c = time(x, y + 1), d = time(x + 1, y + 1);
    if (!(std::max({a, b, c, d}) < kNoPath)) return kNoPath;
    gradient = {(b - a) * (1 - fy) + (d - c) * fy, (c - a) * (1 - fx) + (d - b) * fx};
    return (a * (1 - fx) + b * fx) * (1 - fy) + (c * (1 - fx) + d * fx) * fy;
  }
  bool allowed(std::span<const Point> way) { return integral_.of(way) < kNoPath; }

  bool descend(Cell start, Cell goal, std::vector<Point>& path) {
    path.push_back(centre(start));
    double now = time_[map_->index(start)];
    for (std::size_t step = 0; step < 8 * map_->size(); ++step) {
      const Point p = path.back();
      if (std::hypot(p.x - goal.x - 0.5, p.y - goal.y - 0.5) <= 1.5) {
        // The last two points, so that corners are looked at.
        const std::array<Point, 3> end{path[path.size() - std::min<std::size_t>(path.size(), 2)], p,
                                       centre(goal)};
        if (allowed(end)) {
          path.push_back(centre(goal));
          return true;
        }
      }
      if (!step_down(path, now)) break;
    }
    path.clear();
    return false;
  }

  bool step_down(std::vector<Point>& path, double& now) {
    constexpr double kStep = 1.0 / 3;
    const Point p = path.back(), before = path[path.size() - std::min<std::size_t>(path.size(), 2)];
    Point gradient{};
    if (slope(p, gradient) < kNoPath) {
      const double steep = std::hypot(gradient.x, gradient.y);
      const Point to{p.x - kStep * gradient.x / steep, p.y - kStep * gradient.y / steep};
      const std::array<Point, 3> way{before, p, to};
      Point unused{};
      const double there = steep > 0 ? slope(to, unused) : kNoPath;
      if (there < now && allowed(way)) {
        path.push_back(to);
        now = there;
        return true;
      }
    }
    const Cell here{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))};
    double best = kNoPath;
    Point at{};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell c{here.x + dx, here.y + dy};
        if (!(time(c.x, c.y) < now)) continue;
        const std::array<Point, 3> way{before, p, centre(c)};
        const double cost = time(c.x, c.y) + integral_.of(std::span(way).subspan(1));
        if (cost >= best || !allowed(way)) continue;
        best = cost;
        at = centre(c);
      }
    }
    if (best == kNoPath) return false;
    path.push_back(at);
    now = time_[map_->index({static_cast<int>(at.x), static_cast<int>(at.y)})];
    return true;
  }

  const WeightedMap* map_;
  PathIntegral integral_;
  std::vector<double> time_;
  std::vector<char> done_;
  std::vector<Item> heap_;
};

}  // namespace

std::unique_ptr<QueryPlanner> fast_marching(const WeightedMap& map) {
  return std::make_unique<FastMarching>(map);
}

}  // namespace lasius::peers
