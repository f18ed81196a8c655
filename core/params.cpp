#include "lasius/params.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <variant>
#include <vector>

#include "lasius/error.h"
#include "nearest_name.h"

namespace lasius {
namespace {

constexpr double kMaxSeed = 9007199254740991.0;  // 2^53 - 1: exact in JSON

// A parameter that is one of a few names, kept as an enum or as the number the name stands for.
struct Choice {
  std::span<const std::string_view> names;
  int (*get)(const Params&);
  void (*set)(Params&, int);
};

template <auto kMember>
constexpr Choice choice(std::span<const std::string_view> names) {
  using Value = std::remove_reference_t<decltype(std::declval<Params&>().*kMember)>;
  return {names, [](const Params& p) { return static_cast<int>(p.*kMember); },
          [](Params& p, int i) { p.*kMember = static_cast<Value>(i); }};
}

struct Integer {
  int Params::*member;
  int least, most;
};
struct Number {
  double Params::*member;
  double least, most;
};

struct Entry {
  Parameter info;
  std::variant<Integer, Number, Choice> value;
};

constexpr std::array<std::string_view, 3> kCorners{"forbid", "one-side", "allow"};
constexpr std::array<std::string_view, 3> kPolish{"none", "straight", "taut"};
constexpr std::array<std::string_view, 2> kDeadEnd{"backtrack", "kill"};
constexpr std::array<std::string_view, 2> kTrail{"cells", "arcs"};
constexpr std::array<std::string_view, 3> kHeuristic{"uniform", "rescaled-distance",
                                                     "inverse-distance"};
constexpr std::array<std::string_view, 2> kVisibility{"none", "inverse-step"};
constexpr std::array<std::string_view, 3> kStraightDeposit{"none", "improving", "all"};
constexpr std::array<std::string_view, 2> kNeighbours{"4", "8"};

constexpr Choice kNeighboursChoice{kNeighbours,
                                   [](const Params& p) {
                                     return p.neighbours == 4 ? 0 : p.neighbours == 8 ? 1 : 2;
                                   },
                                   [](Params& p, int i) { p.neighbours = i == 0 ? 4 : 8; }};

// Every parameter of the grid colonies.
const std::array kColony{
    Entry{{"ants", "integer", "1 .. 1000000", "ants an iteration, m"},
          Integer{&Params::ants, 1, 1000000}},
    Entry{{"iterations", "integer", "0 .. 1000000000", "iterations, T"},
          Integer{&Params::iterations, 0, 1000000000}},
    Entry{{"neighbours", "choice", "4|8", "moves of an ant"}, kNeighboursChoice},
    Entry{{"corners", "choice", "forbid|one-side|allow",
           "free side cells that a diagonal move needs: both, one, none"},
          choice<&Params::corners>(kCorners)},
    Entry{{"polish", "choice", "none|straight|taut", "what is done with each ant's tour"},
          choice<&Params::polish>(kPolish)},
    Entry{{"dead_end", "choice", "backtrack|kill", "what an ant does when every move is closed"},
          choice<&Params::dead_end>(kDeadEnd)},
    Entry{{"trail", "choice", "cells|arcs", "what carries pheromone"},
          choice<&Params::trail>(kTrail)},
    Entry{{"heuristic", "choice", "uniform|rescaled-distance|inverse-distance",
           "weight of a move by where it leads"},
          choice<&Params::heuristic>(kHeuristic)},
    Entry{{"visibility", "choice", "none|inverse-step", "weight of a move by its length"},
          choice<&Params::visibility>(kVisibility)},
    Entry{{"alpha", "number", "0 .. 20", "exponent of pheromone from the critical time on"},
          Number{&Params::alpha, 0, 20}},
    Entry{{"beta", "number", "0 .. 20", "exponent of visibility and inverse distance, likewise"},
          Number{&Params::beta, 0, 20}},
    Entry{{"critical_time", "integer", "0 .. 1000000000",
           "iteration from which exponents and shares are constant, mc; 0: always"},
          Integer{&Params::critical_time, 0, 1000000000}},
    Entry{{"alpha_first", "number", "0 .. 20", "alpha at iteration 0"},
          Number{&Params::alpha_first, 0, 20}},
    Entry{{"beta_first", "number", "0 .. 20", "beta at iteration 0"},
          Number{&Params::beta_first, 0, 20}},
    Entry{{"omega", "number", "0 .. 1000000", "rescaled distance: ((Dmax - d) omega + mu)^lambda"},
          Number{&Params::omega, 0, 1e6}},
    Entry{{"mu", "number", "0.000001 .. 1000000", "rescaled distance: offset"},
          Number{&Params::mu, 1e-6, 1e6}},
    Entry{{"lambda", "number", "0 .. 20", "rescaled distance: exponent"},
          Number{&Params::lambda, 0, 20}},
    Entry{{"pheromone_rule_first", "number", "0 .. 1000000",
           "share of steps by pheromone alone at iteration 0"},
          Number{&Params::pheromone_rule_first, 0, 1e6}},
    Entry{{"pheromone_rule", "number", "0 .. 1000000", "the same from the critical time on"},
          Number{&Params::pheromone_rule, 0, 1e6}},
    Entry{{"distance_rule_first", "number", "0 .. 1000000",
           "share of steps by the heuristic alone at iteration 0"},
          Number{&Params::distance_rule_first, 0, 1e6}},
    Entry{{"distance_rule", "number", "0 .. 1000000", "the same from the critical time on"},
          Number{&Params::distance_rule, 0, 1e6}},
    Entry{{"combined_rule_first", "number", "0 .. 1000000",
           "share of steps by the product of both at iteration 0"},
          Number{&Params::combined_rule_first, 0, 1e6}},
    Entry{{"combined_rule", "number", "0 .. 1000000", "the same from the critical time on"},
          Number{&Params::combined_rule, 0, 1e6}},
    Entry{{"persistence", "number", "0 .. 1", "share of pheromone that remains after an iteration"},
          Number{&Params::persistence, 0, 1}},
    Entry{{"initial_pheromone", "number", "1e-9 .. 1e9", "pheromone everywhere at first, tau0"},
          Number{&Params::initial_pheromone, 1e-9, 1e9}},
    Entry{{"deposit", "number", "0 .. 1e9", "an ant of tour length L deposits deposit / L, Q"},
          Number{&Params::deposit, 0, 1e9}},
    Entry{{"straight_deposit", "choice", "none|improving|all",
           "which straightened paths get pheromone too"},
          choice<&Params::straight_deposit>(kStraightDeposit)},
};

// What the genetic algorithm has of its own.
const std::array kGenetic{
    Entry{{"population", "integer", "2 .. 1000000", "paths of a generation"},
          Integer{&Params::population, 2, 1000000}},
    Entry{{"crossover", "number", "0 .. 1", "probability that two parents cross"},
          Number{&Params::crossover, 0, 1}},
    Entry{{"mutation", "number", "0 .. 1", "probability that a child gets a new way to the goal"},
          Number{&Params::mutation, 0, 1}},
};

const auto kColonyParameters = [] {
  std::array<Parameter, kColony.size()> list;
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = kColony[i].info;
  return list;
}();

// What it shares with the colonies, then its own.
const auto kGeneticParameters = [] {
  constexpr std::array<std::string_view, 4> kShared{"iterations", "neighbours", "corners",
                                                    "polish"};
  std::array<Parameter, kShared.size() + kGenetic.size()> list;
  auto next = list.begin();
  for (const Entry& e : kColony) {
    if (std::find(kShared.begin(), kShared.end(), e.info.name) != kShared.end()) *next++ = e.info;
  }
  for (const Entry& e : kGenetic) *next++ = e.info;
  return list;
}();

const std::array kAlgorithms{
    Algorithm{"fan2004",
              "bitmaps of many irregular obstacles: pheromone, rescaled distance and their product "
              "mixed by roulette, exponents that vary with time, tours pulled straight",
              "Fan, Luo, Yi, Zhang: Path planning for robots based on ant colony optimization "
              "algorithm under complex environment. Control and Decision 19 (2), 2004",
              kColonyParameters},
    Algorithm{"as", "ant system, the classic: 8 neighbours, visibility 1 / distance to the goal",
              "Dorigo, Maniezzo, Colorni: Ant System: optimization by a colony of cooperating "
              "agents. IEEE Trans. SMC-B 26 (1), 1996",
              kColonyParameters},
    Algorithm{"grid-ga",
              "genetic algorithm, the comparator: paths of cells that cross where they meet",
              "Ahn, Ramakrishna: A genetic algorithm for shortest path routing problem and the "
              "sizing of populations. IEEE Trans. Evolutionary Computation 6 (6), 2002",
              kGeneticParameters},
};

Error invalid(std::string problem, std::string remedy) {
  return {ErrorCode::invalid_parameter, std::move(problem), std::move(remedy)};
}

const Entry& entry(std::string_view name) {
  std::vector<std::string_view> names;
  for (const std::span<const Entry> list : {std::span<const Entry>(kColony), {kGenetic}}) {
    for (const Entry& e : list) {
      if (e.info.name == name) return e;
      names.push_back(e.info.name);
    }
  }
  throw invalid("unknown parameter \"" + std::string(name) + "\"",
                "did you mean \"" + std::string(nearest_name(name, names)) + "\"?");
}

std::string shortest(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

template <class T>
std::optional<T> parse(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

[[noreturn]] void out_of_range(const Parameter& info, std::string_view value) {
  throw invalid(std::string(info.name) + " is " + std::string(value),
                "it must be " + std::string(info.range));
}

/// Reads and writes one parameter as text.
struct Setter {
  Params& params;
  const Parameter& info;
  std::string_view text;

  void operator()(const Integer& v) const {
    const auto value = parse<int>(text);
    if (!value || *value < v.least || *value > v.most) out_of_range(info, text);
    params.*v.member = *value;
  }
  void operator()(const Number& v) const {
    const auto value = parse<double>(text);
    if (!value || !(*value >= v.least && *value <= v.most)) out_of_range(info, text);
    params.*v.member = *value;
  }
  void operator()(const Choice& v) const {
    for (std::size_t i = 0; i < v.names.size(); ++i) {
      if (v.names[i] == text) return v.set(params, static_cast<int>(i));
    }
    throw invalid(std::string(info.name) + " is \"" + std::string(text) + "\"",
                  "did you mean \"" + std::string(nearest_name(text, v.names)) + "\"? It must be " +
                      std::string(info.range));
  }
};

struct Getter {
  const Params& params;

  std::string operator()(const Integer& v) const { return std::to_string(params.*v.member); }
  std::string operator()(const Number& v) const { return shortest(params.*v.member); }
  std::string operator()(const Choice& v) const {
    const auto i = static_cast<std::size_t>(v.get(params));
    return i < v.names.size() ? std::string(v.names[i]) : "not one of its values";
  }
};

/// Whether a parameter's value is one that it may have.
struct InRange {
  const Params& params;

  bool operator()(const Integer& v) const {
    return params.*v.member >= v.least && params.*v.member <= v.most;
  }
  bool operator()(const Number& v) const {
    return params.*v.member >= v.least && params.*v.member <= v.most;
  }
  bool operator()(const Choice& v) const {
    return static_cast<std::size_t>(v.get(params)) < v.names.size();
  }
};

void check_algorithm(std::string_view name) {
  std::array<std::string_view, kAlgorithms.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kAlgorithms[i].name;
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw invalid("unknown algorithm \"" + std::string(name) + "\"",
                "did you mean \"" + std::string(nearest_name(name, names)) + "\"?");
}

}  // namespace

std::span<const Algorithm> algorithms() noexcept { return kAlgorithms; }

Params defaults(std::string_view algorithm) {
  check_algorithm(algorithm);
  Params p;  // as published for fan2004
  p.algorithm = algorithm;
  if (algorithm == "as") {
    // The arcs of the graph carry pheromone, as in the source. Its iterations and ants are those of
    // fan2004; alpha, beta and evaporation 0.3 are those that found the optima of the small grids
    // of Li, Wang and Ma in all of 30 seeds.
    p.neighbours = 8;
    p.trail = Trail::arcs;
    p.heuristic = Heuristic::inverse_distance;
    p.visibility = Visibility::none;
    p.ants = 30;
    p.iterations = 100;
    p.alpha = p.alpha_first = 1;
    p.beta = p.beta_first = 5;
    p.critical_time = 0;
    p.pheromone_rule_first = p.pheromone_rule = 0;
    p.distance_rule_first = p.distance_rule = 0;
    p.combined_rule_first = p.combined_rule = 1;
    p.persistence = 0.7;
    p.deposit = 1;
    p.straight_deposit = StraightDeposit::none;
    p.polish = Polish::none;
  }
  if (algorithm == "grid-ga") {
    p.neighbours = 8;
    p.iterations = 100;
  }
  return p;
}

void set_parameter(Params& params, std::string_view name, std::string_view value) {
  const Entry& e = entry(name);
  std::visit(Setter{params, e.info, value}, e.value);
}

std::string get_parameter(const Params& params, std::string_view name) {
  return std::visit(Getter{params}, entry(name).value);
}

void validate(const Params& params) {
  check_algorithm(params.algorithm);
  for (const std::span<const Entry> list : {std::span<const Entry>(kColony), {kGenetic}}) {
    for (const Entry& e : list) {
      if (!std::visit(InRange{params}, e.value)) {
        out_of_range(e.info, get_parameter(params, e.info.name));
      }
    }
  }
  if (static_cast<double>(params.seed) > kMaxSeed) {
    throw invalid("seed is " + std::to_string(params.seed), "it must be at most 2^53 - 1");
  }
  if (params.threads < 0 || params.threads > 1024) {
    throw invalid("threads is " + std::to_string(params.threads),
                  "it must be 0 (all cores) to 1024");
  }
  const double first =
      params.pheromone_rule_first + params.distance_rule_first + params.combined_rule_first;
  const double last = params.pheromone_rule + params.distance_rule + params.combined_rule;
  if (!(last > 0) || (params.critical_time > 0 && !(first > 0))) {
    throw invalid("the shares of the pheromone, distance and combined rules are all 0",
                  "give one of them a share above 0");
  }
  if (params.trail == Trail::arcs && params.straight_deposit != StraightDeposit::none) {
    throw invalid("straight_deposit lays pheromone on cells, but the trail is on arcs",
                  "set trail to cells or straight_deposit to none");
  }
}

}  // namespace lasius
