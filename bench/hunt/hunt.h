// Answers by the million, to small random problems, each judged by means that share nothing with
// the library; a problem with a wrong answer is cut down to a small one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/geometry.h"
#include "lasius/grid.h"

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

/// A kind of problem.
struct HuntKind {
  std::string_view name;
  std::string_view about;  ///< a line
  /// The same for the same seed, on every machine.
  HuntCase (*make)(std::uint64_t seed);
  /// Problems that are none, as where places are blocked, have no answers.
  HuntVerdict (*judge)(const HuntCase& problem);
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
HuntVerdict judge_shortest(const HuntCase& problem);
HuntVerdict judge_disc(const HuntCase& problem);
HuntVerdict judge_colony(const HuntCase& problem);
HuntVerdict judge_costs(const HuntCase& problem);
HuntVerdict judge_tour(const HuntCase& problem);
HuntVerdict judge_vehicle(const HuntCase& problem);
HuntVerdict judge_drive(const HuntCase& problem);
HuntVerdict judge_polygon(const HuntCase& problem);

}  // namespace lasius::bench
