#include <array>

#include "core/params/parameter_table.h"
#include "lasius/tour/ants.h"

namespace lasius::tour {
namespace {

using Table = ParameterTable<AntParams>;
using Entry = Table::Entry;

constexpr Entry kAnts =
    Table::number("ants", &AntParams::ants, 0, 1'000'000, "ants an iteration, m; 0: one a stop");
constexpr Entry kIterations =
    Table::number("iterations", &AntParams::iterations, 0, 1'000'000'000, "iterations");
constexpr Entry kAlpha = Table::number("alpha", &AntParams::alpha, 0, 20, "exponent of pheromone");
constexpr Entry kBeta =
    Table::number("beta", &AntParams::beta, 0, 20, "exponent of 1 / the leg's length");
constexpr Entry kGreedy = Table::number("greedy", &AntParams::greedy, 0, 1,
                                        "share of choices that take the largest weight, q0");
// From TrailParams, whose members a table of AntParams reads.
template <class Value>
constexpr Value AntParams::*of(Value TrailParams::*member) {
  return member;
}
constexpr Entry kPersistence = Table::number("persistence", of(&TrailParams::persistence), 0, 1,
                                             "share of pheromone that remains, 1 - rho");
constexpr Entry kInitial = Table::number("initial_pheromone", &AntParams::initial_pheromone, 0, 1e9,
                                         "pheromone at first, tau0; 0: the family's own formula");
constexpr Entry kDeposit = Table::number("deposit", of(&TrailParams::deposit), kLeastPheromone, 1e9,
                                         "Q of the deposits Q / length");
constexpr Entry kCandidates =
    Table::number("candidates", &AntParams::candidates, 0, 1'000'000,
                  "nearest stops that are chosen from as long as one is left; 0: all stops");
constexpr Entry kLocalSearch = Table::choice<&AntParams::local_search, kImprovementNames>(
    "local_search", "exchanges of edges, or of adjacent pieces, that improve every ant's tour");

constexpr std::array kSystem{kAnts,    kIterations, kAlpha,      kBeta,       kPersistence,
                             kInitial, kDeposit,    kCandidates, kLocalSearch};
template <std::size_t kMore>
constexpr std::array<Entry, kSystem.size() + kMore> with(const std::array<Entry, kMore>& more) {
  std::array<Entry, kSystem.size() + kMore> all{};
  std::ranges::copy(kSystem, all.begin());
  std::ranges::copy(more, all.begin() + kSystem.size());
  return all;
}
constexpr auto kElitist =
    with(std::array{Table::number("elite_weight", of(&TrailParams::elite_weight), 0, 1e6,
                                  "deposits on the best tour so far, e; 0: one a stop")});
constexpr auto kRank = with(std::array{
    Table::number("ranks", of(&TrailParams::ranks), 2, 1'000'000, "weight of the best tour, w")});
constexpr auto kMaxMin = with(
    std::array{Table::number("best_so_far_every", of(&TrailParams::best_so_far_every), 0, 1'000'000,
                             "every how many iterations the best tour so far deposits; 0: never"),
               Table::number("best_probability", of(&TrailParams::best_probability), 1e-9, 1 - 1e-9,
                             "p_best, which sets tau_min / tau_max")});
constexpr Entry kLocalEvaporation =
    Table::number("local_evaporation", of(&TrailParams::local_evaporation), 0, 1,
                  "xi of the update behind every step");
constexpr auto kColonySystem = with(std::array{kGreedy, kLocalEvaporation});
constexpr auto kSequential = with(std::array{
    kGreedy, kLocalEvaporation,
    Table::number("drawn", &AntParams::drawn, 0, 1'000'000,
                  "steps of a tour that are drawn in the mean, s: q0 = 1 - s / n; 0: greedy is q0"),
    Table::choice<&AntParams::greedy_step, kGreedyStepNames>(
        "greedy_step",
        "where q0 leads: to the largest weight, or on as the best tour does; then tours near it "
        "alone are improved, where they differ from it")});

constexpr auto kSystemInfos = Table::infos(kSystem);
constexpr auto kElitistInfos = Table::infos(kElitist);
constexpr auto kRankInfos = Table::infos(kRank);
constexpr auto kMaxMinInfos = Table::infos(kMaxMin);
constexpr auto kColonySystemInfos = Table::infos(kColonySystem);
constexpr auto kSequentialInfos = Table::infos(kSequential);

constexpr std::array kAlgorithms{
    Algorithm{"exact",
              "local search and recombination without pheromone; shortest legs",
              "docs/tours.md",
              {},
              Algorithm::Kind::exact},
    Algorithm{"as", "ant system over stops",
              "Dorigo, Maniezzo, Colorni: Ant system: optimization by a colony of cooperating "
              "agents. IEEE Transactions on SMC B 26 (1), 1996",
              kSystemInfos},
    Algorithm{"eas", "elitist ant system over stops",
              "Dorigo, Stuetzle: Ant Colony Optimization. MIT Press, 2004, section 3.3.2",
              kElitistInfos},
    Algorithm{"ras", "rank-based ant system over stops",
              "Bullnheimer, Hartl, Strauss: A new rank based version of the ant system. Central "
              "European Journal for Operations Research and Economics 7 (1), 1999",
              kRankInfos},
    Algorithm{"mmas", "MAX-MIN ant system over stops",
              "Stuetzle, Hoos: MAX-MIN ant system. Future Generation Computer Systems 16 (8), 2000",
              kMaxMinInfos},
    Algorithm{"acs", "ant colony system over stops",
              "Dorigo, Gambardella: Ant colony system: a cooperative learning approach to the "
              "traveling salesman problem. IEEE Transactions on Evolutionary Computation 1 (1), "
              "1997",
              kColonySystemInfos},
    Algorithm{
        "has-sop", "ant colony system with exchanges of pieces, for orders given in part",
        "Gambardella, Dorigo: An ant colony system hybridized with a new local search for the "
        "sequential ordering problem. INFORMS Journal on Computing 12 (3), 2000",
        kSequentialInfos},
    Algorithm{"eacs", "enhanced ant colony system: most steps are those of the best tour",
              "Gambardella, Montemanni, Weyland: Coupling ant colony systems with strong local "
              "searches. European Journal of Operational Research 220 (3), 2012",
              kSequentialInfos},
};

constexpr std::array kEntries{std::span<const Entry>(kElitist), std::span<const Entry>(kRank),
                              std::span<const Entry>(kMaxMin),
                              std::span<const Entry>(kColonySystem),
                              std::span<const Entry>(kSequential)};
constexpr Table kTable(kEntries);

}  // namespace

std::span<const Algorithm> algorithms() noexcept { return kAlgorithms; }

const Algorithm& find_algorithm(std::string_view name) {
  return lasius::find_algorithm(kAlgorithms, name);
}

AntParams::AntParams(std::string_view algorithm) : algorithm_(find_algorithm(algorithm).name) {
  persistence = 0.5;
  if (algorithm_ == "as" || algorithm_ == "eas" || algorithm_ == "ras") beta = 5;
  if (algorithm_ == "ras") persistence = 0.9;
  if (algorithm_ == "mmas") {
    persistence = 0.98;
    best_so_far_every = 5;
  }
  const bool sequential = algorithm_ == "has-sop" || algorithm_ == "eacs";
  if (sequential) {
    local_search = Improvement::pieces;
    drawn = 10;
  }
  if (algorithm_ == "eacs") greedy_step = GreedyStep::as_best;
  if (algorithm_ == "acs" || sequential) {
    ants = 10;
    greedy = 0.9;
    persistence = 0.9;
    local_evaporation = 0.1;
  }
}

void set_parameter(AntParams& params, std::string_view name, std::string_view value) {
  kTable.set(params, name, value);
}

std::string get_parameter(const AntParams& params, std::string_view name) {
  return kTable.get(params, name);
}

std::vector<std::string> formulas(const AntParams& params) {
  const std::string& name = params.algorithm();
  if (name == "exact") return {};
  std::string update = "update: tau <- persistence tau, then ";
  if (name == "as") update += "every ant Q / L on its tour";
  if (name == "eas") update += "every ant Q / L on its tour, and e Q / L on the best so far";
  if (name == "ras")
    update += "the ant of rank r < w (w - r) Q / L, and w Q / L on the best so far";
  if (name == "mmas")
    update +=
        "the iteration's best Q / L, in turns the best so far; tau_min <= tau <= tau_max = Q "
        "/ ((1 - persistence) L*)";
  const bool by_steps = find_algorithm(name).has("local_evaporation");
  if (by_steps)
    update =
        "update: behind every step tau <- (1 - xi) tau + xi tau0; behind the iteration, on "
        "the best so far, tau <- persistence tau + (1 - persistence) Q / L";
  std::string choice = "choice: in proportion to the weight";
  if (by_steps)
    choice = std::string("choice: ") +
             (params.greedy_step == GreedyStep::as_best
                  ? "on as the best tour so far, or where it cannot, to "
                  : "") +
             "the largest weight with probability " +
             (params.drawn > 0 ? "1 - drawn / n" : "`greedy`") +
             ", else in proportion to the weight";
  return {"weight of the leg to a stop: tau^alpha * (1 / d)^beta, d the leg's length",
          "tau is pheromone, tau0 its first value, L a tour's length", choice, update};
}

void validate(const AntParams& params) {
  kTable.check(params);
  kTable.check_unread(params, AntParams(params.algorithm()), find_algorithm(params.algorithm()));
}

}  // namespace lasius::tour
