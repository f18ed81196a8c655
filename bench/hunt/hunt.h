// Answers by the million, to small random problems, each judged by means that share nothing with
// the library; a problem with a wrong answer is cut down to a small one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::bench {

/// A problem. What is asked about it, and with which parameters, is drawn from `seed`.
struct HuntCase {
  Grid grid;
  std::vector<Cell> places;  ///< at least two, free
  std::uint64_t seed = 0;
};

/// What came of a problem.
struct HuntVerdict {
  std::int64_t answers = 0;  ///< that were judged
  std::string fault = {};    ///< the first that was found; empty for none

  /// One more answer was judged; `what` is called only where it is wrong.
  template <class What>
  void expect(bool right, const What& what) {
    ++answers;
    if (!right && fault.empty()) fault = what();
  }
};

class HuntDraw;
/// Asks about a problem, by draws, and judges the answers.
using HuntJudge = void(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict);

/// A kind of problem.
struct HuntKind {
  std::string_view name;
  std::string_view about;  ///< a line
  /// The same for the same seed, on every machine.
  HuntCase (*make)(std::uint64_t seed);
  HuntJudge* ask;

  /// Problems that are none, as where places are blocked, have no answers.
  HuntVerdict judge(const HuntCase& problem) const;
};
std::span<const HuntKind> hunt_kinds();
/// @throws std::out_of_range for an unknown name
const HuntKind& hunt_kind(std::string_view name);

/// The problem with rows, columns and places taken out and cells freed, as long as it stays
/// `faulty`; asks at most `most` times.
HuntCase reduced(HuntCase problem, const std::function<bool(const HuntCase&)>& faulty,
                 int most = 5000);

/// The problem as a test that fails while the fault is there.
std::string as_test(const HuntKind& kind, const HuntCase& problem);

// Each in a file of its own.
HuntJudge judge_shortest, judge_disc, judge_colony, judge_costs, judge_tour, judge_vehicle,
    judge_drive, judge_polygon;

}  // namespace lasius::bench
