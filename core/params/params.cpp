#include "lasius/params.h"

#include <algorithm>
#include <array>

#include "core/params/parameter_table.h"
#include "core/params/presets.h"
#include "core/params/schedule.h"

namespace lasius {
namespace {

using Table = ParameterTable<Params>;
using Entry = Table::Entry;
using Integer = Table::Integer;
using Number = Table::Number;

template <auto kMember, auto kValue>
constexpr bool is(const Params& p) {
  return p.*kMember == kValue;
}
template <auto kMember, auto kValue>
constexpr bool is_not(const Params& p) {
  return p.*kMember != kValue;
}
template <auto kMember>
constexpr bool is_positive(const Params& p) {
  return p.*kMember > 0;
}
template <bool (*... kHold)(const Params&)>
constexpr bool all_of(const Params& p) {
  return (kHold(p) && ...);
}

constexpr bool reads_beta(const Params& p) {
  const bool steps_differ =
      p.visibility == Visibility::inverse_step && p.neighbours != Neighbours::four;
  return steps_differ || p.visibility == Visibility::heading_change ||
         p.update == Update::terminal_index ||
         !(p.heuristic == Heuristic::uniform || p.heuristic == Heuristic::rescaled_distance);
}
constexpr bool reads_deposit(const Params& p) {
  const bool straight = p.polish != Polish::none && p.straight_deposit != StraightDeposit::none;
  const bool first = p.update == Update::learning && p.initial_pheromone == 0;
  return (p.update != Update::terminal_index && p.update != Update::learning) || straight || first;
}
// What several of them ask for.
using Condition = Table::Condition;
constexpr Condition kRescaled{"heuristic=rescaled-distance",
                              is<&Params::heuristic, Heuristic::rescaled_distance>};
constexpr Condition kUntilCriticalTime{"critical_time above 0",
                                       is_positive<&Params::critical_time>};
constexpr Condition kNoIndex{"an update but terminal-index",
                             is_not<&Params::update, Update::terminal_index>};
constexpr Condition kMaxMin{"update=max-min", is<&Params::update, Update::max_min>};
constexpr Condition kIndex{"update=terminal-index", is<&Params::update, Update::terminal_index>};
constexpr Condition kLearning{"update=learning", is<&Params::update, Update::learning>};

// Every parameter of the grid colonies.
constexpr std::array kColony{
    Entry{{"ants", "integer", "1 .. 1000000", "ants an iteration, m"},
          Integer{&Params::ants, 1, 1000000}},
    Entry{{"iterations", "integer", "0 .. 1000000000", "iterations, T"},
          Integer{&Params::iterations, 0, 1000000000}},
    Table::choice<&Params::neighbours, kNeighboursNames>("neighbours", "moves of an ant"),
    Table::choice<&Params::corners, kCornersNames>(
        "corners", "free side cells that a diagonal move needs: both, one, none")
        .only_with({"neighbours above 4", is_not<&Params::neighbours, Neighbours::four>}),
    Table::choice<&Params::polish, kPolishNames>("polish", "what is done with each ant's tour"),
    Entry{{"straight_window", "number", "0 .. 1e6",
           "how far from a segment a stretch may go that it replaces, cells", "10"},
          Number{&Params::straight_window, 0, 1e6}}
        .only_with({"polish=local", is<&Params::polish, Polish::local>}),
    Table::choice<&Params::dead_end, kDeadEndNames>("dead_end",
                                                    "what an ant does when every move is closed"),
    Table::choice<&Params::walk_cut, kWalkCutNames>(
        "walk_cut", "what is left of a tour before it is deposited or offered", "none"),
    Table::choice<&Params::selection, kSelectionNames>(
        "selection", "how a move is drawn from its row of weights"),
    Table::choice<&Params::trail, kTrailNames>("trail", "what carries pheromone"),
    Table::choice<&Params::heuristic, kHeuristicNames>("heuristic",
                                                       "weight of a move by where it leads"),
    Table::choice<&Params::visibility, kVisibilityNames>(
        "visibility", "weight of a move by itself and the one before"),
    Entry{{"alpha", "number", "0 .. 20", "exponent of pheromone from the critical time on"},
          Number{&Params::alpha, 0, 20}},
    Entry{{"beta", "number", "0 .. 20", "exponent of visibility and inverse distance, likewise"},
          Number{&Params::beta, 0, 20}}
        .only_with({"visibility=heading-change, or inverse-step with neighbours above 4, or a "
                    "heuristic but uniform and rescaled-distance, or update=terminal-index",
                    reads_beta}),
    Entry{{"greedy", "number", "0 .. 1", "share of steps that take the largest weight, q0"},
          Number{&Params::greedy, 0, 1}},
    Entry{{"critical_time", "integer", "0 .. 1000000000",
           "iteration from which exponents and shares are constant, but for the distance rule's "
           "until settling_time, mc; 0: always"},
          Integer{&Params::critical_time, 0, 1000000000}},
    Entry{{"alpha_first", "number", "0 .. 20", "alpha at iteration 0"},
          Number{&Params::alpha_first, 0, 20}}
        .only_with(kUntilCriticalTime),
    Entry{{"beta_first", "number", "0 .. 20", "beta at iteration 0"},
          Number{&Params::beta_first, 0, 20}}
        .only_with({"those that read beta, and critical_time above 0",
                    all_of<reads_beta, is_positive<&Params::critical_time>>}),
    Entry{{"omega", "number", "0 .. 1000000", "rescaled distance: ((Dmax - d) omega + mu)^lambda"},
          Number{&Params::omega, 0, 1e6}}
        .only_with(kRescaled),
    Entry{{"mu", "number", "0.000001 .. 1000000", "rescaled distance: offset"},
          Number{&Params::mu, 1e-6, 1e6}}
        .only_with(kRescaled),
    Entry{{"lambda", "number", "0 .. 20", "rescaled distance: exponent"},
          Number{&Params::lambda, 0, 20}}
        .only_with(kRescaled),
    Entry{{"pheromone_rule_first", "number", "0 .. 1000000",
           "share of steps by pheromone alone at iteration 0"},
          Number{&Params::pheromone_rule_first, 0, 1e6}}
        .only_with(kUntilCriticalTime),
    Entry{{"pheromone_rule", "number", "0 .. 1000000", "the same from the critical time on"},
          Number{&Params::pheromone_rule, 0, 1e6}},
    Entry{{"distance_rule_first", "number", "0 .. 1000000",
           "share of steps by the heuristic alone at iteration 0"},
          Number{&Params::distance_rule_first, 0, 1e6}}
        .only_with(kUntilCriticalTime),
    Entry{{"distance_rule", "number", "0 .. 1000000", "the same at the critical time"},
          Number{&Params::distance_rule, 0, 1e6}},
    Entry{
        {"distance_rule_last", "number", "0 .. 1000000", "the same from the settling time on", "0"},
        Number{&Params::distance_rule_last, 0, 1e6}}
        .only_with({"settling_time above 0", is_positive<&Params::settling_time>}),
    Entry{{"settling_time", "integer", "0 .. 1000000000",
           "iteration from which the share of the distance rule is its last one; 0: it stays", "0"},
          Integer{&Params::settling_time, 0, 1000000000}},
    Entry{{"combined_rule_first", "number", "0 .. 1000000",
           "share of steps by the product of both at iteration 0"},
          Number{&Params::combined_rule_first, 0, 1e6}}
        .only_with(kUntilCriticalTime),
    Entry{{"combined_rule", "number", "0 .. 1000000", "the same from the critical time on"},
          Number{&Params::combined_rule, 0, 1e6}},
    Table::choice<&Params::update, kUpdateNames>("update",
                                                 "how the trail changes after an iteration"),
    Entry{{"persistence", "number", "0 .. 1", "share of pheromone that remains after an iteration"},
          Number{&Params::persistence, 0, 1}}
        .only_with(kNoIndex),
    Entry{{"initial_pheromone", "number", "0 .. 1e9",
           "pheromone everywhere at first, tau0; 0: the formula of the update's source"},
          Number{&Params::initial_pheromone, 0, 1e9}}
        .only_with(kNoIndex),
    Entry{{"deposit", "number", "0 .. 1e9", "an ant of tour length L deposits deposit / L, Q"},
          Number{&Params::deposit, 0, 1e9}}
        .only_with(
            {"an update but terminal-index, learning with initial_pheromone=0, or straight_deposit",
             reads_deposit}),
    Table::choice<&Params::straight_deposit, kStraightDepositNames>(
        "straight_deposit", "which straightened paths get pheromone too")
        .only_with({"polish=straight|taut|local", is_not<&Params::polish, Polish::none>}),
    Entry{{"elite_weight", "number", "0 .. 1e6", "weight of the best tour so far, e"},
          Number{&Params::elite_weight, 0, 1e6}}
        .only_with({"update=elitist", is<&Params::update, Update::elitist>}),
    Entry{{"ranks", "integer", "2 .. 1000000",
           "weight of the best tour so far, w; w - 1 ranked ants deposit too"},
          Integer{&Params::ranks, 2, 1000000}}
        .only_with({"update=rank", is<&Params::update, Update::rank>}),
    Entry{{"elite_ants", "integer", "1 .. 1000000", "ants that deposit"},
          Integer{&Params::elite_ants, 1, 1000000}}
        .only_with({"update=best-share", is<&Params::update, Update::best_share>}),
    Entry{{"best_so_far_every", "integer", "0 .. 1000000000",
           "iterations between deposits of the best tour so far; 0: never"},
          Integer{&Params::best_so_far_every, 0, 1000000000}}
        .only_with(kMaxMin),
    Entry{{"best_probability", "number", "1e-9 .. 1",
           "chance to draw the best tour again at the bounds, p_best"},
          Number{&Params::best_probability, 1e-9, 1}}
        .only_with(kMaxMin),
    Entry{{"local_evaporation", "number", "0 .. 1",
           "share of a crossed trail that returns to tau0, xi"},
          Number{&Params::local_evaporation, 0, 1}}
        .only_with({"update=colony-system", is<&Params::update, Update::colony_system>}),
    Entry{{"batch", "integer", "0 .. 1000000",
           "ants that walk before a local update; 1 is the source, 0 all of them"},
          Integer{&Params::batch, 0, 1000000}}
        .only_with({"update=colony-system and local_evaporation above 0",
                    all_of<is<&Params::update, Update::colony_system>,
                           is_positive<&Params::local_evaporation>>}),
    Entry{{"agreement", "integer", "0 .. 1000000000",
           "iterations in a row with all ants on one way that end the run; 0: never", "0"},
          Integer{&Params::agreement, 0, 1000000000}},
    Entry{{"unknown_index", "number", "1 .. 1e6",
           "terminal index of unknown cells, for 20 x 20 cells"},
          Number{&Params::unknown_index, 1, 1e6}}
        .only_with(kIndex),
    Entry{{"index_spread", "number", "0 .. 1", "q of K' = K - q Kmin"},
          Number{&Params::index_spread, 0, 1}}
        .only_with(kIndex),
    Table::choice<&Params::index_answer, kIndexAnswerNames>(
        "index_answer", "reading of \"the largest gradient\" that an answer follows", "least-way")
        .only_with(kIndex),
    Entry{{"reward", "number", "0 .. 1e6", "factor of the reward"}, Number{&Params::reward, 0, 1e6}}
        .only_with(kLearning),
    Table::choice<&Params::reward_reading, kRewardNames>("reward_reading",
                                                         "reading of the reward's formula")
        .only_with(kLearning),
    Entry{{"penalty", "number", "0 .. 1", "what a dead end leaves of tau and eta"},
          Number{&Params::penalty, 0, 1}}
        .only_with(
            {"update=learning and dead_end=kill",
             all_of<is<&Params::update, Update::learning>, is<&Params::dead_end, DeadEnd::kill>>}),
};

// What the genetic algorithm has of its own.
constexpr std::array kGenetic{
    Entry{{"population", "integer", "2 .. 1000000", "paths of a generation"},
          Integer{&Params::population, 2, 1000000}},
    Entry{{"crossover", "number", "0 .. 1", "probability that two parents cross"},
          Number{&Params::crossover, 0, 1}},
    Entry{{"mutation", "number", "0 .. 1", "probability that a child gets a new way to the goal"},
          Number{&Params::mutation, 0, 1}},
};

constexpr auto kColonyParameters = Table::infos(kColony);

// What the genetic algorithm shares with the colonies, then its own.
constexpr auto kGeneticParameters = [] {
  constexpr std::array<std::string_view, 5> kShared{"iterations", "neighbours", "corners", "polish",
                                                    "straight_window"};
  std::array<Parameter, kShared.size() + kGenetic.size()> list;
  auto next = list.begin();
  for (const Entry& e : kColony) {
    if (std::ranges::find(kShared, e.info.name) == kShared.end()) continue;
    *next = e.info;
    if (e.info.name == "neighbours") next->range = "4|8";  // see validate()
    ++next;
  }
  for (const Entry& e : kGenetic) *next++ = e.info;
  return list;
}();

constexpr std::array kEntries{std::span<const Entry>(kColony), std::span<const Entry>(kGenetic)};

constexpr Table kTable(kEntries);

}  // namespace

std::span<const Parameter> colony_parameters() noexcept { return kColonyParameters; }
std::span<const Parameter> genetic_parameters() noexcept { return kGeneticParameters; }

void set_parameter(Params& params, std::string_view name, std::string_view value) {
  kTable.set(params, name, value);
}

std::string get_parameter(const Params& params, std::string_view name) {
  return kTable.get(params, name);
}

std::string why_unread(const Params& params, std::string_view name) {
  if (name == kEvaporation) name = kPersistence;
  std::string why = kTable.why_unread(params, name);
  const bool known = find_algorithm(params.algorithm()).has(name);
  return known ? why : params.algorithm() + " does not read it";
}

bool Algorithm::has(std::string_view parameter) const noexcept {
  return std::ranges::any_of(parameters,
                             [parameter](const Parameter& p) { return p.name == parameter; });
}

std::string_view to_string(Algorithm::Kind kind) noexcept {
  static constexpr std::array<std::string_view, 3> kNames{"exact", "colony", "genetic"};
  return name_of(kind, kNames);
}

void validate(const Params& params) {
  const Algorithm& algorithm = find_algorithm(params.algorithm());
  Params published(algorithm.name);
  published.seed = params.seed;
  published.threads = params.threads;
  check_seed(params.seed);
  check_threads(params.threads);
  if (params == published) return;  // valid; saves time on short queries
  kTable.check(params);
  kTable.check_unread(params, published, algorithm);
  const double first =
      params.pheromone_rule_first + params.distance_rule_first + params.combined_rule_first;
  const double last = params.pheromone_rule + params.distance_rule + params.combined_rule;
  const double end = params.pheromone_rule + params.distance_rule_last + params.combined_rule;
  if (!(last > 0) || (params.critical_time > 0 && !(first > 0)) ||
      (params.settling_time > 0 && !(end > 0))) {
    throw invalid_parameter("the shares of the pheromone, distance and combined rules are all 0",
                            "give one of them a share above 0");
  }
  for (const auto& [name, value] : {std::pair{"initial_pheromone", params.initial_pheromone},
                                    std::pair{"deposit", params.deposit}}) {
    if (value == 0 || value >= kLeastPheromone) continue;
    throw invalid_parameter(std::string(name) + " is positive, but below 1e-12",
                            "give both pheromones larger values: only their ratio counts");
  }
  if (params.settling_time > 0 && params.settling_time <= params.critical_time) {
    throw invalid_parameter("settling_time is " + std::to_string(params.settling_time) +
                                ", not after critical_time, " +
                                std::to_string(params.critical_time),
                            "set it to more, or to 0 for a share that stays");
  }
  const bool mixture = mixes_rules(params);
  const bool inverse = params.selection == Selection::inverse_roulette;
  const bool index = params.update == Update::terminal_index;
  const bool learning = params.update == Update::learning;
  const bool cells = params.trail == Trail::cells;
  const bool straight_deposits =
      params.polish != Polish::none && params.straight_deposit != StraightDeposit::none;
  const auto refuse_if = [](bool wrong, const char* problem, const char* remedy) {
    if (wrong) throw invalid_parameter(problem, remedy);
  };
  refuse_if(!cells && straight_deposits,
            "straight_deposit lays pheromone on cells, but the trail is on arcs",
            "set trail to cells or straight_deposit to none");
  refuse_if(inverse != index,
            "the inverse roulette discards large weights, which only the "
            "terminal index gives to bad moves",
            "set selection to inverse-roulette and update to terminal-index, or neither");
  refuse_if(inverse && (mixture || params.greedy > 0),
            "the inverse roulette knows one rule and no greedy steps",
            "set greedy and the shares of the pheromone and distance rules to 0");
  refuse_if((index || learning) && !cells, "this update keeps one value a cell, not one an arc",
            "set trail to cells");
  refuse_if(index && straight_deposits, "the terminal index is no pheromone that could be laid",
            "set straight_deposit to none");
  refuse_if((params.heuristic == Heuristic::learned) != learning,
            "the learned heuristic and the update learning belong together",
            "set heuristic to learned and update to learning, or neither");
  if (algorithm.kind == Algorithm::Kind::genetic && params.neighbours > Neighbours::eight) {
    throw invalid_parameter(params.algorithm() + " knows moves to 4 or 8 neighbours only",
                            "set neighbours to 4 or 8");
  }
}

}  // namespace lasius
