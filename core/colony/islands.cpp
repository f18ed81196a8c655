#include "core/colony/islands.h"

#include <cmath>

namespace lasius {

Islands::Islands(const Grid& grid, const Params& params, ColonyMemory& memory,
                 const disc::DiscSpace* disc, const cost::Terrain* terrain)
    : params_(params), threads_(thread_count(params.threads)) {
  const auto count = static_cast<std::size_t>(params.islands);
  if (memory.islands.size() < count) memory.islands.resize(count);
  auto of_island = memory.islands.begin();
  int first_ant = 0;
  for (int i = 0; i < params.islands; ++i) {
    Params share = params;
    share.ants = params.ants / params.islands + (i < params.ants % params.islands ? 1 : 0);
    share.threads = 1;
    GridColony& colony =
        islands_.emplace_back(grid, std::move(share), *of_island++, first_ant, disc, terrain)
            .colony;
    for (int a = 0; a < colony.ants(); ++a) places_.push_back({&colony, a});
    first_ant += colony.ants();
  }
  leader_ = &islands_.front().colony;
}

Result Islands::run(const Request& request, const Observer& observer) {
  for_each([&](Island& island) {
    island.colony.begin(request);
    island.colony.set_out(request, observer);
  });
  Convergence run;
  const auto cause = run_colony_loop(*this, params_.iterations, request.stop, run);
  BestPath* best = nullptr;
  for (Island& island : islands_) {
    BestPath& found = island.colony.best_path();
    if (best == nullptr || found.shorter_than(*best)) best = &found;
  }
  return result_after(cause, std::move(run), best->give());
}

template <class Do>
void Islands::for_each(const Do& act) {
  parallel_for(params_.islands, threads_,
               [&](int i, int) { act(islands_[static_cast<std::size_t>(i)]); });
}

void Islands::exchange_tours() {
  const GridColony* before = &islands_.back().colony;
  for (Island& island : islands_) {
    island.colony.welcome(before->best_tour());
    before = &island.colony;
  }
}

StopCondition::Cause Islands::send_ants(int q) {
  if (q > 0 && q % params_.exchange_every == 0) exchange_tours();
  for_each([q](Island& island) { island.cause = island.colony.send_ants(q); });
  for (const Island& island : islands_)
    if (island.cause != StopCondition::Cause::none) return island.cause;
  return StopCondition::Cause::none;
}

void Islands::offer() {
  for (Island& island : islands_) island.colony.offer();
}
void Islands::offer_cut() {
  for (Island& island : islands_) island.colony.offer_cut();
}

void Islands::update_trail(int q) {
  for_each([q](Island& island) { island.colony.update_trail(q); });
  for (Island& island : islands_)
    if (island.colony.best_path().shorter_than(leader_->best_path())) leader_ = &island.colony;
}

double Islands::tour_length(int ant) const {
  const Place place = places_[static_cast<std::size_t>(ant)];
  return place.colony->tour_length(place.ant);
}
std::optional<ColonyWorld::Walked> Islands::walked(int ant) const {
  const Place place = places_[static_cast<std::size_t>(ant)];
  return place.colony->walked(place.ant);
}

double Islands::trail_entropy() const {
  double sum = 0;
  int count = 0;
  for (const Island& island : islands_) {
    const double entropy = island.colony.trail_entropy();
    if (std::isnan(entropy)) continue;
    sum += entropy;
    ++count;
  }
  return count > 0 ? sum / count : kNaN;
}

double Islands::iteration_best() const {
  double best = kNaN;
  for (const Island& island : islands_) best = std::fmin(best, island.colony.iteration_best());
  return best;
}

bool Islands::settled() const {
  return std::ranges::all_of(islands_,
                             [](const Island& island) { return island.colony.settled(); });
}

StopCondition::Cause Islands::observe(const Convergence& run) { return leader_->observe(run); }

}  // namespace lasius
