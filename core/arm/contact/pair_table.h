// Two bodies with one or two joints between: for which values of these they keep apart.
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "core/arm/contact/pair_tests.h"
#include "core/base/poller.h"

namespace lasius::arm {

/// Two shapes that must not touch, of bodies by number: 0 is the base, i moves with joint i - 1.
struct ShapePair {
  const Shape* a;
  const Shape* b;
  int body, from;  // of a and of b, which is below
};

/// Cells of joint values, from a sixteenth of the range on halved three times; each is looked at
/// when a motion first comes by, and says the same whoever asks. Thread-safe.
class PairTable {
 public:
  /// Precondition: `pair.body` is `pair.from` + 1 or 2. `arm` and the shapes outlive it.
  PairTable(const Kinematics& arm, const ShapePair& pair, double clearance);

  /// From where to where of the way, 0 to 1, the two may be nearer than the clearance while their
  /// joints go straight; the first is above the last where they never are.
  struct Doubt {
    double first = 2, last = -1;
  };
  /// All of it where `poller`, who is told of the work, says to stop.
  Doubt doubt(std::span<const double> from, std::span<const double> to, Poller& poller) const;

 private:
  static constexpr int kCoarse = 16, kLevels = 4, kFine = kCoarse << (kLevels - 1);
  enum State : char { unknown, free, open };

  bool cell_free(int level, int x, int y, Poller& poller) const;
  /// Unknown where told to stop.
  State look(int level, int x, int y, Poller& poller) const;

  const Kinematics& arm_;
  ShapePair pair_;
  int joints_;
  double clearance_;
  std::array<double, 2> low_, width_;  // of the finest cells
  std::array<bool, 2> round_;          // the joint turns: values a turn apart are alike
  mutable std::array<std::vector<std::atomic<char>>, kLevels> states_;
};

}  // namespace lasius::arm
