// Paths of stops that grow together to one.
#pragma once

#include <array>
#include <functional>
#include <numeric>
#include <vector>

namespace lasius::tour {

/// For each stop its neighbours, and for an end of a path the other end: at first each is alone.
struct Fragments {
  explicit Fragments(int n) : side(n, {-1, -1}), other(n) {
    std::iota(other.begin(), other.end(), 0);
  }
  bool full(int v) const { return side[v][1] >= 0; }
  bool joins(int a, int b) const { return !full(a) && !full(b) && other[a] != b; }
  void join(int a, int b) {
    side[a][side[a][0] >= 0] = b;
    side[b][side[b][0] >= 0] = a;
    const int ea = other[a], eb = other[b];
    other[ea] = eb;
    other[eb] = ea;
  }
  std::vector<std::array<int, 2>> side;
  std::vector<int> other;
};

/// All stops: from the first end on path by path, each time to the end that is the least away.
std::vector<int> order_of(const Fragments& parts, const std::function<double(int, int)>& away);

}  // namespace lasius::tour
