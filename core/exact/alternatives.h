// Ways between two points beside the shortest one.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/exact/taut_row.h"
#include "kernels/sight/sight.h"
#include "lasius/grid/geometry.h"

namespace lasius::exact {

/// An alternative is at most so many times as long as the shortest way.
inline constexpr double kMostDetour = 1.3;
/// What lies nearer than this to others, a share of the shortest way's length and at least one
/// cell, is shared with them; and how much of an alternative is, at most.
inline constexpr double kBeside = 0.01, kLeastBeside = 1;
inline constexpr double kMostShared = 0.7;
/// So much of an alternative, a share of the shortest way's length, is itself a shortest way: half
/// of it before the corner that it goes over, half behind.
inline constexpr double kShortestPart = 0.25;

/// How far the points of a way are from other ways.
class Beside {
 public:
  explicit Beside(double within) noexcept : within_(within) {}
  void add(std::span<const Point> way) {
    for (std::size_t i = 1; i < way.size(); ++i) pieces_.push_back({way[i - 1], way[i]});
  }
  /// The length of what lies within the distance of any way that was added.
  double shared(std::span<const Point> way) const;
  bool holds(Point p) const;  ///< is it within?
  std::int64_t size() const noexcept { return static_cast<std::int64_t>(pieces_.size()); }

 private:
  struct Piece {
    Point from, to;
  };
  struct Span {
    double first, last;
  };
  /// Of a segment, as shares of it, what lies within the distance of a piece; empty where last is
  /// less. The set is convex: a disc about each end and the rectangle between.
  Span within(const Piece& segment, const Piece& piece) const;

  double within_;
  std::vector<Piece> pieces_;
};

/// The length of a shortest way between two points; infinite if stopped.
using ShortestBetween = std::function<double(Point, Point)>;

/// At most `count` ways other than a shortest one, in the order of their lengths: each goes over
/// one corner, the shortest way to it and the shortest way from it, as in the via-node alternatives
/// of Abraham, Delling, Goldberg, Werneck (Alternative routes in road networks. ACM Journal of
/// Experimental Algorithmics 18, 2013). It is taut there, too, hence everywhere: the one shortest
/// way of its homotopy class. It does not cross itself, and keeps to the bounds above; shared is
/// what lies beside the shortest way or an alternative taken before, and its corner does not. The
/// shortest candidate is taken first.
///
/// `out` and `back` are the rows of corners from start and goal, up to kMostDetour times the length
/// of `shortest_way`. Fewer, if stopped.
std::vector<std::vector<Point>> alternatives(const kernels::BitmapView& map, const TautRow& out,
                                             const TautRow& back,
                                             std::span<const Point> shortest_way, int count,
                                             const ShortestBetween& shortest, Poller& poller);

}  // namespace lasius::exact
