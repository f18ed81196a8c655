#include "core/smooth/taut_string.h"

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>

#include "core/base/invalid_parameter.h"
#include "core/base/poller.h"
#include "core/grid/grid_view.h"
#include "core/smooth/triangle.h"
#include "lasius/path/path.h"
#include "lasius/path/smooth.h"

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
  half_.done.assign(1, input_[0]);
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
      if (squeeze || !inner) half_.done.push_back({p, squeeze});
    }
  }
  if (input_.size() > 1) half_.done.push_back(input_.back());
  input_.swap(half_.done);
}

// Both ends of `todo` are kept.
template <class P>
void TautString::pull(const Grid& grid, Work<P>& work, const StopCondition& stop) {
  auto& [done, todo, chain, corners] = work;
  const kernels::BitmapView map = view_of(grid);
  Poller poller(stop);
  done.clear();
  for (; !todo.empty(); poller.stop_after(4)) {
    const VertexAt<P> c = todo.back();
    if (!done.empty() && done.back().at == c.at) {
      done.back().fixed = done.back().fixed != c.fixed;  // there and back again
      todo.pop_back();
      continue;
    }
    const bool open = done.size() > 1 && !done.back().fixed && !poller.stopped();
    if (!open || bends_round_block(map, done.rbegin()[1].at, done.back().at, c.at)) {
      done.push_back(c);
      todo.pop_back();
      continue;
    }
    // The chain takes the place of b and is looked at vertex by vertex, from a on.
    const P b = done.back().at;
    const P a = done.rbegin()[1].at;
    chain.clear();
    if (turn(a, b, c.at) != 0 && !chain_in_triangle(map, a, b, c.at, poller, corners, chain)) {
      continue;  // stopped: b stays
    }
    done.pop_back();
    for (auto p = chain.rbegin(); p != chain.rend(); ++p) todo.push_back({*p, false});
  }
}

void TautString::pull(const Grid& grid, Corners corners, const StopCondition& stop) {
  if (corners == Corners::allow) fix_squeezes(grid);
  half_.todo.assign(input_.rbegin(), input_.rend());
  pull(grid, half_, stop);
  points_.clear();
  for (const Vertex& v : half_.done) points_.push_back({v.at.x / 2.0, v.at.y / 2.0});
}

void TautString::run(const Grid& grid, Point from, std::span<const HalfPoint> path, Point to,
                     Corners corners, const StopCondition& stop) {
  input_.clear();
  for (const HalfPoint p : path) add(p);
  if (corners == Corners::allow) fix_squeezes(grid);
  fine_.todo.assign(1, {kernels::fine(to.x, to.y), false});
  for (auto v = input_.rbegin(); v != input_.rend(); ++v)
    fine_.todo.push_back({kernels::fine(v->at), v->fixed});
  fine_.todo.push_back({kernels::fine(from.x, from.y), false});
  pull(grid, fine_, stop);
  constexpr double kUnit = 1.0 / static_cast<double>(kernels::kFineCell);
  points_.clear();
  for (const auto& v : fine_.done)
    points_.push_back({kUnit * static_cast<double>(v.at.x), kUnit * static_cast<double>(v.at.y)});
  points_.front() = from;
  if (points_.size() > 1 || from == to) points_.back() = to;
}

std::vector<Point> pull_taut(const Grid& grid, std::span<const Point> path, Corners corners,
                             const StopCondition& stop) {
  const auto refuse = [](const std::string& fault) {
    throw invalid_parameter("the path cannot be pulled taut: " + fault,
                            "give a path that path_fault() accepts, its ends at multiples of 0.5");
  };
  if (const auto fault = path_fault(grid, path, corners)) refuse(*fault);
  for (const Point p : {path.front(), path.back()})
    if (2 * p.x != std::floor(2 * p.x) || 2 * p.y != std::floor(2 * p.y))
      refuse("its end " + pair_text(p.x, p.y) + " is not at multiples of 0.5");
  std::vector<HalfPoint> points;
  points.reserve(path.size());
  for (const Point p : path)
    points.push_back({static_cast<int>(2 * p.x), static_cast<int>(2 * p.y)});
  TautString taut;
  taut.run(grid, points, corners, stop);
  return {taut.path().begin(), taut.path().end()};
}

}  // namespace lasius
