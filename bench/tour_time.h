// Tours by time: what a run had at marks of its processor time.
#pragma once

#include <array>
#include <cstdint>

#include "bench/clocks.h"
#include "bench/query_set.h"

namespace lasius::bench {

constexpr std::array<double, 4> kShares{0.03, 0.1, 0.3, 1};  // of the time of a run

/// The costs that a run had at the marks; 0: none yet.
using Marks = std::array<std::int64_t, kShares.size()>;

/// What a mark is above a cost, per cent; NaN without one.
inline double percent_above(std::int64_t mark, std::int64_t best) {
  return mark == 0 ? kUnknown
                   : 100.0 * static_cast<double>(mark - best) / static_cast<double>(best);
}

/// The processor time of a run, from its construction.
class TourTime final : public ThreadTime {
 public:
  explicit TourTime(double seconds) : seconds_(seconds) {}
  StopCondition stop() const {
    return {.deadline = deadline_in(std::chrono::duration<double>(seconds_), {}), .time = this};
  }
  void tell(std::int64_t cost, Marks& marks) const {
    for (std::size_t i = 0; i < kShares.size(); ++i)
      if (used() <= kShares[i] * seconds_ && (marks[i] == 0 || cost < marks[i])) marks[i] = cost;
  }

 private:
  double seconds_;
};

}  // namespace lasius::bench
