// Numbers for problems, and what many of their judges ask of a path.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <sstream>
#include <string>

#include "bench/hunt/hunt.h"
#include "tests/oracle/plane_rule.h"

namespace lasius::bench {

/// Numbers that are the same everywhere.
class HuntDraw {
 public:
  explicit HuntDraw(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t any() { return engine_(); }
  int between(int least, int most) {
    return least + static_cast<int>(engine_() % static_cast<std::uint64_t>(most - least + 1));
  }
  bool one_in(int chances) { return between(1, chances) == 1; }
  /// In [least, most), a multiple of 2^-12 of the width.
  double real(double least, double most) {
    return least + (most - least) * between(0, 4095) / 4096.0;
  }
  template <class T, std::size_t N>
  const T& pick(const std::array<T, N>& of) {
    return of[static_cast<std::size_t>(between(0, static_cast<int>(N) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

/// A sentence of words and numbers.
template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  text.precision(17);
  (text << ... << parts);
  return text.str();
}
inline std::string told(Point p) { return sentence('(', p.x, ", ", p.y, ')'); }

/// Whether two lengths are the same, but for rounding.
inline bool same_length(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-9 * (1 + std::abs(a));
}

/// Why a path is none from start to goal of that length; empty where it is one.
inline std::string path_fault(const Grid& grid, std::span<const Point> path, Point start,
                              Point goal, double length) {
  if (path.empty() || path.front() != start || path.back() != goal)
    return "a path that does not join start and goal";
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  if (!same_length(sum, length)) return sentence("length ", length, " of a path of ", sum);
  return rule::Checker(grid).obeys(path) ? "" : "a path through what is blocked";
}

}  // namespace lasius::bench
