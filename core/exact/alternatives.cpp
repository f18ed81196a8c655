#include "core/exact/alternatives.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <tuple>

#include "core/base/special_values.h"
#include "core/grid/distance.h"
#include "lasius/path/path.h"

namespace lasius::exact {
namespace {

using kernels::FinePoint;

FinePoint lattice(const TautRow::Corner& c) noexcept { return kernels::fine({2 * c.x, 2 * c.y}); }

/// Does a path from a over lattice point (x, y), a corner of the map, to b bend around its blocked
/// cell, or go straight on? Both edges of that cell then lie in the angle between the two.
bool taut(const kernels::BitmapView& map, FinePoint a, int x, int y, FinePoint b) {
  const FinePoint at = kernels::fine({2 * x, 2 * y});
  const int turn = kernels::turn_sign(a, at, b);
  const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
  const int ux = sign(at.x - a.x), uy = sign(at.y - a.y);
  const int vx = sign(b.x - at.x), vy = sign(b.y - at.y);
  if (turn == 0) return ux == vx && uy == vy;
  int block_x = 0, block_y = 0;
  for (const int by : {-1, 1})
    for (const int bx : {-1, 1})
      if (map.blocked(bx < 0 ? x - 1 : x, by < 0 ? y - 1 : y)) {
        block_x = bx;
        block_y = by;
      }
  return -uy * block_x * turn >= 0 && ux * block_y * turn >= 0 && -vy * block_x * turn >= 0 &&
         vx * block_y * turn >= 0;
}

/// Do two segments have a point in common?
bool meet(FinePoint a, FinePoint b, FinePoint c, FinePoint d) {
  const auto apart_along = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart_along(a.x, b.x, c.x, d.x) || apart_along(a.y, b.y, c.y, d.y)) return false;
  const auto one_side = [](FinePoint p, FinePoint q, FinePoint r, FinePoint s) {
    return kernels::turn_sign(p, q, r) * kernels::turn_sign(p, q, s) > 0;
  };
  return !one_side(a, b, c, d) && !one_side(c, d, a, b);
}

/// A way over a corner.
struct Via {
  double length;
  std::uint32_t out, back;  ///< the corner in either row
  std::vector<std::uint32_t> corners =
      {};  ///< in the first row: all over which the way is this one
};

class Search {
 public:
  Search(const kernels::BitmapView& map, const TautRow& out, const TautRow& back,
         std::span<const Point> shortest_way, Poller& poller)
      : map_(map),
        out_(out),
        back_(back),
        start_(kernels::fine(shortest_way.front().x, shortest_way.front().y)),
        goal_(kernels::fine(shortest_way.back().x, shortest_way.back().y)),
        ends_{shortest_way.front(), shortest_way.back()},
        least_(path_length(shortest_way)),
        taken_(std::max(kLeastBeside, kBeside * least_)),
        poller_(poller) {
    taken_.add(shortest_way);
  }

  std::vector<std::vector<Point>> run(int count, const ShortestBetween& shortest) {
    std::vector<std::vector<Point>> found;
    for (const Via& via : candidates()) {
      if (static_cast<int>(found.size()) == count || poller_.stop_after(kPerCandidate)) break;
      const auto beside = [&](std::uint32_t i) { return taken_.holds(point(out_.corners[i])); };
      std::vector<std::uint32_t> apart;
      std::ranges::remove_copy_if(via.corners, std::back_inserter(apart), beside);
      if (apart.empty()) continue;
      std::vector<Point> way = way_over(via);
      const auto size = static_cast<std::int64_t>(way.size());
      if (poller_.stop_after(size * taken_.size())) break;
      if (taken_.shared(way) > kMostShared * path_length(way)) continue;
      const Point at = point(out_.corners[via.out]);
      const auto vertex = std::ranges::find(way, at) - way.begin();
      if (poller_.stop_after(vertex * (size - vertex))) break;
      if (crosses_itself(way, vertex)) continue;
      bool stopped = false;
      const bool good = std::ranges::any_of(apart, [&](std::uint32_t i) {
        return !stopped && shortest_around(way, out_.corners[i], via.length, shortest, stopped);
      });
      if (stopped) break;
      if (!good) continue;
      taken_.add(way);
      drop_straight(way);
      found.push_back(std::move(way));
    }
    std::ranges::stable_sort(found, {}, [](const auto& path) { return path_length(path); });
    return found;
  }

 private:
  static constexpr std::int64_t kPerCandidate = 256;  // words, as a poller counts
  static constexpr double kSlack = 1e-9;              // of points between vertices

  FinePoint before(const TautRow& row, std::uint32_t index, FinePoint end) const {
    const std::uint32_t parent = row.corners[index].parent;
    return parent == TautRow::kEnd ? end : lattice(row.corners[parent]);
  }

  // Corners of both rows at which a way over them is taut, one for each way: of a way whose corners
  // are all candidates that is the one nearest to the goal.
  std::vector<Via> candidates() const {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> places;
    for (std::uint32_t i = 0; i < back_.corners.size(); ++i)
      places.emplace_back(place(back_.corners[i]), i);
    std::ranges::sort(places);
    std::vector<Via> found;
    for (std::uint32_t i = 0; i < out_.corners.size() && !poller_.stop_after(8); ++i) {
      const TautRow::Corner& corner = out_.corners[i];
      const auto at = std::ranges::lower_bound(places, place(corner), {},
                                               &std::pair<std::uint64_t, std::uint32_t>::first);
      if (at == places.end() || at->first != place(corner)) continue;
      const std::uint32_t back = at->second;
      const double length = corner.length + back_.corners[back].length;
      if (length > kMostDetour * least_) continue;
      if (!taut(map_, before(out_, i, start_), corner.x, corner.y, before(back_, back, goal_)))
        continue;
      found.push_back({length, i, back});
    }
    join_repeated(found);
    const auto key = [&](const Via& via) {
      const TautRow::Corner& corner = out_.corners[via.out];
      return std::tuple(via.length, corner.y, corner.x);
    };
    std::ranges::sort(found, [&](const Via& a, const Via& b) { return key(a) < key(b); });
    return found;
  }

  // Of a corner and the next one towards the goal, if that one is reached over it, the ways are
  // one.
  void join_repeated(std::vector<Via>& found) const {
    std::vector<std::uint32_t> number(back_.corners.size(), TautRow::kEnd);
    for (std::uint32_t i = 0; i < found.size(); ++i) number[found[i].back] = i;
    const auto next = [&](const Via& via) -> std::uint32_t {
      const std::uint32_t parent = back_.corners[via.back].parent;
      if (parent == TautRow::kEnd || number[parent] == TautRow::kEnd) return TautRow::kEnd;
      return out_.corners[found[number[parent]].out].parent == via.out ? number[parent]
                                                                       : TautRow::kEnd;
    };
    for (const Via& via : found) {
      const Via* last = &via;
      for (std::uint32_t i = next(via); i != TautRow::kEnd; i = next(*last)) last = &found[i];
      found[number[last->back]].corners.push_back(via.out);
    }
    std::erase_if(found, [](const Via& via) { return via.corners.empty(); });
  }

  static std::uint64_t place(const TautRow::Corner& corner) noexcept {
    return static_cast<std::uint64_t>(corner.y) << 32 | static_cast<std::uint32_t>(corner.x);
  }

  static Point point(const TautRow::Corner& c) noexcept { return {1.0 * c.x, 1.0 * c.y}; }

  // With corners that it passes straight.
  std::vector<Point> way_over(const Via& via) const {
    std::vector<Point> way;
    for (auto i = via.out; i != TautRow::kEnd; i = out_.corners[i].parent)
      way.push_back(point(out_.corners[i]));
    way.push_back(ends_[0]);
    std::ranges::reverse(way);
    for (auto i = back_.corners[via.back].parent; i != TautRow::kEnd; i = back_.corners[i].parent)
      way.push_back(point(back_.corners[i]));
    way.push_back(ends_[1]);
    return way;
  }

  static void drop_straight(std::vector<Point>& way) {
    std::vector<Point> bends{way.front()};
    for (std::size_t i = 1; i + 1 < way.size(); ++i)
      if (turn(bends.back(), way[i], way[i + 1]) != 0) bends.push_back(way[i]);
    bends.push_back(way.back());
    way = std::move(bends);
  }

  static FinePoint fine(Point p) noexcept { return kernels::fine(p.x, p.y); }
  static int turn(Point a, Point b, Point c) {
    return kernels::turn_sign(fine(a), fine(b), fine(c));
  }

  // Its halves before and behind a vertex are shortest ways, so that none of them does.
  static bool crosses_itself(const std::vector<Point>& way, std::ptrdiff_t vertex) {
    const auto corner = static_cast<std::size_t>(vertex);
    for (std::size_t i = 1; i <= corner; ++i)
      for (std::size_t j = corner + 1; j < way.size(); ++j)
        if ((i != corner || j != corner + 1) &&
            meet(fine(way[i - 1]), fine(way[i]), fine(way[j - 1]), fine(way[j])))
          return true;
    return false;
  }

  // Around a corner, and from there to both ends: rows tell of ways that may turn in a corner
  // alone, and to some corners others are shorter.
  bool shortest_around(const std::vector<Point>& way, const TautRow::Corner& corner, double length,
                       const ShortestBetween& shortest, bool& stopped) const {
    const Point over = point(corner);
    const auto at = static_cast<std::size_t>(std::ranges::find(way, over) - way.begin());
    const auto [from, first] = walk(way, at, -1);
    const auto [to, second] = walk(way, at, 1);
    const auto is_shortest = [&](Point a, Point b, double known) {
      const double found = shortest(a, b);
      stopped = stopped || found == kInfinity;
      return found >= known * (1 - kSlack);
    };
    return is_shortest(from, to, first + second) && is_shortest(way.front(), over, corner.length) &&
           is_shortest(over, way.back(), length - corner.length) && !stopped;
  }

  // The place that is kShortestPart / 2 along the way from a vertex, and how far that is; the way's
  // end, or a vertex before the place where rounding would put it into a blocked cell.
  std::pair<Point, double> walk(const std::vector<Point>& path, std::size_t from, int step) const {
    const double far = 0.5 * kShortestPart * least_;
    double gone = 0;
    std::size_t i = from;
    while (step < 0 ? i > 0 : i + 1 < path.size()) {
      const Point a = path[i], b = path[i + step];
      const double next = distance(a, b);
      if (gone + next >= far) {
        const double share = (far - gone) / next;
        const Point at{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
        const bool free = kernels::sees_fine(map_, fine(at), fine(at));
        return free ? std::pair(at, gone + distance(a, at)) : std::pair(a, gone);
      }
      gone += next;
      i += step;
    }
    return {path[i], gone};
  }

  const kernels::BitmapView& map_;
  const TautRow& out_;
  const TautRow& back_;
  FinePoint start_, goal_;
  Point ends_[2];
  double least_;
  Beside taken_;
  Poller& poller_;
};

}  // namespace

Beside::Span Beside::within(const Piece& segment, const Piece& piece) const {
  const double dx = segment.to.x - segment.from.x, dy = segment.to.y - segment.from.y;
  Span span{1, 0};
  const auto add = [&](double first, double last) {
    first = std::max(first, 0.0);
    last = std::min(last, 1.0);
    if (first > last) return;
    span = span.first > span.last ? Span{first, last}
                                  : Span{std::min(span.first, first), std::max(span.last, last)};
  };
  for (const Point about : {piece.from, piece.to}) {
    const double x = segment.from.x - about.x, y = segment.from.y - about.y;
    const double a = dx * dx + dy * dy, b = x * dx + y * dy, c = x * x + y * y - within_ * within_;
    const double root = b * b - a * c;
    if (root >= 0) add((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
  }
  // In the frame of the piece.
  const double length = distance(piece.from, piece.to);
  const double ex = (piece.to.x - piece.from.x) / length, ey = (piece.to.y - piece.from.y) / length;
  const double x = segment.from.x - piece.from.x, y = segment.from.y - piece.from.y;
  double first = 0, last = 1;
  const auto clip = [&](double at, double step, double least, double most) {
    if (step == 0) {
      if (at < least || at > most) last = -1;
      return;
    }
    const double one = (least - at) / step, other = (most - at) / step;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  };
  clip(x * ex + y * ey, dx * ex + dy * ey, 0, length);
  clip(ex * y - ey * x, ex * dy - ey * dx, -within_, within_);
  add(first, last);
  return span;
}

double Beside::shared(std::span<const Point> way) const {
  double sum = 0;
  std::vector<Span> spans;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Piece segment{way[i - 1], way[i]};
    spans.clear();
    for (const Piece& piece : pieces_)
      if (const Span span = within(segment, piece); span.first <= span.last) spans.push_back(span);
    std::ranges::sort(spans, {}, &Span::first);
    double share = 0, end = 0;
    for (const Span& span : spans) {
      if (span.last > end) share += span.last - std::max(span.first, end);
      end = std::max(end, span.last);
    }
    sum += share * distance(segment.from, segment.to);
  }
  return sum;
}

bool Beside::holds(Point p) const {
  return std::ranges::any_of(pieces_, [&](const Piece& piece) {
    const double x = piece.to.x - piece.from.x, y = piece.to.y - piece.from.y;
    const double along = ((p.x - piece.from.x) * x + (p.y - piece.from.y) * y) / (x * x + y * y);
    const double t = std::clamp(along, 0.0, 1.0);
    return distance(p, {piece.from.x + t * x, piece.from.y + t * y}) <= within_;
  });
}

std::vector<std::vector<Point>> alternatives(const kernels::BitmapView& map, const TautRow& out,
                                             const TautRow& back,
                                             std::span<const Point> shortest_way, int count,
                                             const ShortestBetween& shortest, Poller& poller) {
  return Search(map, out, back, shortest_way, poller).run(count, shortest);
}

}  // namespace lasius::exact
