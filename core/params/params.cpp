#include "lasius/params/params.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/params/grid_parameters.h"
#include "core/params/parameter_table.h"

namespace lasius {
namespace {

using Table = ParameterTable<Params>;
using Entry = Table::Entry;

// The rules that read a parameter where only some do: "update=rank|max-min", or "any update except
// learning" where most do.
template <class Rules>
std::string readers(const std::string& kind, std::string_view parameter, const Rules& rules) {
  const auto reads = [&](const auto& rule) { return rule.reads(parameter); };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(rules, reads));
  if (count == 0 || count == rules.size()) return {};
  const bool most = 2 * count > rules.size();
  std::string words = most ? "any " + kind : kind;
  const char* before = most ? " except " : "=";
  for (const auto& rule : rules)
    if (reads(rule) != most) words.append(std::exchange(before, "|")).append(rule.name);
  return words;
}
bool is_read_by_rules(const Params& p, std::string_view parameter) {
  return rule_of(p.heuristic, kHeuristics).reads(parameter) ||
         rule_of(p.visibility, kVisibilities).reads(parameter) ||
         rule_of(p.update, kUpdates).reads(parameter);
}
// With what a parameter is read, as told: rules, then what else it waits for.
std::string only_with(const Parameter& info) {
  const std::string heuristics = readers("heuristic", info.name, kHeuristics),
                    visibilities = readers("visibility", info.name, kVisibilities),
                    updates = readers("update", info.name, kUpdates);
  const int kinds = !heuristics.empty() + !visibilities.empty() + !updates.empty();
  std::string words = kinds > 1 || !visibilities.empty()
                          ? "a heuristic, visibility or update with it in its formula"
                          : heuristics + updates;
  if (words.empty() || info.only_with.empty()) return words.append(info.only_with);
  return words.append(words.find(' ') != words.npos ? ", and " : " and ").append(info.only_with);
}

constexpr Table::Condition kIslands{"islands above 1",
                                    [](const Params& p) { return p.islands > 1; }};
constexpr Table::Condition kUntilCriticalTime{"critical_time above 0",
                                              [](const Params& p) { return p.critical_time > 0; }};

// Steps of one length make a factor that all moves have.
bool beta_counts(const Params& p) {
  return p.neighbours != Neighbours::four || p.visibility != Visibility::inverse_step ||
         rule_of(p.heuristic, kHeuristics).reads("beta") ||
         rule_of(p.update, kUpdates).reads("beta");
}
bool first_beta_counts(const Params& p) {
  return p.critical_time > 0 && beta_counts(p) && is_read_by_rules(p, "beta");
}
bool straight_paths_deposit(const Params& p) {
  return p.polish != Polish::none && p.straight_deposit != StraightDeposit::none;
}
bool deposit_counts(const Params& p) {
  return p.update != Update::learning || p.initial_pheromone == 0 || straight_paths_deposit(p);
}

// Every parameter of the grid colonies, with what it waits for beside the rules that read it.
constexpr std::array kColony{
    Table::number("ants", &Params::ants, 1, 1000000, "ants an iteration, m"),
    Table::number("iterations", &Params::iterations, 0, 1000000000, "iterations, T"),
    Table::choice<&Params::neighbours, kNeighboursNames>("neighbours", "moves of an ant"),
    Table::choice<&Params::corners, kCornersNames>(
        "corners", "free side cells that a diagonal move needs: both, one, none")
        .only_with({"neighbours above 4",
                    [](const Params& p) { return p.neighbours != Neighbours::four; }}),
    Table::choice<&Params::polish, kPolishNames>("polish", "what is done with each ant's tour"),
    Table::number("straight_window", &Params::straight_window, 0, 1e6,
                  "how far from a segment a stretch may go that it replaces, cells", "10")
        .only_with({"polish=local", [](const Params& p) { return p.polish == Polish::local; }}),
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
    Table::number("alpha", &Params::alpha, 0, 20,
                  "exponent of pheromone from the critical time on"),
    Table::number("beta", &Params::beta, 0, 20,
                  "exponent of visibility and inverse distance from the critical time on")
        .only_with({"neighbours above 4 where that is inverse-step alone", beta_counts}),
    Table::number("greedy", &Params::greedy, 0, 1,
                  "share of steps that take the largest weight, q0"),
    Table::number("critical_time", &Params::critical_time, 0, 1000000000,
                  "iteration from which exponents and shares are constant, but for the distance "
                  "rule's until settling_time, mc; 0: always"),
    Table::number("alpha_first", &Params::alpha_first, 0, 20, "alpha at iteration 0")
        .only_with(kUntilCriticalTime),
    Table::number("beta_first", &Params::beta_first, 0, 20, "beta at iteration 0")
        .only_with({"critical_time above 0 and settings that read beta", first_beta_counts}),
    Table::number("omega", &Params::omega, 0, 1e6,
                  "rescaled distance: ((Dmax - d) omega + mu)^lambda"),
    Table::number("mu", &Params::mu, 1e-6, 1e6, "rescaled distance: offset"),
    Table::number("lambda", &Params::lambda, 0, 20, "rescaled distance: exponent"),
    Table::number("pheromone_rule_first", &Params::pheromone_rule_first, 0, 1e6,
                  "share of steps by pheromone and visibility at iteration 0")
        .only_with(kUntilCriticalTime),
    Table::number("pheromone_rule", &Params::pheromone_rule, 0, 1e6,
                  "share of steps by pheromone and visibility from the critical time on"),
    Table::number("distance_rule_first", &Params::distance_rule_first, 0, 1e6,
                  "share of steps by the heuristic alone at iteration 0")
        .only_with(kUntilCriticalTime),
    Table::number("distance_rule", &Params::distance_rule, 0, 1e6,
                  "share of steps by the heuristic alone at the critical time"),
    Table::number("distance_rule_last", &Params::distance_rule_last, 0, 1e6,
                  "share of steps by the heuristic alone from the settling time on", "0")
        .only_with({"settling_time above 0", [](const Params& p) { return p.settling_time > 0; }}),
    Table::number(
        "settling_time", &Params::settling_time, 0, 1000000000,
        "iteration from which the share of the distance rule is its last one; 0: it stays", "0"),
    Table::number("combined_rule_first", &Params::combined_rule_first, 0, 1e6,
                  "share of steps by the product of all weights at iteration 0")
        .only_with(kUntilCriticalTime),
    Table::number("combined_rule", &Params::combined_rule, 0, 1e6,
                  "share of steps by the product of all weights from the critical time on"),
    Table::choice<&Params::update, kUpdateNames>("update",
                                                 "how the trail changes after an iteration"),
    Table::number("persistence", &Params::persistence, 0, 1,
                  "share of pheromone that remains after an iteration"),
    Table::number("initial_pheromone", &Params::initial_pheromone, 0, 1e9,
                  "pheromone everywhere at first, tau0; 0: the formula of the update's source"),
    Table::number("deposit", &Params::deposit, 0, 1e9,
                  "an ant of tour length L deposits deposit / L, Q")
        .only_with({"for learning also initial_pheromone=0 or a straight_deposit", deposit_counts}),
    Table::choice<&Params::straight_deposit, kStraightDepositNames>(
        "straight_deposit", "which straightened paths get pheromone too")
        .only_with({"polish=straight|taut|local",
                    [](const Params& p) { return p.polish != Polish::none; }}),
    Table::number("elite_weight", &Params::elite_weight, 0, 1e6,
                  "weight of the best tour so far, e"),
    Table::number("ranks", &Params::ranks, 2, 1000000,
                  "weight of the best tour so far, w; w - 1 ranked ants deposit too"),
    Table::number("elite_ants", &Params::elite_ants, 1, 1000000, "ants that deposit"),
    Table::number("best_so_far_every", &Params::best_so_far_every, 0, 1000000000,
                  "iterations between deposits of the best tour so far; 0: never"),
    Table::number("best_probability", &Params::best_probability, 1e-9, 1,
                  "chance to draw the best tour again at the bounds, p_best"),
    Table::number("local_evaporation", &Params::local_evaporation, 0, 1,
                  "share of a crossed trail that returns to tau0, xi"),
    Table::number("batch", &Params::batch, 0, 1000000,
                  "ants that walk before a local update; 1 is the source, 0 all of them")
        .only_with(
            {"local_evaporation above 0", [](const Params& p) { return p.local_evaporation > 0; }}),
    Table::number("agreement", &Params::agreement, 0, 1000000000,
                  "iterations in a row with all ants on one way that end the run; 0: never", "0"),
    Table::number("islands", &Params::islands, 1, 1024,
                  "colonies with a trail of their own that the ants are shared among", "1"),
    Table::number("exchange_every", &Params::exchange_every, 1, 1000000000,
                  "iterations after which an island learns by another's best tour", "10")
        .only_with(kIslands),
    Table::choice<&Params::exchange, kExchangeNames>(
        "exchange", "by the tour of the island before, or the best that has come", "scheduled")
        .only_with(kIslands),
    Table::number("unknown_index", &Params::unknown_index, 1, 1e6,
                  "terminal index of unknown cells, for 20 x 20 cells"),
    Table::number("index_spread", &Params::index_spread, 0, 1, "q of K' = K - q Kmin"),
    Table::choice<&Params::index_answer, kIndexAnswerNames>(
        "index_answer", "reading of \"the largest gradient\" that an answer follows", "least-way"),
    Table::number("reward", &Params::reward, 0, 1e6, "factor of the reward"),
    Table::choice<&Params::reward_reading, kRewardNames>("reward_reading",
                                                         "reading of the reward's formula"),
    Table::number("penalty", &Params::penalty, 0, 1, "what a dead end leaves of tau and eta")
        .only_with({"dead_end=kill", [](const Params& p) { return p.dead_end == DeadEnd::kill; }}),
};

// What the genetic algorithm has of its own.
constexpr std::array kGenetic{
    Table::number("population", &Params::population, 2, 1000000, "paths of a generation"),
    Table::number("crossover", &Params::crossover, 0, 1, "probability that two parents cross"),
    Table::number("mutation", &Params::mutation, 0, 1,
                  "probability that a child gets a new way to the goal"),
};

// What the genetic algorithm shares with the colonies, then its own.
constexpr auto kGeneticParameters = [] {
  constexpr std::array<std::string_view, 5> kShared{"iterations", "neighbours", "corners", "polish",
                                                    "straight_window"};
  std::array<Parameter, kShared.size() + kGenetic.size()> list;
  auto next = list.begin();
  for (const Entry& e : kColony) {
    if (std::ranges::find(kShared, e.info.name) == kShared.end()) continue;
    *next = e.info;
    if (e.info.name == "neighbours") next->choices = next->choices.first(2);  // see validate()
    ++next;
  }
  for (const Entry& e : kGenetic) *next++ = e.info;
  return list;
}();

constexpr std::array kEntries{std::span<const Entry>(kColony), std::span<const Entry>(kGenetic)};

constexpr Table kTable(kEntries);

// Is it read only with other values of other parameters?
bool waits(const Params& p, const Entry& e) {
  const auto named = [&](const auto& rules) {
    return std::ranges::any_of(rules, [&](const auto& rule) { return rule.reads(e.info.name); });
  };
  const bool by_rules = named(kHeuristics) || named(kVisibilities) || named(kUpdates);
  return (by_rules && !is_read_by_rules(p, e.info.name)) || (e.is_read != nullptr && !e.is_read(p));
}

/// Numbers that go together. @throws Error(invalid_parameter).
void check_numbers(const Params& params) {
  const double first =
      params.pheromone_rule_first + params.distance_rule_first + params.combined_rule_first;
  const double last = params.pheromone_rule + params.distance_rule + params.combined_rule;
  const double end = params.pheromone_rule + params.distance_rule_last + params.combined_rule;
  if (!(last > 0) || (params.critical_time > 0 && !(first > 0)) ||
      (params.settling_time > 0 && !(end > 0)))
    refuse("the shares of the pheromone, distance and combined rules are all 0",
           "give one of them a share above 0");
  for (const auto& [name, value] : {std::pair{"initial_pheromone", params.initial_pheromone},
                                    std::pair{"deposit", params.deposit}})
    if (value != 0 && value < kLeastPheromone && why_unread(params, name).empty())
      refuse(std::string(name) + " is positive, but below 1e-12",
             "give both pheromones larger values: only their ratio counts");
  if (params.islands > params.ants)
    refuse("islands is " + std::to_string(params.islands) + ", and ants " +
               std::to_string(params.ants),
           "give each island an ant or more, ten are usual");
  if (params.settling_time > 0 && params.settling_time <= params.critical_time)
    refuse("settling_time is " + std::to_string(params.settling_time) +
               ", not after critical_time, " + std::to_string(params.critical_time),
           "set it to more, or to 0 for a share that stays");
}

/// Choices that go together. @throws Error(invalid_parameter).
void check_rules(const Params& params) {
  const bool inverse = params.selection == Selection::inverse_roulette;
  const bool index = params.update == Update::terminal_index;
  const bool learning = params.update == Update::learning;
  const bool cells = params.trail == Trail::cells;
  const bool straight_deposits = straight_paths_deposit(params);
  if (!cells && straight_deposits)
    refuse("straight_deposit lays pheromone on cells, but the trail is on arcs",
           "set trail to cells or straight_deposit to none");
  if (inverse != index)
    refuse(
        "the inverse roulette discards large weights, which only the terminal index gives to "
        "bad moves",
        "set selection to inverse-roulette and update to terminal-index, or neither");
  if (inverse && (mixes_rules(params) || params.greedy > 0))
    refuse("the inverse roulette knows one rule and no greedy steps",
           "set greedy and the shares of the pheromone and distance rules to 0");
  if ((index || learning) && !cells)
    refuse("this update keeps one value a cell, not one an arc", "set trail to cells");
  if (index && straight_deposits)
    refuse("the terminal index is no pheromone that could be laid", "set straight_deposit to none");
  if ((params.heuristic == Heuristic::learned) != learning)
    refuse("the learned heuristic and the update learning belong together",
           "set heuristic to learned and update to learning, or neither");
}

}  // namespace

std::span<const Parameter> colony_parameters() {
  static const auto words = [] {  // made on first use, see algorithms()
    std::array<std::string, kColony.size()> all;
    std::ranges::transform(kColony, all.begin(), only_with, &Entry::info);
    return all;
  }();
  static const auto list = [] {
    auto all = Table::infos(kColony);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].only_with = words[i];
    return all;
  }();
  return list;
}
std::span<const Parameter> genetic_parameters() noexcept { return kGeneticParameters; }

void set_parameter(Params& params, std::string_view name, std::string_view value) {
  kTable.set(params, name, value);
}

std::string get_parameter(const Params& params, std::string_view name) {
  return kTable.get(params, name);
}

std::string why_unread(const Params& params, std::string_view name) {
  if (name == kEvaporation) name = kPersistence;
  const Entry& e = kTable.entry(name);
  if (!find_algorithm(params.algorithm()).has(name))
    return params.algorithm() + " does not read it";
  if (!waits(params, e)) return {};
  return "it is read only with " + only_with(e.info);
}

void reset_unread(Params& params) {
  const Params published(params.algorithm());
  Params reset = params;
  for (const Parameter& p : find_algorithm(params.algorithm()).parameters)
    if (waits(params, kTable.entry(p.name)))
      kTable.set(reset, p.name, kTable.get(published, p.name));
  params = reset;
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
  check_numbers(params);
  check_rules(params);
  if (algorithm.kind == Algorithm::Kind::genetic && params.neighbours > Neighbours::eight)
    refuse(params.algorithm() + " knows moves to 4 or 8 neighbours only",
           "set neighbours to 4 or 8");
}

}  // namespace lasius
