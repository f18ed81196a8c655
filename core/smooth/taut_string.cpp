#include "core/smooth/taut_string.h"

#include <cmath>
#include <cstdlib>
#include <numeric>

#include "core/base/invalid_parameter.h"
#include "core/base/poller.h"
#include "core/grid/grid_view.h"
#include "core/smooth/triangle.h"
#include "lasius/path.h"
#include "lasius/smooth.h"

namespace lasius {

using kernels::HalfPoint;

void TautString::run(const Grid& grid, std::span<const HalfPoint> path, Corners corners,
                     const StopCondition& stop) {
  input_.clear();
  for (const HalfPoint p : path) add(p);
  pull(grid, corners, stop);
}

void TautString::run(const Grid& grid, std::span<const Cell> cells, Corners corners,
                     const StopCondition& stop) {
  input_.clear();
  for (const Cell c : cells) add({2 * c.x + 1, 2 * c.y + 1});
  pull(grid, corners, stop);
}

void TautString::add(HalfPoint p) {
  if (input_.empty() || input_.back().at != p) input_.push_back({p, false});
}

// Makes a fixed vertex of each point where the path squeezes between diagonal blocks: a path on
// either side of it knows nothing of squeezes.
void TautString::fix_squeezes(const Grid& grid) {
  const kernels::BitmapView map = view_of(grid);
  done_.assign(1, input_[0]);
  for (std::size_t i = 1; i < input_.size(); ++i) {
    const HalfPoint a = input_[i - 1].at;
    const HalfPoint b = input_[i].at;
    const int parts = std::gcd(std::abs(b.x - a.x), std::abs(b.y - a.y));
    for (int part = 1; part <= parts; ++part) {
      const HalfPoint p{a.x + (b.x - a.x) / parts * part, a.y + (b.y - a.y) / parts * part};
      const bool inner = part < parts;
      if (!inner && i + 1 == input_.size()) break;
      const bool squeeze =
          ((p.x | p.y) & 1) == 0 && kernels::squeezes(map, a, p, inner ? b : input_[i + 1].at);
      if (squeeze || !inner) done_.push_back({p, squeeze});
    }
  }
  if (input_.size() > 1) done_.push_back(input_.back());
  input_.swap(done_);
}

void TautString::pull(const Grid& grid, Corners corners, const StopCondition& stop) {
  if (corners == Corners::allow) fix_squeezes(grid);
  const kernels::BitmapView map = view_of(grid);
  Poller poller(stop);
  todo_.assign(input_.rbegin(), input_.rend());
  done_.clear();
  for (; !todo_.empty(); poller.stop_after(4)) {
    const Vertex c = todo_.back();
    if (!done_.empty() && done_.back().at == c.at) {
      done_.back().fixed = done_.back().fixed != c.fixed;  // there and back again
      todo_.pop_back();
      continue;
    }
    const bool open = done_.size() > 1 && !done_.back().fixed && !poller.stopped();
    if (!open || bends_round_block(map, done_.rbegin()[1].at, done_.back().at, c.at)) {
      done_.push_back(c);
      todo_.pop_back();
      continue;
    }
    // The chain takes the place of b and is looked at vertex by vertex, from a on.
    const HalfPoint b = done_.back().at;
    const HalfPoint a = done_.rbegin()[1].at;
    chain_.clear();
    if (turn(a, b, c.at) != 0 && !chain_in_triangle(map, a, b, c.at, poller, corners_, chain_)) {
      continue;  // stopped: b stays
    }
    done_.pop_back();
    for (auto p = chain_.rbegin(); p != chain_.rend(); ++p) todo_.push_back({*p, false});
  }
  points_.clear();
  for (const Vertex& v : done_) points_.push_back({v.at.x / 2.0, v.at.y / 2.0});
}

std::vector<Point> pull_taut(const Grid& grid, std::span<const Point> path, Corners corners,
                             const StopCondition& stop) {
  if (const auto fault = path_fault(grid, path, corners)) {
    throw invalid_parameter("the path cannot be pulled taut: " + *fault,
                            "give a path that path_fault() accepts");
  }
  std::vector<HalfPoint> points;
  points.reserve(path.size());
  for (const Point p : path)
    points.push_back({static_cast<int>(2 * p.x), static_cast<int>(2 * p.y)});
  TautString taut;
  taut.run(grid, points, corners, stop);
  return {taut.path().begin(), taut.path().end()};
}

}  // namespace lasius
