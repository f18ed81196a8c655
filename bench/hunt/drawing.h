// Numbers for problems, and what many of their judges ask of a path.
#pragma once

#include <array>
#include <cstddef>
#include <random>
#include <sstream>
#include <string>

#include "bench/hunt/hunt.h"
#include "tests/oracle/whole_path.h"

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

using rule::path_fault, rule::same_length;

}  // namespace lasius::bench
