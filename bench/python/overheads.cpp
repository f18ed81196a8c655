// The C++ side of overheads.py: seconds of a batch, microseconds of a call, seconds of a map; one
// line each.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "lasius/lasius.h"

namespace {

using namespace lasius;

template <class Work>
double seconds(const Work& work) {
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The queries of overheads.py: between free cells, taken in order of rows.
std::vector<Request> queries(const Grid& grid) {
  std::vector<Cell> free;
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x)
      if (grid.free({x, y})) free.push_back({x, y});
  std::vector<Request> requests;
  for (std::uint64_t i = 0; i < 10000; ++i)
    requests.push_back({free[i * 7919 % free.size()], free[i * 104729 % free.size()]});
  return requests;
}

std::vector<std::uint8_t> large_array() {
  std::vector<std::uint8_t> cells;
  for (int y = 0; y < 4096; ++y)
    for (int x = 0; x < 4096; ++x) cells.push_back((x / 64 * 7 + y / 64 * 13) % 11 == 0);
  return cells;
}

}  // namespace

int main() {
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  const auto requests = queries(planner.grid());
  constexpr int kCalls = 2000, kMaps = 15;
  std::size_t answers = 0;
  const double batch =
      seconds([&] { answers += plan_batch(planner, requests, {}, {.threads = 1}).size(); });
  const double calls = seconds([&] {
    for (int i = 0; i < kCalls; ++i)
      answers += planner.plan({.start = {14, 14}, .goal = {14, 14}}).path.size();
  });
  const auto cells = large_array();
  double map = 1e9;
  for (int i = 0; i < kMaps; ++i) {
    map = std::min(
        map, seconds([&] {
          answers +=
              Planner(Grid(4096, 4096, cells, Nonzero::blocked)).grid().free({64, 0}) ? 1U : 0U;
        }));
  }
  std::printf("%.9g\n%.9g\n%.9g\n", batch, calls / kCalls * 1e6, map);
  return answers == requests.size() + kCalls + kMaps ? 0 : 1;
}
