#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/params/grid_parameters.h"
#include "core/params/parameter_table.h"

namespace lasius {
namespace {

void set_ants(Params& p, int ants, int iterations) {
  p.ants = ants;
  p.iterations = iterations;
}
/// Exponents that stay as they are.
void set_exponents(Params& p, double alpha, double beta) {
  p.alpha = p.alpha_first = alpha;
  p.beta = p.beta_first = beta;
}
void set_trail(Params& p, double persistence, double initial_pheromone, double deposit) {
  p.persistence = persistence;
  p.initial_pheromone = initial_pheromone;
  p.deposit = deposit;
}

/// Nothing to set: where it ends is in the request.
void exact(Params&) {}

/// Fan, Luo, Yi & Zhang 2004, section 4; omega, mu, lambda from note 1, exponents from note 2. What
/// the source leaves open was settled on generated maps, see docs/theory.md: the shares of its
/// three rules, Q / tau0 = 100, deposits on tours cut to the ant's own cells, the window of the
/// straightening, and ants that step back at dead ends.
void fan2004(Params& p) {
  set_ants(p, 10, 120);
  p.walk_cut = WalkCut::own_cells;
  p.polish = Polish::local;
  p.straight_window = 10;
  p.straight_deposit = StraightDeposit::all;
  p.heuristic = Heuristic::rescaled_distance;
  p.omega = 10;
  p.mu = p.lambda = 2;
  p.visibility = Visibility::inverse_step;
  set_exponents(p, 4, 1.5);
  p.alpha_first = 0;
  p.beta_first = 3;
  p.critical_time = 10;
  p.settling_time = 70;
  p.pheromone_rule_first = p.combined_rule_first = 0;
  p.distance_rule_first = 1;
  p.pheromone_rule = 0.01;
  p.combined_rule = 0.7;
  p.distance_rule = 0.3;
  p.distance_rule_last = 0.002;
  set_trail(p, 0.7, 1, 100);
}

/// Ant system, Dorigo, Maniezzo & Colorni 1996, on 8 neighbours with pheromone on the arcs and
/// visibility 1 / distance to the goal, nothing done with the walks; the other families begin with
/// it. alpha, beta and evaporation 0.3 are those that found the optima of Li, Wang and Ma's grids
/// in each of 30 seeds; tau0 = m Q / L of the straight line.
void ant_system_book(Params& p) {
  p.neighbours = Neighbours::eight;
  p.trail = Trail::arcs;
  p.heuristic = Heuristic::inverse_distance;
  set_ants(p, 30, 100);
  set_exponents(p, 1, 5);
  set_trail(p, 0.7, 0, 1);
}

/// Elitist ant system: evaporation 0.5, e = the number of ants (Dorigo & Stuetzle 2004, box 3.1).
void elitist_book(Params& p) {
  ant_system_book(p);
  p.update = Update::elitist;
  p.persistence = 0.5;
  p.elite_weight = p.ants;
}

/// Rank-based ant system: evaporation 0.1, w = 6 (Dorigo & Stuetzle 2004, box 3.1).
void rank_based_book(Params& p) {
  ant_system_book(p);
  p.update = Update::rank;
  p.persistence = 0.9;
  p.ranks = 6;
}

/// MAX-MIN ant system: evaporation 0.02, p_best = 0.05; the iteration's best deposits, the best so
/// far every 5 iterations (Stuetzle & Hoos 2000; Dorigo & Stuetzle 2004, box 3.1).
void max_min_book(Params& p) {
  ant_system_book(p);
  p.update = Update::max_min;
  p.persistence = 0.98;
  p.best_so_far_every = 5;
  p.best_probability = 0.05;
}

/// Ant colony system: 10 ants, q0 = 0.9, evaporation and local evaporation 0.1 (Dorigo &
/// Gambardella 1997). Its local update follows every step; here it follows every ant (batch = 1).
void colony_system_book(Params& p) {
  ant_system_book(p);
  set_ants(p, 10, 100);
  p.update = Update::colony_system;
  p.greedy = 0.9;
  p.persistence = 0.9;
  p.local_evaporation = 0.1;
  p.batch = 1;
}

/// Ours, for maps: a tour of hundreds of moves is not one of thirty cities. Ten ants that wander
/// (rescaled distance with omega = 1), whose tours are cut to the cells that they entered: loops no
/// longer learn. Calibrated on generated maps, see docs/theory.md.
void on_maps(Params& p) {
  p.walk_cut = WalkCut::entered_cells;
  p.heuristic = Heuristic::rescaled_distance;
  p.omega = 1;
  p.mu = p.lambda = 2;
  set_ants(p, 10, 1000);
  p.persistence = 0.9;
}

/// Lets ants wander first: alpha rises.
void close_in(Params& p) {
  p.alpha_first = 0.5;
  p.alpha = 1.5;
  p.critical_time = 100;
}

/// Its ants share the trail too evenly to close in by themselves.
void ant_system(Params& p) {
  ant_system_book(p);
  on_maps(p);
  p.trail = Trail::cells;
  p.persistence = 0.7;
  close_in(p);
}

void elitist(Params& p) {
  elitist_book(p);
  on_maps(p);
  p.trail = Trail::cells;
  p.elite_weight = p.ants;
}

void rank_based(Params& p) {
  rank_based_book(p);
  on_maps(p);
  p.trail = Trail::cells;
}

void max_min(Params& p) {
  max_min_book(p);
  on_maps(p);
  p.best_so_far_every = 1;
}

/// Its best tour alone has a trail, hundreds of times tau0: a small alpha at first and fewer greedy
/// steps leave others a chance.
void colony_system(Params& p) {
  colony_system_book(p);
  on_maps(p);
  p.persistence = 0.8;
  p.greedy = 0.2;
  close_in(p);
}

/// Li, Wang & Ma, sections 2 and 3.1: alpha 0.9 on the terminal index, beta 1.5 on the distance,
/// q = 0.8. An ant walks until it "can move no further": it dies.
void terminal_index(Params& p) {
  ant_system_book(p);
  p.update = Update::terminal_index;
  p.selection = Selection::inverse_roulette;
  p.trail = Trail::cells;
  p.heuristic = Heuristic::distance;
  set_exponents(p, 0.9, 1.5);
  p.dead_end = DeadEnd::kill;
  p.index_spread = 0.8;
  p.unknown_index = 99;
}

/// Cong & Ponnambalam 2009: 4 neighbours, ants one at a time, so an iteration is one ant and
/// `ants` is how many walk before the map is updated (our extension). tau0 = 3, eta0 = 1; the
/// number of ants is "a large number".
void cong2009(Params& p) {
  set_ants(p, 1, 1000);
  p.heuristic = Heuristic::learned;
  set_exponents(p, 1.8, 1.5);
  p.update = Update::learning;
  set_trail(p, 0.8, 3, 1);
  p.reward = 1.2;
  p.penalty = 0.5;
  p.dead_end = DeadEnd::kill;
}

/// The lecture's colony: eta = 1 / h with h the change of heading, regularised as 1 / (1 + turn /
/// 45 degrees); never straight back. The best ant of an iteration deposits, as in its text; its
/// table has 5 "candidate" ants. It ends when all ants take one way.
void lecture_grid(Params& p) {
  set_ants(p, 30, 50);
  p.agreement = 1;
  p.neighbours = Neighbours::eight;
  p.visibility = Visibility::heading_change;
  set_exponents(p, 1, 0.5);
  p.update = Update::best_share;
  p.elite_ants = 1;
  set_trail(p, 0.9, 0.5, 0.5);
}

/// Ahn & Ramakrishna 2002; 8 neighbours as the colonies that it is compared with.
void grid_ga(Params& p) {
  p.polish = Polish::straight;
  p.neighbours = Neighbours::eight;
  p.iterations = 100;
  p.population = 50;
  p.crossover = 1;
  p.mutation = 0.05;
}

struct Listed {
  std::string_view name, summary, source;
  void (*set)(Params&);
  void (*set_book)(Params&) = nullptr;
  Algorithm::Kind kind = Algorithm::Kind::colony;
};

constexpr std::array kListed{
    Listed{"exact",
           "the shortest any-angle path, with a proof; before that the best path so far with a "
           "certified gap",
           "lasius: weighted A* and A* over taut corners, see docs/exact.md", exact, nullptr,
           Algorithm::Kind::exact},
    Listed{"fan2004",
           "bitmaps of many irregular obstacles: pheromone, rescaled distance and their product "
           "mixed by roulette, exponents that vary with time, tours pulled straight",
           "Fan, Luo, Yi, Zhang: Path planning for robots based on ant colony optimization "
           "algorithm under complex environment. Control and Decision 19 (2), 2004",
           fan2004},
    Listed{"as", "ant system, the classic: every ant that arrives deposits",
           "Dorigo, Maniezzo, Colorni: Ant System: optimization by a colony of cooperating "
           "agents. IEEE Trans. SMC-B 26 (1), 1996",
           ant_system, ant_system_book},
    Listed{"eas", "elitist ant system: the best tour so far deposits as well",
           "Dorigo, Stuetzle: Ant Colony Optimization. MIT Press, 2004, section 3.3.2", elitist,
           elitist_book},
    Listed{"ras", "rank-based ant system: the best ants deposit, weighted by rank",
           "Bullnheimer, Hartl, Strauss: A new rank-based version of the Ant System. Central "
           "European J. for Operations Research 7 (1), 1999",
           rank_based, rank_based_book},
    Listed{"mmas", "MAX-MIN ant system: one best ant deposits, pheromone between bounds",
           "Stuetzle, Hoos: MAX-MIN Ant System. Future Generation Computer Systems 16 (8), 2000",
           max_min, max_min_book},
    Listed{"acs", "ant colony system: pseudo-random proportional rule, local and global update",
           "Dorigo, Gambardella: Ant Colony System: a cooperative learning approach to the "
           "traveling salesman problem. IEEE Trans. Evolutionary Computation 1 (1), 1997",
           colony_system, colony_system_book},
    Listed{"terminal-index",
           "the best known way from each cell in place of pheromone, moves discarded one by one; "
           "its ants die in dead ends, so it is meant for maps like its source's 20 x 20 and 30 "
           "x 30 cells, or dead_end=backtrack",
           "Li, Wang, Ma: ant colony path planning with a terminal index", terminal_index},
    Listed{"cong2009",
           "one ant at a time, learned heuristic, penalties for dead ends; its ants die there, so "
           "it is meant for small maps",
           "Cong, Ponnambalam: Mobile robot path planning using ant colony optimization. "
           "IEEE/ASME Int. Conf. on Advanced Intelligent Mechatronics, 2009",
           cong2009},
    Listed{"lecture-grid", "heading change as heuristic, the iteration's best ant deposits",
           "lecture on ant algorithms for robot path planning, grid part", lecture_grid},
    Listed{"grid-ga",
           "genetic algorithm, the comparator: paths of cells that cross where they meet",
           "Ahn, Ramakrishna: A genetic algorithm for shortest path routing problem and the "
           "sizing of populations. IEEE Trans. Evolutionary Computation 6 (6), 2002",
           grid_ga, nullptr, Algorithm::Kind::genetic},
};

std::span<const Parameter> parameters_of(Algorithm::Kind kind) {
  switch (kind) {
    case Algorithm::Kind::colony:
      return colony_parameters();
    case Algorithm::Kind::genetic:
      return genetic_parameters();
    case Algorithm::Kind::exact:
      break;
  }
  return {};
}

const Listed& listed(const Algorithm& algorithm) {
  return kListed[static_cast<std::size_t>(&algorithm - algorithms().data())];
}

}  // namespace

std::span<const Algorithm> algorithms() noexcept {
  // Made on first use, so that Params may be made before main() begins.
  static const auto list = [] {
    std::array<Algorithm, kListed.size()> all;
    std::ranges::transform(kListed, all.begin(), [](const Listed& one) -> Algorithm {
      return {one.name, one.summary, one.source, parameters_of(one.kind), one.kind};
    });
    return all;
  }();
  return list;
}

const Algorithm& find_algorithm(std::string_view name) {
  return find_algorithm(algorithms(), name);
}

bool has_preset(std::string_view algorithm, Preset preset) {
  return preset == Preset::usual || listed(find_algorithm(algorithm)).set_book != nullptr;
}

Params::Params(std::string_view algorithm, Preset preset) {
  const Algorithm& found = find_algorithm(algorithm);
  algorithm_ = found.name;
  const Listed& entry = listed(found);
  if (to_string(preset).empty()) refuse("the preset is none", "take one of Preset");
  if (preset == Preset::book && entry.set_book == nullptr) {
    std::string others;
    for (const Listed& one : kListed)
      if (one.set_book != nullptr) (others += others.empty() ? "" : ", ") += one.name;
    refuse(algorithm_ + " has no preset book", "those with the numbers of a textbook: " + others);
  }
  (preset == Preset::book ? entry.set_book : entry.set)(*this);
}

}  // namespace lasius
