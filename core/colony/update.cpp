#include "core/colony/update.h"

#include <algorithm>

#include "core/base/special_values.h"
#include "core/colony/polish.h"
#include "core/colony/terminal_index.h"
#include "core/loop/trail_rules.h"
#include "kernels/base/power.h"

namespace lasius {
namespace {

using trail_rules::arrived;

/// Cong & Ponnambalam 2009: after every ant all pheromone evaporates; success multiplies tau on the
/// tour (eq. 3) and adds rows / L to eta (eq. 4), a dead end damps both on its second half.
void learning(Field& field, const Params& params, const GridTours& tours) {
  for (const Tour& tour : tours.ants) {
    field.evaporate(params.persistence);
    std::size_t i = 0;
    const double share = arrived(tour) ? tours.rows / tour.length : 0;
    tours.along(tour, [&](GridPlace place) {
      const Cell c = place.cell;
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

double trail_entropy(Field& field, Trail trail, const kernels::Moves& moves, Cell start,
                     std::span<const std::uint8_t> tour) {
  constexpr std::size_t kCells = 64;
  const std::size_t stride = std::max<std::size_t>(1, (tour.size() + kCells - 1) / kCells);
  double sum = 0;
  int cells = 0;
  Cell c = start;
  for (std::size_t i = 0; i < tour.size(); c = c + moves[tour[i++]].to) {
    if (i % stride != 0) continue;
    double total = 0, weighted = 0;
    int choices = 0;
    for (int k = 0; k < moves.count; ++k) {
      if (!field.exists(c, k)) continue;
      const double tau = trail == Trail::arcs ? field.tau(c, k) : field.tau(c + moves[k].to, 0);
      ++choices;
      total += tau;
      if (tau >= 0x1p-1000) weighted += tau * kernels::log2_of(tau);
    }
    if (choices < 2 || !(total >= 0x1p-1000)) continue;
    sum += std::clamp((kernels::log2_of(total) - weighted / total) / kernels::log2_of(choices), 0.0,
                      1.0);
    ++cells;
  }
  return cells > 0 ? sum / cells : kNaN;
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
    case Update::ant_system:
    case Update::best_share:
    case Update::terminal_index:
    case Update::learning:
      break;
  }
  return q * params.ants / c;
}

void update_locally(Field& field, const Params& params, double tau0, const Tours& batch,
                    std::vector<EarlierTau>* before) {
  if (params.update != Update::colony_system || params.local_evaporation == 0) return;
  const GridTours tours{batch, params.trail};
  for (const Tour& tour : tours.ants) {
    tours.along(tour, [&](GridPlace place) {
      if (before != nullptr) before->push_back({place, field.tau(place)});
      trail_rules::pass(field, params, tau0, place);
    });
  }
}

void update_trail(Field& field, const Params& params, const Tours& all) {
  const GridTours tours{all, params.trail};
  switch (params.update) {
    case Update::ant_system:
      return trail_rules::ant_system(field, params, tours);
    case Update::elitist:
      return trail_rules::elitist(field, params, tours, tours.best_so_far);
    case Update::rank:
      return trail_rules::rank(field, params, tours);
    case Update::max_min:
      return trail_rules::max_min(field, params, tours);
    case Update::colony_system:
      return trail_rules::colony_system(field, params, tours, tours.best_so_far);
    case Update::best_share:
      return trail_rules::best_share(field, params, tours);
    case Update::terminal_index:
      return update_terminal_index(field, tours);
    case Update::learning:
      return learning(field, params, tours);
  }
}

void lay_straight_paths(Field& field, const Params& params, std::span<const Ant> ants,
                        std::span<const PolishedPath> paths, int finder) {
  if (params.straight_deposit == StraightDeposit::none) return;
  for (int a = 0; a < static_cast<int>(ants.size()); ++a) {
    const bool chosen = params.straight_deposit == StraightDeposit::all || a == finder;
    if (!ants[a].arrived || !chosen) continue;
    for (const Cell c : paths[a].raster) field.deposit(c, 0, params.deposit / paths[a].length);
  }
}

}  // namespace lasius
