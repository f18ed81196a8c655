// How a trail changes after ants have walked: one function a published family, for any world.
//
// A world hands over its trail and its tours as two types:
//   Trail   evaporate(persistence)      tau <- persistence * tau everywhere
//           deposit(place, amount)      tau <- tau + amount
//           tau(place), set_tau(place, value)
//           bound(least, most)          tau is read as within these from now on (max_min)
//   Tours   ants                        range of tours in the order of the ants; a tour's `length`
//                                       is NaN unless it arrived
//           best_so_far                 a tour, its length NaN before an ant has arrived
//           along(tour, visit)          calls visit(place) for every place with pheromone on it
//           iteration, ranking          of max_min and the ranked families; ranking is scratch
//           choices(), moves_of(tour)   of max_min: moves out of a place, moves of a tour
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "kernels/base/power.h"
#include "lasius/params/params.h"

namespace lasius::trail_rules {

template <class Tour>
bool arrived(const Tour& tour) noexcept {
  return tour.length > 0;
}

template <class Trail, class Tours, class Tour>
void deposit(Trail& trail, const Tours& tours, const Tour& tour, double amount) {
  tours.along(tour, [&](const auto& place) { trail.deposit(place, amount); });
}

/// Indices of the arrived ants, shortest tour first, ties to the lower index.
template <class Tours>
std::span<const int> ranked(const Tours& tours) {
  std::vector<int>& order = tours.ranking;
  order.clear();
  for (int a = 0; a < static_cast<int>(tours.ants.size()); ++a) {
    if (arrived(tours.ants[a])) order.push_back(a);
  }
  std::ranges::sort(order, [&](int a, int b) {
    const double la = tours.ants[a].length, lb = tours.ants[b].length;
    return la != lb ? la < lb : a < b;
  });
  return order;
}

/// Dorigo, Maniezzo & Colorni 1996; Fan et al. 2004, eq. 2, 3: every arrived ant Q / L.
template <class Trail, class Tours>
void ant_system(Trail& trail, const TrailParams& params, const Tours& tours) {
  trail.evaporate(params.persistence);
  for (const auto& tour : tours.ants) {
    if (arrived(tour)) deposit(trail, tours, tour, params.deposit / tour.length);
  }
}

/// Elitist ant system (Dorigo & Stuetzle 2004, eq. 3.6): e Q / L on `best` too, the best tour so
/// far or another that the source names.
template <class Trail, class Tours, class Tour>
void elitist(Trail& trail, const TrailParams& params, const Tours& tours, const Tour& best) {
  ant_system(trail, params, tours);
  if (!arrived(best)) return;
  deposit(trail, tours, best, params.elite_weight * params.deposit / best.length);
}

/// Rank-based ant system (Bullnheimer, Hartl & Strauss 1999; Dorigo & Stuetzle 2004, eq. 3.8).
template <class Trail, class Tours>
void rank(Trail& trail, const TrailParams& params, const Tours& tours) {
  trail.evaporate(params.persistence);
  const auto order = ranked(tours);
  for (int r = 1; r < params.ranks && r <= static_cast<int>(order.size()); ++r) {
    const auto& tour = tours.ants[order[r - 1]];
    deposit(trail, tours, tour, (params.ranks - r) * params.deposit / tour.length);
  }
  if (!arrived(tours.best_so_far)) return;
  deposit(trail, tours, tours.best_so_far,
          params.ranks * params.deposit / tours.best_so_far.length);
}

/// MAX-MIN ant system (Stuetzle & Hoos 2000): tau_max = Q / ((1 - persistence) L*), and with n the
/// moves of the best tour and half the neighbourhood as the mean choice,
/// tau_min = tau_max (1 - p^(1/n)) / ((choice - 1) p^(1/n)), p = best_probability (their eq. 11).
template <class Trail, class Tours>
void max_min(Trail& trail, const TrailParams& params, const Tours& tours) {
  trail.evaporate(params.persistence);
  const auto& best = tours.best_so_far;
  if (!arrived(best)) return;
  const bool so_far =
      params.best_so_far_every > 0 && (tours.iteration + 1) % params.best_so_far_every == 0;
  const auto order = ranked(tours);
  const auto& depositing = so_far || order.empty() ? best : tours.ants[order[0]];

  const double most = params.deposit / (std::max(1 - params.persistence, 1e-9) * best.length);
  const double all_right =
      kernels::power(params.best_probability, 1.0 / static_cast<double>(tours.moves_of(best)));
  const double choice = std::max(tours.choices() / 2.0, 2.0);
  trail.bound(std::min(most, most * (1 - all_right) / ((choice - 1) * all_right)), most);
  deposit(trail, tours, depositing, params.deposit / depositing.length);
}

/// Ant colony system, global update (Dorigo & Gambardella 1997, eq. 4) on one tour:
/// tau <- persistence tau + (1 - persistence) Q / L.
template <class Trail, class Tours, class Tour>
void colony_system(Trail& trail, const TrailParams& params, const Tours& tours, const Tour& best) {
  if (!arrived(best)) return;
  const double kept = params.persistence;
  const double target = params.deposit / best.length;
  tours.along(best, [&](const auto& place) {
    trail.set_tau(place, kept * trail.tau(place) + (1 - kept) * target);
  });
}

/// Ant colony system, local update (Dorigo & Gambardella 1997, eq. 5) of one place that an ant has
/// passed: tau <- (1 - xi) tau + xi tau0, xi = local_evaporation.
template <class Trail, class Place>
void pass(Trail& trail, const TrailParams& params, double tau0, const Place& place) {
  const double xi = params.local_evaporation;
  trail.set_tau(place, (1 - xi) * trail.tau(place) + xi * tau0);
}

/// The lecture's update: Q / num on the nodes of the best ants.
template <class Trail, class Tours>
void best_share(Trail& trail, const TrailParams& params, const Tours& tours) {
  trail.evaporate(params.persistence);
  const auto order = ranked(tours);
  const auto ants = static_cast<double>(tours.ants.size());
  for (int r = 0; r < std::min<int>(params.elite_ants, static_cast<int>(order.size())); ++r) {
    deposit(trail, tours, tours.ants[order[r]], params.deposit / ants);
  }
}

}  // namespace lasius::trail_rules
