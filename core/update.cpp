#include "update.h"

#include <algorithm>
#include <limits>

#include "kernels/power.h"

namespace lasius {
namespace {

bool arrived(const Tour& tour) noexcept { return tour.length > 0; }

void deposit(Field& field, const Params& params, const Tours& tours, const Tour& tour,
             double amount) {
  along(tours, tour, params.trail, [&](Cell c, int move) { field.deposit(c, move, amount); });
}

/// Indices of the arrived ants, shortest tour first, ties to the lower index.
std::span<const int> ranked(const Tours& tours) {
  auto& order = tours.ranking;
  order.clear();
  for (int a = 0; a < static_cast<int>(tours.ants.size()); ++a) {
    if (arrived(tours.ants[a])) order.push_back(a);
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const double la = tours.ants[a].length, lb = tours.ants[b].length;
    return la != lb ? la < lb : a < b;
  });
  return order;
}

/// Dorigo, Maniezzo & Colorni 1996; Fan et al. 2004, eq. 2, 3.
void ant_system(Field& field, const Params& params, const Tours& tours) {
  field.evaporate(params.persistence);
  for (const Tour& tour : tours.ants) {
    if (arrived(tour)) deposit(field, params, tours, tour, params.deposit / tour.length);
  }
}

/// Elitist ant system (Dorigo & Stuetzle 2004, eq. 3.6).
void elitist(Field& field, const Params& params, const Tours& tours) {
  ant_system(field, params, tours);
  if (!arrived(tours.best_so_far)) return;
  deposit(field, params, tours, tours.best_so_far,
          params.elite_weight * params.deposit / tours.best_so_far.length);
}

/// Rank-based ant system (Bullnheimer, Hartl & Strauss 1999; Dorigo & Stuetzle 2004, eq. 3.8).
void rank(Field& field, const Params& params, const Tours& tours) {
  field.evaporate(params.persistence);
  const auto order = ranked(tours);
  for (int r = 1; r < params.ranks && r <= static_cast<int>(order.size()); ++r) {
    const Tour& tour = tours.ants[order[r - 1]];
    deposit(field, params, tours, tour, (params.ranks - r) * params.deposit / tour.length);
  }
  if (!arrived(tours.best_so_far)) return;
  deposit(field, params, tours, tours.best_so_far,
          params.ranks * params.deposit / tours.best_so_far.length);
}

/// MAX-MIN ant system (Stuetzle & Hoos 2000): tau_max = Q / ((1 - persistence) L*), and with n the
/// moves of the best tour and half the neighbourhood as the mean choice,
/// tau_min = tau_max (1 - p^(1/n)) / ((choice - 1) p^(1/n)), p = best_probability (their eq. 11).
void max_min(Field& field, const Params& params, const Tours& tours) {
  field.evaporate(params.persistence);
  const Tour& best = tours.best_so_far;
  if (!arrived(best)) return;
  const bool so_far =
      params.best_so_far_every > 0 && (tours.iteration + 1) % params.best_so_far_every == 0;
  const auto order = ranked(tours);
  const Tour& depositing = so_far || order.empty() ? best : tours.ants[order[0]];

  const double most = params.deposit / (std::max(1 - params.persistence, 1e-9) * best.length);
  const double all_right =
      kernels::power(params.best_probability, 1.0 / static_cast<double>(best.moves.size()));
  const double choice = std::max(tours.moves.count / 2.0, 2.0);
  field.bound(std::min(most, most * (1 - all_right) / ((choice - 1) * all_right)), most);
  deposit(field, params, tours, depositing, params.deposit / depositing.length);
}

/// Ant colony system, global update (Dorigo & Gambardella 1997, eq. 4): the best tour only.
void colony_system(Field& field, const Params& params, const Tours& tours) {
  const Tour& best = tours.best_so_far;
  if (!arrived(best)) return;
  const double kept = params.persistence;
  const double target = params.deposit / best.length;
  along(tours, best, params.trail, [&](Cell c, int move) {
    field.set_tau(c, move, kept * field.tau(c, move) + (1 - kept) * target);
  });
}

/// The lecture's update: Q / num on the nodes of the best ants.
void best_share(Field& field, const Params& params, const Tours& tours) {
  field.evaporate(params.persistence);
  const auto order = ranked(tours);
  const auto ants = static_cast<double>(tours.ants.size());
  for (int r = 0; r < std::min<int>(params.elite_ants, static_cast<int>(order.size())); ++r) {
    deposit(field, params, tours, tours.ants[order[r]], params.deposit / ants);
  }
}

/// Terminal index (Li, Wang & Ma, section 2.2): backwards along every successful path
/// K(c) <- min(K(c), K(next) + step), the smaller value carried on.
void terminal_index(Field& field, const Params&, const Tours& tours) {
  double longest = 0;
  for (const Tour& tour : tours.ants) {
    if (arrived(tour)) longest = std::max(longest, tour.length);
  }
  if (longest >= field.untouched()) field.raise_untouched(2 * longest);  // unknown stays worse
  for (const Tour& tour : tours.ants) {
    if (!arrived(tour)) continue;
    Cell c = tours.start;
    for (const int k : tour.moves) c = {c.x + tours.moves[k].to.dx, c.y + tours.moves[k].to.dy};
    field.set_tau(c, 0, 0);
    for (std::size_t i = tour.moves.size(); i-- > 0;) {
      const kernels::Move& move = tours.moves[tour.moves[i]];
      const double through = field.tau(c, 0) + move.length;
      c = {c.x - move.to.dx, c.y - move.to.dy};
      if (through < field.tau(c, 0)) field.set_tau(c, 0, through);
    }
  }
}

/// Cong & Ponnambalam 2009: after every ant all pheromone evaporates; success multiplies tau on the
/// tour (eq. 3) and adds rows / L to eta (eq. 4), a dead end damps both on its second half.
void learning(Field& field, const Params& params, const Tours& tours) {
  for (const Tour& tour : tours.ants) {
    field.evaporate(params.persistence);
    std::size_t i = 0;
    const double share = arrived(tour) ? tours.rows / tour.length : 0;
    along(tours, tour, Trail::cells, [&](Cell c, int) {
      const double tau = field.tau(c, 0), eta = field.eta(c);
      if (arrived(tour)) {
        field.set_tau(c, 0,
                      params.reward_reading == Reward::factor ? tau * (1 + params.reward * share)
                                                              : tau * params.reward * share + 1);
        field.set_eta(c, eta + share);
      } else if (2 * i++ >= tour.moves.size()) {
        field.set_tau(c, 0, tau * params.penalty);
        field.set_eta(c, eta * params.penalty);
      }
    });
  }
}

}  // namespace

void best_known_way(Field& field, const kernels::Moves& moves, Cell start, Cell goal,
                    std::vector<std::uint8_t>& way) {
  way.clear();
  const double unknown = field.untouched();
  if (field.tau(start, 0) >= unknown) return;
  // K falls by at least the step at each move: the way ends at the goal.
  for (Cell c = start; c != goal;) {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < moves.count; ++k) {
      if (!field.exists(c, k)) continue;
      const double through =
          field.tau({c.x + moves[k].to.dx, c.y + moves[k].to.dy}, 0) + moves[k].length;
      if (through >= least) continue;
      least = through;
      best = k;
    }
    way.push_back(static_cast<std::uint8_t>(best));
    c = {c.x + moves[best].to.dx, c.y + moves[best].to.dy};
  }
}

double initial_pheromone(const Params& params, double straight_distance) noexcept {
  if (params.initial_pheromone > 0) return params.initial_pheromone;
  // Dorigo & Stuetzle 2004, box 3.1.
  const double lost = std::max(1 - params.persistence, 1e-9);
  const double q = params.deposit > 0 ? params.deposit : 1;
  const double c = straight_distance;
  switch (params.update) {
    case Update::elitist:
      return q * (params.elite_weight + params.ants) / (lost * c);
    case Update::rank:
      return q * 0.5 * params.ranks * (params.ranks - 1) / (lost * c);
    case Update::max_min:
      return q / (lost * c);
    case Update::colony_system:
      return q / (c * c);  // a tour of c moves
    default:
      return q * params.ants / c;
  }
}

void update_locally(Field& field, const Params& params, double tau0, const Tours& batch) {
  const double xi = params.local_evaporation;
  if (params.update != Update::colony_system || xi == 0) return;
  for (const Tour& tour : batch.ants) {
    along(batch, tour, params.trail, [&](Cell c, int move) {
      field.set_tau(c, move, (1 - xi) * field.tau(c, move) + xi * tau0);
    });
  }
}

void update_trail(Field& field, const Params& params, const Tours& tours) {
  switch (params.update) {
    case Update::ant_system:
      return ant_system(field, params, tours);
    case Update::elitist:
      return elitist(field, params, tours);
    case Update::rank:
      return rank(field, params, tours);
    case Update::max_min:
      return max_min(field, params, tours);
    case Update::colony_system:
      return colony_system(field, params, tours);
    case Update::best_share:
      return best_share(field, params, tours);
    case Update::terminal_index:
      return terminal_index(field, params, tours);
    case Update::learning:
      return learning(field, params, tours);
  }
}

}  // namespace lasius
