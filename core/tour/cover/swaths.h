// Swaths that cover a map, by one heading or the best of several.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/cover/cover_ground.h"
#include "core/tour/cover/near_ends.h"
#include "core/tour/cover/tool_lines.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/plan/planner.h"

namespace lasius::tour {

struct Swath {
  Point from, to;
  double length() const noexcept;
};

/// At most what the legs between swaths sum up to, straight: half the sum of the ways from each end
/// to the nearest end of another; where the tour is open, without the two longest.
double ways_between(const std::vector<Swath>& swaths, bool open = false);

/// Swaths, all in the region of the ground.
struct SwathPlan {
  static constexpr int kMost = 10'000;  ///< swaths that are brought in order

  Heading heading;
  std::vector<Swath> swaths;
  std::vector<EndLink> links = {};  ///< near_ends of these swaths; none where some were dropped
  bool cut = false;                 ///< not all was looked at in time
  /// Of the tour: the swaths, the ways between them as chained() has them, and the area that is
  /// left, as if it took six swaths to cover it. Cells; of too many swaths their number.
  double estimate = 0;
  bool too_many() const noexcept { return swaths.size() > kMost; }
};

enum class Laid {
  fitted,    ///< evenly in each cell of the decomposition, a half width from its walls
  anywhere,  ///< evenly over the whole map
};

/// What plans of several headings share.
class SwathMaker {
 public:
  /// Holds references. `clear`: as for near_ends.
  SwathMaker(const Planner& planner, const Grid& clear, const ToolLines& lines,
             const CoverGround& ground)
      : planner_(planner),
        clear_(clear),
        lines_(lines),
        ground_(ground),
        width_(2 * ground.half_width()) {}

  /// Empty if `laying` stops it; `stop` leaves gaps as they are.
  std::optional<SwathPlan> plan(const Heading& heading, Laid laid, const StopCondition& laying,
                                const StopCondition& stop) const;
  /// The plan of least estimate of those that are made in time, on threads that do not matter to
  /// it; one of too many swaths where all are. `first` alone ends the first one; empty if it does.
  std::optional<SwathPlan> best(int threads, const StopCondition& first,
                                const StopCondition& stop) const;

 private:
  std::vector<Swath> fitted(const Heading& heading, Poller& poller) const;
  std::vector<Swath> anywhere(const Heading& heading, Poller& poller) const;
  void add_line(const Heading& heading, double c, std::vector<Swath>& swaths) const;
  bool reached(const Swath& swath) const;
  std::vector<int> joined_swaths(const SwathPlan& plan) const;
  void drop_apart(SwathPlan& plan, int threads, const StopCondition& stop) const;

  const Planner& planner_;
  const Grid& clear_;
  const ToolLines& lines_;
  const CoverGround& ground_;
  double width_;
};

/// How often each sample is within half a width of a swath.
class SwathCounts {
 public:
  explicit SwathCounts(const CoverGround& ground)
      : ground_(ground), counts_(static_cast<std::size_t>(ground.samples()), 0) {}

  void add(const Swath& swath, int by = 1);
  int of(std::int64_t sample) const noexcept { return counts_[sample]; }
  bool open(std::int64_t sample) const noexcept {
    return counts_[sample] == 0 && ground_.wanted(sample);
  }
  /// Wanted samples that at least so many swaths cover.
  std::int64_t covered(int at_least = 1) const noexcept;
  /// Those of a swath that none covers.
  std::int64_t gain(const Swath& swath) const;

 private:
  const CoverGround& ground_;
  std::vector<std::uint16_t> counts_;
};

/// Adds swaths along the heading and across it for what is not covered, the most worthwhile first,
/// as long as they cover a tenth of what as much length can, or until stopped.
void fill_gaps(const ToolLines& lines, const CoverGround& ground, const Heading& heading,
               const std::function<bool(const Swath&)>& reached, SwathCounts& counts,
               std::vector<Swath>& swaths, Poller& poller);
/// Cuts swaths back to what they alone cover, the shortest first; drops those that are left none.
/// Stopped, the others stay.
void cut_back(const ToolLines& lines, const CoverGround& ground, SwathCounts& counts,
              std::vector<Swath>& swaths, Poller& poller);

}  // namespace lasius::tour
