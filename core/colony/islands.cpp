#include "core/colony/islands.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/stored_arrays.h"
#include "core/loop/run_status.h"

namespace lasius {

Islands::Islands(const Grid& grid, const Params& params, ColonyMemory& memory,
                 const disc::DiscSpace* disc, const cost::Terrain* terrain, Part part,
                 const Ranks* ranks, TourBoard* board)
    : params_(params),
      ranks_(ranks),
      board_(board),
      threads_(board != nullptr ? 1 : thread_count(params.threads)) {
  if (ranks != nullptr) require_ranks(*ranks, false);
  const auto count = static_cast<std::size_t>(params.islands);
  news_.resize(count);
  if (memory.islands.size() < count) memory.islands.resize(count);
  auto of_island = memory.islands.begin();
  int first_ant = 0;
  for (int i = 0; i < params.islands; ++i, ++of_island) {
    Params share = params;
    share.ants = params.ants / params.islands + (i < params.ants % params.islands ? 1 : 0);
    share.threads = 1;
    const int ants = share.ants;
    const bool own = part.has(i);
    for (int a = 0; a < ants && (own || ranks != nullptr); ++a) places_.push_back({i, a});
    news(i).ants.resize(static_cast<std::size_t>(ants));
    news(i).whole.settled = own ? 0 : 1;  // until more is heard of it
    if (own) islands_.emplace_back(i, grid, std::move(share), *of_island, first_ant, disc, terrain);
    first_ant += ants;
  }
}

StopCondition::Cause Islands::walk(const Request& request, const Observer& observer,
                                   Convergence& run) {
  stop_ = request.stop;
  for_each([&](Island& island) {
    island.colony.begin(request);
    island.colony.set_out(request, observer);
  });
  // Ranks stop at one iteration, by what was told there.
  return run_colony_loop(*this, params_.iterations,
                         ranks_ == nullptr ? request.stop : StopCondition{}, run);
}

Result Islands::run(const Request& request, const Observer& observer) {
  Convergence run;
  const auto cause = walk(request, observer, run);
  return result_after(cause, std::move(run), best_of(ranks_, found()));
}

template <class Do>
void Islands::for_each(const Do& act) {
  parallel_for(static_cast<int>(islands_.size()), threads_,
               [&](int i, int) { act(islands_[static_cast<std::size_t>(i)]); });
}

void Islands::exchange_tours() {
  if (board_ != nullptr) {
    for (const Island& island : islands_) board_->offer(island.colony.best_tour());
    for (Island& island : islands_) board_->teach(island.colony);
    return;
  }
  for (Island& island : islands_) {
    const News& before = news((island.number + params_.islands - 1) % params_.islands);
    island.colony.welcome({before.best_tour, before.whole.best_tour});
  }
}

StopCondition::Cause Islands::send_ants(int q) {
  if (exchange_at(q)) exchange_tours();
  auto told = observed_;
  if (board_ != nullptr) told = board_->poll();
  if (ranks_ != nullptr && told == StopCondition::Cause::none) told = stop_.poll();
  for_each([this, q, told](Island& island) {
    auto cause = told;
    if (cause == StopCondition::Cause::none) {
      cause = island.colony.send_ants(q);
      if (cause == StopCondition::Cause::none) {
        island.colony.offer();
        island.colony.update_trail(q);
      } else {
        island.colony.offer_cut();
      }
    }
    tell(island, cause, board_ == nullptr && exchange_at(q + 1));
  });
  if (ranks_ != nullptr) told = share_news(told);
  for (Island& island : islands_)
    if (leader_ == nullptr || island.colony.best_path().shorter_than(leader_->best_path()))
      leader_ = &island.colony;
  for (const News& one : news_)
    if (one.whole.cause != StopCondition::Cause::none) return one.whole.cause;
  return told;
}

void Islands::tell(Island& island, StopCondition::Cause cause, bool with_tour) {
  GridColony& colony = island.colony;
  News& to = news(island.number);
  to.whole.cause = cause;
  if (cause != StopCondition::Cause::none) return;
  to.whole = {.cause = cause,
              .settled = colony.settled() ? 1 : 0,
              .best = colony.best_length(),
              .iteration_best = colony.iteration_best(),
              .trail_entropy = colony.trail_entropy(),
              .best_tour = kNaN};
  for (int a = 0; a < colony.ants(); ++a)
    to.ants[static_cast<std::size_t>(a)] = {colony.tour_length(a), *colony.walked(a)};
  if (!with_tour) return;
  const Tour tour = colony.best_tour();
  to.whole.best_tour = tour.length;
  to.best_tour.assign(tour.moves.begin(), tour.moves.end());
}

StopCondition::Cause Islands::share_news(StopCondition::Cause told) {
  ArrayWriter own;
  own.value(told);
  for (const Island& island : islands_) {
    const News& one = news(island.number);
    own.value(one.whole);
    own.array(one.ants);
    own.array(one.best_tour);
  }
  const std::vector<std::string> all = gather(*ranks_, own.text());
  auto first = StopCondition::Cause::none;
  for (int rank = 0; rank < ranks_->count; ++rank) {
    ArrayReader from = told_by(all[static_cast<std::size_t>(rank)], rank);
    const bool other = rank != ranks_->own, ended = other && from.at_end();
    auto cause = told;
    if (ended) {  // the own deadline is near
      cause = stop_.poll();
      if (cause == StopCondition::Cause::none) cause = StopCondition::Cause::deadline;
    } else if (other) {
      cause = from.value<StopCondition::Cause>();
    }
    if (first == StopCondition::Cause::none) first = cause;
    if (!other || ended) continue;
    for (int i = rank; i < params_.islands; i += ranks_->count) {
      news(i).whole = from.value<News::Whole>();
      auto ants = from.array<News::OfAnt>();
      from.require(ants.size() == news(i).ants.size());
      news(i).ants = std::move(ants);
      news(i).best_tour = from.array<std::uint8_t>();
    }
    from.require(from.at_end());
  }
  return first;
}

FoundPath Islands::found() {
  Island* best = nullptr;
  for (Island& island : islands_)
    if (best == nullptr || island.colony.best_path().shorter_than(best->colony.best_path()))
      best = &island;
  FoundPath path;
  if (best == nullptr || best->colony.best_path().none()) return path;
  path.rank = {best->colony.best_path().length(), best->number};
  path.points = best->colony.best_path().give();
  return path;
}

IterationSums::Values Islands::entropies() const {
  IterationSums::Values all;
  for (const News& one : news_) all.add(IterationSums::Values::of(one.whole.trail_entropy));
  return all;
}

double Islands::best_length() const {
  double best = kNaN;
  for (const News& one : news_) best = std::fmin(best, one.whole.best);
  return best;
}

double Islands::iteration_best() const {
  double best = kNaN;
  for (const News& one : news_) best = std::fmin(best, one.whole.iteration_best);
  return best;
}

bool Islands::settled() {
  return std::ranges::all_of(news_, [](const News& one) { return one.whole.settled != 0; });
}

StopCondition::Cause Islands::observe(const Convergence& run) {
  const auto cause = leader_ != nullptr ? leader_->observe(run) : StopCondition::Cause::none;
  if (board_ != nullptr) {
    course_.push_back(sums_of(*this));
    course_.back().entropies = entropies();
  }
  if (ranks_ == nullptr) return cause;
  observed_ = cause;
  return StopCondition::Cause::none;
}

}  // namespace lasius
