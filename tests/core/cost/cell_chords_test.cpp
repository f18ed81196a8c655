// Chords of a cell: values lowered obey every one of them.
#include "core/cost/cell_chords.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace lasius::cost {
namespace {

struct Boundary {
  const CellChords& chords;
  const std::vector<double>& values;

  /// At `t` of the way round, 0 to 1.
  std::pair<Point, double> at(double t) const {
    const double p = t * chords.places();
    const int low = std::min(static_cast<int>(p), chords.places() - 1);
    const int high = (low + 1) % chords.places();
    const double share = p - low;
    const Point a = chords.at(low), b = chords.at(high);
    return {{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)},
            values[low] + share * (values[high] - values[low])};
  }
};

TEST(CellChords, LoweredValuesObeyEveryChord) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  int lowered = 0;
  for (const int k : {2, 4, 8, 16, 32, 64}) {
    const CellChords chords(k);
    for (int i = 0; i < 60; ++i) {
      const double weight = 0.1 + 9 * unit(random), tilt = 2 * unit(random);
      // Nearly the distance from a point, as marching makes it, or anything.
      const Point from{3 * unit(random) - 1, 3 * unit(random) - 1};
      std::vector<double> values(chords.places());
      for (int p = 0; p < chords.places(); ++p) {
        values[p] = i % 3 == 0
                        ? tilt * weight * unit(random)
                        : weight * std::hypot(chords.at(p).x - from.x, chords.at(p).y - from.y);
      }
      const std::vector<double> before = values;
      std::vector<std::uint8_t> marks(chords.places());
      for (int round = 0; round < 2000; ++round) {
        if (!chords.lower(values.data(), weight, 1e-12, marks.data())) break;
        ++lowered;
      }
      for (int p = 0; p < chords.places(); ++p) EXPECT_LE(values[p], before[p]);
      EXPECT_LE(chords.excess(values.data(), weight), 1 + 1e-9);
      const Boundary boundary{chords, values};
      for (int c = 0; c < 3000; ++c) {
        const auto [a, at_a] = boundary.at(unit(random));
        const auto [b, at_b] = boundary.at(unit(random));
        EXPECT_LE(at_b - at_a, weight * std::hypot(a.x - b.x, a.y - b.y) + 1e-11);
      }
      if (values == before) continue;
      // What it was before did not obey.
      const double excess = chords.excess(before.data(), weight);
      EXPECT_GT(excess, 1);
      const Boundary high{chords, before};
      for (int c = 0; c < 3000; ++c) {
        const auto [a, at_a] = high.at(unit(random));
        const auto [b, at_b] = high.at(unit(random));
        EXPECT_LE(at_b - at_a, excess * weight * std::hypot(a.x - b.x, a.y - b.y) + 1e-11);
      }
    }
  }
  EXPECT_GT(lowered, 100);
}

TEST(CellChords, ReachIsTheLeastOverAnInterval) {
  const CellChords chords(4);
  const std::vector<double> values{1, 1.2, 1.1, 1.4, 1.3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  for (int interval = 0; interval < 4; ++interval) {
    double out[11 + 3];
    chords.reach(interval, values[interval], values[interval + 1], 2, out);
    for (int i = 0; i < 11; ++i) {
      double least = 1e9;
      for (int s = 0; s <= 10000; ++s) {
        const auto [at, value] = Boundary{chords, values}.at((interval + s / 10000.0) / 16);
        const Point to = chords.at((5 + i) % 16);
        least = std::min(least, value + 2 * std::hypot(at.x - to.x, at.y - to.y));
      }
      EXPECT_NEAR(out[i], least, 1e-6);
      EXPECT_LE(out[i], least + 1e-12);
    }
  }
}

}  // namespace
}  // namespace lasius::cost
