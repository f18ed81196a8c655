// Colonies split into islands, on ranks that are threads of one process.
#pragma once

#include <gtest/gtest.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "core/colony/grid_colony.h"
#include "lasius/base/error.h"
#include "lasius/params/own_rules.h"
#include "tests/worlds/planning.h"

namespace lasius {

inline Params split(std::string_view algorithm, int islands) {
  Params params = quick(algorithm);
  params.ants = 7;
  params.iterations = 7;
  params.islands = islands;
  return params;
}

/// Ranks that are threads: each gets what all have handed in, or told.
class Meeting {
 public:
  explicit Meeting(int ranks)
      : handed_in_(static_cast<std::size_t>(ranks)), told_(handed_in_.size()), here_(ranks) {}

  Ranks rank(int own) {
    return {own, static_cast<int>(handed_in_.size()),
            [this, own](std::string text) { return gather(own, std::move(text)); },
            [this, own](const std::string& text) { return pass(own, text); }};
  }
  /// Once it ends, this one comes no more.
  struct Leaving {
    Meeting& meeting;
    int own;
    ~Leaving() { meeting.leave(own); }
  };

 private:
  void leave(int own) {
    const std::lock_guard lock(mutex_);
    handed_in_[static_cast<std::size_t>(own)].clear();
    --here_;
    meet();
  }
  std::vector<std::string> gather(int own, std::string text) {
    std::unique_lock lock(mutex_);
    handed_in_[static_cast<std::size_t>(own)] = std::move(text);
    ++waiting_;
    const int number = number_;
    meet();
    met_.wait(lock, [&] { return number_ != number; });
    return all_;
  }
  std::vector<std::string> pass(int own, const std::string& text) {
    const std::lock_guard lock(mutex_);
    const auto r = static_cast<std::size_t>(own);
    for (std::size_t other = 0; other < told_.size() && !text.empty(); ++other)
      if (other != r) told_[other].push_back(text);
    return std::exchange(told_[r], {});
  }
  void meet() {
    if (waiting_ < here_) return;
    all_ = handed_in_;
    for (auto& texts : told_) texts.clear();
    waiting_ = 0;
    ++number_;
    met_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable met_;
  std::vector<std::string> handed_in_, all_;
  std::vector<std::vector<std::string>> told_;  // by who hears it
  int here_, waiting_ = 0, number_ = 0;
};

/// The answer of each rank; `as(rank, request)` may change what one is asked.
inline std::vector<Result> plan_on_ranks(int count, const Params& params,
                                         const std::function<void(int, Request&)>& as = {},
                                         const Observer& observer = {}) {
  std::vector<Result> results(static_cast<std::size_t>(count));
  Meeting meeting(count);
  std::vector<std::jthread> threads;
  threads.reserve(results.size());
  for (int r = 0; r < count; ++r)
    threads.emplace_back([&, r] {
      const Meeting::Leaving leaving{meeting, r};
      FarApart far;
      const Ranks rank = meeting.rank(r);
      far.request.ranks = &rank;
      if (as) as(r, far.request);
      EXPECT_NO_THROW(results[static_cast<std::size_t>(r)] =
                          far.plan(params, {.observer = observer}));
    });
  threads.clear();
  return results;
}

/// The remedy that one rank is told; empty where it is not refused.
inline std::string remedy_of(const Params& params, const Ranks& rank) {
  FarApart far;
  far.request.ranks = &rank;
  try {
    (void)far.plan(params);
  } catch (const Error& error) {
    return error.remedy();
  }
  return {};
}

/// The steps by iteration of colonies that are a run's islands, joined every other iteration.
inline std::vector<std::int64_t> steps_by_hand(
    const FarApart& far, const Params& params,
    const std::function<void(std::list<GridColony>&)>& exchange) {
  const int islands = params.islands;
  std::list<ColonyMemory> memory(static_cast<std::size_t>(islands));
  std::list<Params> shares;
  std::list<GridColony> colonies;
  const Observer none;
  int first_ant = 0;
  for (ColonyMemory& one : memory) {
    const bool more = std::ssize(shares) < params.ants % islands;
    Params& share = shares.emplace_back(params);
    share.islands = 1;
    share.ants = params.ants / islands + (more ? 1 : 0);
    colonies.emplace_back(far.planner.grid(), share, one, no_own_rules(),
                          GridColony::After::nothing, nullptr, nullptr, first_ant);
    first_ant += share.ants;
    colonies.back().begin(far.request);
    colonies.back().set_out(far.request, none);
  }
  std::vector<std::int64_t> steps;
  for (int q = 0; q < params.iterations; ++q) {
    if (q > 0 && q % 2 == 0) exchange(colonies);
    std::int64_t sum = 0;
    for (GridColony& colony : colonies) {
      EXPECT_EQ(colony.send_ants(q), StopCondition::Cause::none);
      colony.offer();
      colony.update_trail(q);
      for (int a = 0; a < colony.ants(); ++a) sum += colony.walked(a)->steps;
    }
    steps.push_back(sum);
  }
  return steps;
}

}  // namespace lasius
