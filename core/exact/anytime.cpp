#include "core/exact/anytime.h"

#include <algorithm>
#include <cmath>

#include "lasius/path/path.h"

namespace lasius::exact {

namespace {

// A deadline gives both searches the same time until the bounding one has done so much work (words,
// half a second), less from then on. Who may only look on or press a key waits longer.
constexpr double kEvenShare = 1;
constexpr double kLateShare = 1.0 / 8;
constexpr double kLate = 1 << 26;
constexpr double kSmallShare = 1.0 / 64;
// Work of one turn, about a millisecond.
constexpr double kTurn = 1 << 17;
// Under a deadline most of the time goes to a first path, in short turns: some are found at once.
constexpr double kUrgentShare = 4;
constexpr double kUrgentTurn = 1 << 14;
// A gap that leaves the rest of the time to the exact search.
constexpr double kSmallGap = 0.01;

}  // namespace

Anytime::Anytime(Memory& memory, const Grid& grid, Point start, Point goal,
                 const ExactOptions& options, const StopCondition& stop)
    : memory_(memory),
      grid_(grid),
      start_(start),
      goal_(goal),
      stop_(stop),
      told_(options.improved),
      tell_([this](const std::vector<Point>& path, double length, double bound) {
        return tell(path, length, bound);
      }),
      options_(options) {
  const bool deadline = stop.deadline != Clock::time_point::max();
  if (!deadline && !stop.token.stop_possible() && told_ == nullptr) return;
  share_ = deadline ? kEvenShare : kSmallShare;
  options_.improved = &tell_;
  options_.improved_once_polled = told_ == nullptr;
  options_.beside = this;
}

bool Anytime::tell(const std::vector<Point>& path, double length, double bound) {
  bound_ = std::max(bound_, bound);
  if (length >= length_) return true;
  length_ = length;
  memory_.path = path;
  return told_ == nullptr || (*told_)(path, length, bound_);
}

StopCondition::Cause Anytime::turn(std::int64_t work) {
  const bool first = work_ + owed_ == 0;  // what was found before is told after it
  const bool urgent = !first && share_ > kSmallShare && std::isinf(length_);
  owed_ += (urgent ? kUrgentShare : share_) * static_cast<double>(work);
  if (resting_ || owed_ < (urgent ? kUrgentTurn : kTurn)) return StopCondition::Cause::none;
  if (!begun_) memory_.search.begin_improving(grid_, start_, goal_);
  begun_ = true;
  work_ += owed_;
  if (work_ > kLate) share_ = std::min(share_, kLateShare);
  Poller poller(stop_, kWordsPerPoll);
  const bool more = memory_.search.improve(static_cast<std::int64_t>(owed_), poller);
  owed_ = 0;
  const double bound = rounded_down(memory_.search.lower());
  bool go_on = true;
  if (memory_.search.upper() < traced_) {
    traced_ = memory_.search.upper();
    memory_.search.trace(memory_.traced);
    go_on = tell(memory_.traced, path_length(memory_.traced), bound);
  }
  bound_ = std::max(bound_, bound);
  resting_ = !more || length_ - bound_ <= kSmallGap * bound_;
  return go_on ? poller.cause() : StopCondition::Cause::token;
}

void Anytime::merge(ExactAnswer& answer) const {
  if (answer.end != ExactEnd::stopped) return;
  if (!std::isfinite(length_)) {  // neither has a path
    answer.lower_bound = std::max(answer.lower_bound, bound_);
    return;
  }
  if (answer.path.empty() || length_ < answer.length) answer.path = memory_.path;
  const double bound = std::max(answer.lower_bound, bound_);
  conclude(bound, path_length(answer.path), answer.cause, options_.target_gap, answer);
  if (!answer.optimal) answer.lower_bound = bound;  // which leaves room for rounding already
}

}  // namespace lasius::exact
