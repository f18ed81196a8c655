// Published updates rebuilt from the public interface alone, as a caller would write them.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "kernels/base/power.h"
#include "lasius/params/own_rules.h"
#include "lasius/params/params.h"

namespace lasius {

inline void deposit_of_all(const Params& p, Pheromone& trail, const IterationTours& tours) {
  trail.persist(p.persistence);
  for (int a = 0; a < tours.ants(); ++a) {
    if (tours.arrived(a)) trail.add(tours.places_of(a), p.deposit / tours.lengths[a]);
  }
}

inline void elitist(const Params& p, Pheromone& trail, const IterationTours& tours) {
  deposit_of_all(p, trail, tours);
  if (tours.best_length > 0)
    trail.add(tours.best_places(), p.elite_weight * p.deposit / tours.best_length);
}

inline void rank_based(const Params& p, Pheromone& trail, const IterationTours& tours) {
  trail.persist(p.persistence);
  for (int r = 1; r < p.ranks && r <= std::ssize(tours.ranked); ++r) {
    const int ant = tours.ranked[r - 1];
    trail.add(tours.places_of(ant), (p.ranks - r) * p.deposit / tours.lengths[ant]);
  }
  if (tours.best_length > 0)
    trail.add(tours.best_places(), p.ranks * p.deposit / tours.best_length);
}

inline void max_min(const Params& p, Pheromone& trail, const IterationTours& tours) {
  trail.persist(p.persistence);
  if (!(tours.best_length > 0)) return;
  const bool so_far = tours.ranked.empty() ||
                      (p.best_so_far_every > 0 && (tours.iteration + 1) % p.best_so_far_every == 0);
  const double most = p.deposit / ((1 - p.persistence) * tours.best_length);
  const auto moves = static_cast<double>(tours.best_cells().size() - 1);
  const double all_right = kernels::power(p.best_probability, 1.0 / moves);
  const double choice = tours.moves / 2.0;
  trail.clamp(std::min(most, most * (1 - all_right) / ((choice - 1) * all_right)), most);
  const int best = so_far ? 0 : tours.ranked[0];
  trail.add(so_far ? tours.best_places() : tours.places_of(best),
            p.deposit / (so_far ? tours.best_length : tours.lengths[best]));
}

inline void colony_system(const Params& p, Pheromone& trail, const IterationTours& tours) {
  if (!(tours.best_length > 0)) return;
  const double kept = p.persistence, target = p.deposit / tours.best_length;
  std::vector<double> tau(tours.best_places().size());
  trail.get(tours.best_places(), tau);
  for (double& t : tau) t = kept * t + (1 - kept) * target;
  trail.set(tours.best_places(), tau);
}

/// Cong & Ponnambalam 2009, eq. 3 and 4, as Update::learning reads them.
inline void learning(const Params& p, Pheromone& trail, const IterationTours& tours) {
  for (int a = 0; a < tours.ants(); ++a) {
    trail.persist(p.persistence);
    auto cells = tours.cells_of(a);
    const double share = tours.height / tours.lengths[a];
    if (!tours.arrived(a)) cells = cells.subspan(cells.size() / 2);  // from the middle move on
    std::vector<double> tau(cells.size()), eta(cells.size());
    trail.get(cells, tau);
    trail.get_learned(cells, eta);
    for (double& t : tau) t = tours.arrived(a) ? t * (1 + p.reward * share) : t * p.penalty;
    for (double& e : eta) e = tours.arrived(a) ? e + share : e * p.penalty;
    trail.set(cells, tau);
    trail.set_learned(cells, eta);
  }
}

/// The update of an algorithm that is rebuilt here.
inline OwnRules rebuilt(const Params& p) {
  const auto with = [&p](auto rule) {
    return OwnRules{.update = [p, rule](Pheromone& trail, const IterationTours& tours) {
      rule(p, trail, tours);
    }};
  };
  const std::string_view name = p.algorithm();
  if (name == "as") return with(deposit_of_all);
  if (name == "eas") return with(elitist);
  if (name == "ras") return with(rank_based);
  if (name == "mmas") return with(max_min);
  if (name == "acs") return with(colony_system);
  if (name == "cong2009") return with(learning);
  return {};
}

}  // namespace lasius
