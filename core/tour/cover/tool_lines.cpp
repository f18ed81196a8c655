#include "core/tour/cover/tool_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lasius::tour {

namespace {

// A point keeps that away from corners that its line would touch; a disc may be that nearer, as
// the disc's own planner allows more.
constexpr double kTouch = 1e-3, kLeeway = 2e-10;
constexpr double kShortest = 10;  // of what a stretch is drawn in by
constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Meeting {
  double from = kInfinite, to = -kInfinite;
  void add(double t) noexcept {
    from = std::min(from, t);
    to = std::max(to, t);
  }
  void add(const Meeting& other) noexcept {
    from = std::min(from, other.from);
    to = std::max(to, other.to);
  }
  bool empty() const noexcept { return from > to; }
};

// Where from + t * slope lies between two values.
Meeting between(double from, double slope, double least, double most) noexcept {
  if (slope == 0) return from >= least && from <= most ? Meeting{-kInfinite, kInfinite} : Meeting{};
  const double a = (least - from) / slope, b = (most - from) / slope;
  return {std::min(a, b), std::max(a, b)};
}

Meeting in_box(const Heading& h, Point on, double x0, double y0, double x1, double y1) noexcept {
  const Meeting a = between(on.x, h.x, x0, x1), b = between(on.y, h.y, y0, y1);
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

}  // namespace

const std::vector<Heading>& headings() {
  static const std::vector<Heading> kAll = [] {
    struct Given {
      int x, y;
      double degrees;
    };
    std::vector<Heading> all;
    for (const auto& [x, y, degrees] :
         {Given{1, 0, 0}, Given{0, 1, 90}, Given{1, 1, 45}, Given{-1, 1, 135},
          Given{2, 1, 26.56505117707799}, Given{1, 2, 63.43494882292201},
          Given{-1, 2, 116.56505117707799}, Given{-2, 1, 153.43494882292202}}) {
      const double length = std::sqrt(1.0 * x * x + 1.0 * y * y);
      all.push_back({x / length, y / length, degrees});
    }
    return all;
  }();
  return kAll;
}

bool ToolLines::fits_tightly(double radius) noexcept {
  return radius > 0 && std::abs(2 * radius - std::round(2 * radius)) < 1e-9;
}

ToolLines::ToolLines(const Grid& grid, double radius)
    : width_(grid.width()),
      height_(grid.height()),
      radius_(radius),
      kept_(radius > 0 ? radius - kLeeway : kTouch),
      tight_(fits_tightly(radius)),
      first_run_{0} {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (grid.free({x, y})) continue;
      const int from = x;
      while (x < width_ && !grid.free({x, y})) ++x;
      runs_.push_back({from, x});
    }
    first_run_.push_back(static_cast<std::int64_t>(runs_.size()));
  }
}

Point ToolLines::settled(Point p) const noexcept {
  constexpr double kNear = 1e-6;
  if (radius_ > 0) return p;
  for (double* const v : {&p.x, &p.y})
    if (std::abs(*v - std::round(*v)) < kNear) *v = std::round(*v);
  return p;
}

Stretch ToolLines::extent(const Heading& heading) const noexcept {
  Meeting all;
  for (const double x : {0.0, 1.0 * width_})
    for (const double y : {0.0, 1.0 * height_}) all.add(heading.aside({x, y}));
  return {all.from, all.to};
}

// The run's cells grown by the radius are two boxes and four discs, together convex.
bool ToolLines::hull(const Heading& h, double c, const Run& run, int row,
                     Stretch& met) const noexcept {
  const Point on = h.at(0, c);
  Meeting all;
  for (const bool wide : {true, false}) {
    const double dx = wide ? kept_ : 0, dy = wide ? 0 : kept_;
    const Meeting box = in_box(h, on, run.from - dx, row - dy, run.end + dx, row + 1 + dy);
    if (!box.empty()) all.add(box);
  }
  for (const int x : {run.from, run.end})
    for (const int y : {row, row + 1}) {
      const Point corner{1.0 * x, 1.0 * y};
      const double off = h.aside(corner) - c, square = kept_ * kept_ - off * off;
      if (square < 0) continue;
      const double half = std::sqrt(square), t = h.along(corner);
      all.add(Meeting{t - half, t + half});
    }
  met = {all.from, all.to};
  return !all.empty();
}

void ToolLines::on_line(const Heading& h, double c, std::vector<Stretch>& places,
                        const Stretch& within) const {
  places.clear();
  const Point on = h.at(0, c);
  Meeting inside = in_box(h, on, kept_, kept_, width_ - kept_, height_ - kept_);
  inside = {std::max(inside.from, within.from), std::min(inside.to, within.to)};
  const double shortest = kShortest * kDrawnIn;
  if (!(inside.to - inside.from >= shortest)) return;
  const double y0 = on.y + inside.from * h.y, y1 = on.y + inside.to * h.y;
  const int first = std::max(0, static_cast<int>(std::floor(std::min(y0, y1) - kept_)) - 1);
  const int last = std::min(height_ - 1, static_cast<int>(std::floor(std::max(y0, y1) + kept_)));
  std::vector<Stretch> met;
  for (int y = first; y <= last; ++y) {
    const std::span<const Run> row = runs(y);
    if (row.empty()) continue;
    // The columns that the line passes while it is beside the row.
    Meeting near = between(on.y, h.y, y - kept_, y + 1 + kept_);
    near = {std::max(near.from, inside.from), std::min(near.to, inside.to)};
    if (near.empty()) continue;
    const double xa = on.x + near.from * h.x, xb = on.x + near.to * h.x;
    const double left = std::min(xa, xb) - kept_, right = std::max(xa, xb) + kept_;
    auto run = std::lower_bound(row.begin(), row.end(), left,
                                [](const Run& r, double x) { return r.end < x; });
    for (; run != row.end() && run->from <= right; ++run)
      if (Stretch one; hull(h, c, *run, y, one)) met.push_back(one);
  }
  std::sort(met.begin(), met.end(), [](const Stretch& a, const Stretch& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  const auto put = [&](double from, double to) {
    if (to - from < shortest) return;
    if (radius_ == 0 && h.straight())
      places.push_back({std::round(from), std::round(to)});  // sides of cells
    else
      places.push_back({from + kDrawnIn, to - kDrawnIn});
  };
  double free_from = inside.from;
  for (const Stretch& one : met) {
    put(free_from, std::min(one.from, inside.to));
    free_from = std::max(free_from, one.to);
  }
  put(free_from, inside.to);
}

bool ToolLines::straight_between(Point a, Point b) const {
  const double length = distance(a, b);
  if (length == 0) return true;
  const Heading way{(b.x - a.x) / length, (b.y - a.y) / length};
  std::vector<Stretch> places;
  constexpr double kBeyond = 20 * kDrawnIn;
  on_line(way, way.aside(a), places, {way.along(a) - kBeyond, way.along(b) + kBeyond});
  return std::any_of(places.begin(), places.end(), [&](const Stretch& place) {
    return place.from <= way.along(a) && way.along(b) <= place.to;
  });
}

}  // namespace lasius::tour
