// The least length of tours over few stops, by the sets of tasks that are done: slow and simple.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace lasius::oracle {

/// Of a `lasius::TourRequest`, or what has its members, without a look at the stops themselves. Two
/// to the power of the tasks, times the square of the stops.
template <class Request>
class LeastTour {
 public:
  /// `legs`: a length from each stop to each, row by row. Holds `request`.
  LeastTour(const Request& request, std::vector<double> legs)
      : request_(request),
        legs_(std::move(legs)),
        count_(static_cast<std::size_t>(std::lround(std::sqrt(legs_.size())))),
        before_(count_, 0) {
    std::map<int, int> tasks;
    for (std::size_t i = 0; i < count_; ++i) {
      const int own = -1 - static_cast<int>(i);
      const int group = request.group.empty() || request.group[i] < 0 ? own : request.group[i];
      task_.push_back(
          Set{1} << tasks.try_emplace(group, static_cast<int>(tasks.size())).first->second);
    }
    all_ = (Set{1} << tasks.size()) - 1;
    for (std::size_t i = 0; i < request.after.size(); ++i)
      for (const int before : request.after[i]) before_[i] |= task(before);
  }

  /// Infinite where there is no tour.
  double length() const {
    if (!request_.robots.empty()) return of_robots();
    // A closed tour may begin anywhere, unless what has been before counts.
    const bool anywhere = !request_.open && request_.after.empty() && !request_.capacity;
    double least = kNever;
    for (int first = 0; first < static_cast<int>(count_); ++first)
      if (request_.start ? first == *request_.start : !anywhere || task(first) == task(0))
        least = std::min(least, from(first)[all_]);
    return least;
  }

 private:
  using Set = std::size_t;  ///< of tasks, a bit each
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  Set task(int stop) const { return task_[static_cast<std::size_t>(stop)]; }

  /// Each robot takes any of the tasks that those before it left.
  double of_robots() const {
    std::vector<double> shared(all_ + 1, kNever);
    Set begun = 0;
    for (const int start : request_.robots) begun |= task(start);
    shared[begun] = 0;
    for (const int start : request_.robots) {
      const std::vector<double> own = from(start);
      std::vector<double> more(all_ + 1, kNever);
      for (Set done = begun; done <= all_; ++done)
        for (Set left = all_ & ~done, taken = left;; taken = (taken - 1) & left) {
          if (request_.most_stops == 0 || std::popcount(taken) <= request_.most_stops)
            more[done | taken] =
                std::min(more[done | taken], shared[done] + own[taken | task(start)]);
          if (taken == 0) break;
        }
      shared = std::move(more);
    }
    return shared[all_];
  }

  /// Of tours that begin at a stop, by the tasks that are done.
  std::vector<double> from(int first) const {
    std::vector<double> least(all_ + 1, kNever), so_far((all_ + 1) * count_, kNever);
    const auto begin = static_cast<std::size_t>(first);
    if (may_follow(0, begin)) so_far[task(first) * count_ + begin] = 0;
    for (Set done = 1; done <= all_; ++done)
      for (std::size_t last = 0; last < count_; ++last) {
        const double sum = so_far[done * count_ + last];
        if (sum == kNever) continue;
        if (!request_.goal || static_cast<int>(last) == *request_.goal)
          least[done] =
              std::min(least[done], sum + (request_.open ? 0 : legs_[last * count_ + begin]));
        for (std::size_t next = 0; next < count_; ++next) {
          if (!may_follow(done, next)) continue;
          double& known = so_far[(done | task_[next]) * count_ + next];
          known = std::min(known, sum + legs_[last * count_ + next]);
        }
      }
    return least;
  }

  bool may_follow(Set done, std::size_t stop) const {
    if ((done & task_[stop]) != 0 || (before_[stop] & ~done) != 0) return false;
    if (!request_.capacity || request_.load.empty()) return true;
    std::int64_t carried = request_.load[stop];
    for (std::size_t i = 0; i < count_; ++i)
      if ((done & task_[i]) != 0) carried += request_.load[i];
    return carried <= *request_.capacity;
  }

  const Request& request_;
  std::vector<double> legs_;
  std::size_t count_;
  std::vector<Set> task_, before_;  ///< of each stop: its own, and what has to be done before
  Set all_;
};

}  // namespace lasius::oracle
