// Field D*: costs at the corners of cells, linear along edges.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "bench/peers/cost_peers.h"

namespace lasius::peers {
namespace {

constexpr std::array<Cell, 8> kRing{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// From a corner through one of its cells to the edge between a corner beside it and the diagonal
/// one. @param beside, diagonal  costs there @param inside  weight of the cell, @param across  of
/// the cell on the other side of the edge to the corner beside.
double interpolated(double beside, double diagonal, double inside, double across) {
  const double along = std::min(inside, across) + beside;
  if (inside == kNoPath || diagonal == kNoPath || beside <= diagonal) return along;
  const double fall = beside - diagonal;
  const double straight = inside * std::numbers::sqrt2 + diagonal;
  if (fall <= across) {
    if (inside <= fall) return straight;
    const double y = std::min(fall / std::sqrt(inside * inside - fall * fall), 1.0);
    return inside * std::sqrt(1 + y * y) + fall * (1 - y) + diagonal;
  }
  if (inside <= across) return straight;
  const double rest = std::min(across / std::sqrt(inside * inside - across * across), 1.0);
  return inside * std::sqrt(1 + rest * rest) + across * (1 - rest) + diagonal;
}

/// Field D* (Ferguson & Stentz 2006) for one query: A* from the goal over corners, whose costs are
/// interpolated; then from the start to the best point of an edge around, time and again. Where the
/// way taken does not lead on, there is no path.
class FieldDStar final : public QueryPlanner {
 public:
  explicit FieldDStar(const WeightedMap& map)
      : map_(&map),
        columns_(map.width() + 1),
        value_(static_cast<std::size_t>(columns_) * (map.height() + 1)) {}

  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    path.clear();
    const double cost = search(start, goal);
    return cost == kNoPath || !extract(start, goal, path) ? kNoPath : cost;
  }

 private:
  struct Item {
    double key, cost;
    std::uint32_t index;
    bool operator<(const Item& o) const noexcept { return key > o.key; }
  };
  struct Exit {
    double cost = kNoPath, value = kNoPath;
    Point at = {};
    Cell cell = {};
  };

  std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * columns_ + x;
  }
  bool inside(int x, int y) const noexcept {
    return x >= 0 && y >= 0 && x <= map_->width() && y <= map_->height();
  }
  double value(int x, int y) const noexcept { return value_[index(x, y)]; }

  /// Two blocked cells meet: a corner for either side alone. It has no cost, so that none leaks.
  bool squeeze(int x, int y) const noexcept {
    return map_->free(x, y) == map_->free(x - 1, y - 1) &&
           map_->free(x - 1, y) == map_->free(x, y - 1) && map_->free(x, y) != map_->free(x - 1, y);
  }

  void offer(int x, int y, double cost, Point start) {
    double& known = value_[index(x, y)];
    if (!(cost < known) || squeeze(x, y)) return;
    known = cost;
    const double key = cost + map_->least() * std::hypot(x - start.x, y - start.y);
    heap_.push_back({key, cost, static_cast<std::uint32_t>(index(x, y))});
    std::push_heap(heap_.begin(), heap_.end());
  }

  double search(Cell from, Cell goal) {
    heap_.clear();
    std::ranges::fill(value_, kNoPath);
    const Point start = centre(from);
    const double half = std::numbers::sqrt2 / 2;
    const auto corners = [](Cell c, const auto& visit) {
      for (int i = 0; i < 4; ++i) visit(c.x + i % 2, c.y + i / 2);
    };
    corners(goal, [&](int x, int y) { offer(x, y, half * map_->weight(goal.x, goal.y), start); });
    double best = kNoPath;
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end());
      const Item item = heap_.back();
      heap_.pop_back();
      // A little farther, so that what surrounds the path is known, too.
      if (item.key > best + 4 * map_->least()) break;
      if (item.cost > value_[item.index]) continue;
      const int x = static_cast<int>(item.index) % columns_;
      const int y = static_cast<int>(item.index) / columns_;
      update_around(x, y, start);
      corners(from, [&](int cx, int cy) {
        if (cx == x && cy == y)
          best = std::min(best, item.cost + half * map_->weight(from.x, from.y));
      });
    }
    return best;
  }

  /// Offers each corner around what it costs over an edge that ends here.
  void update_around(int x, int y, Point start) {
    for (const Cell step : kRing) {
      const int nx = x + step.x, ny = y + step.y;
      if (!inside(nx, ny)) continue;
      const bool diagonal = step.x != 0 && step.y != 0;
      // The edge's other end: beside this corner, and seen from there along an axis or a diagonal.
      for (const int side : {0, 1}) {
        Cell other{x, y};
        if (diagonal) {
          (side == 0 ? other.x : other.y) = side == 0 ? nx : ny;
        } else {
          (step.x == 0 ? other.x : other.y) += side == 0 ? 1 : -1;
        }
        if (!inside(other.x, other.y)) continue;
        const Cell beside = diagonal ? other : Cell{x, y}, far = diagonal ? Cell{x, y} : other;
        const Cell in{std::min(nx, far.x), std::min(ny, far.y)};
        const bool level = beside.y == ny;  // the edge from the corner to the one beside
        const Cell across{level ? in.x : 2 * nx - in.x - 1, level ? 2 * ny - in.y - 1 : in.y};
        const double cost =
            interpolated(value(beside.x, beside.y), value(far.x, far.y), map_->weight(in.x, in.y),
                         map_->weight(across.x, across.y));
        offer(nx, ny, cost, start);
      }
    }
  }

  /// The cheapest point of a cell's edges, seen from a point of the cell, whose value is below one.
  void look(Point p, Cell cell, double below, Exit& best) const {
    const double weight = map_->weight(cell.x, cell.y);
    const auto offered = [&](Point at, double cost_there) {
      const double cost = cost_there + weight * std::hypot(at.x - p.x, at.y - p.y);
      if (cost_there < below && cost < best.cost) best = {cost, cost_there, at, cell};
    };
    for (int side = 0; side < 4; ++side) {
      const bool level = side < 2;
      const int x0 = cell.x + (side == 3 ? 1 : 0), y0 = cell.y + (side == 1 ? 1 : 0);
      const double a = value(x0, y0), b = value(x0 + (level ? 1 : 0), y0 + (level ? 0 : 1));
      const auto point = [&](double t) {
        return Point{x0 + (level ? t : 0), y0 + (level ? 0 : t)};
      };
      if (a < kNoPath) offered(point(0), a);
      const double off = level ? std::abs(p.y - y0) : std::abs(p.x - x0);
      const double slope = b - a, foot = level ? p.x - x0 : p.y - y0;
      if (!(a < kNoPath) || !(b < kNoPath) || off == 0 || weight <= std::abs(slope)) continue;
      const double t = foot - slope * off / std::sqrt(weight * weight - slope * slope);
      if (t > 0 && t < 1) offered(point(t), a + t * slope);
    }
    if (const double last = value(cell.x + 1, cell.y + 1); last < kNoPath)
      offered({cell.x + 1.0, cell.y + 1.0}, last);
  }

  bool extract(Cell start, Cell goal, std::vector<Point>& path) const {
    path.push_back(centre(start));
    Exit here;
    look(centre(start), start, kNoPath, here);
    while (here.cost < kNoPath) {
      path.push_back(here.at);
      const Point p = here.at;
      const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
      Exit next;
      for (int cy = p.y == y ? y - 1 : y; cy <= y; ++cy) {
        for (int cx = p.x == x ? x - 1 : x; cx <= x; ++cx) {
          if (!map_->joined(here.cell, {cx, cy})) continue;
          if (Cell{cx, cy} == goal) {
            path.push_back(centre(goal));
            return true;
          }
          look(p, {cx, cy}, here.value, next);
        }
      }
      here = next;
    }
    path.clear();
    return false;
  }

  const WeightedMap* map_;
  int columns_;
  std::vector<double> value_;
  std::vector<Item> heap_;
};

}  // namespace

std::unique_ptr<QueryPlanner> field_dstar(const WeightedMap& map) {
  return std::make_unique<FieldDStar>(map);
}

}  // namespace lasius::peers
