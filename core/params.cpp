#include "lasius/params.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <variant>
#include <vector>

#include "lasius/error.h"
#include "nearest_name.h"
#include "presets.h"

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

using Names = std::span<const std::string_view>;
constexpr std::string_view kNeighbours[]{"4", "8", "16", "16k", "24", "32"};
constexpr std::string_view kCorners[]{"forbid", "one-side", "allow"};
constexpr std::string_view kPolish[]{"none", "straight", "taut"};
constexpr std::string_view kDeadEnd[]{"backtrack", "kill"};
constexpr std::string_view kSelection[]{"roulette", "inverse-roulette"};
constexpr std::string_view kTrail[]{"cells", "arcs"};
constexpr std::string_view kHeuristic[]{"uniform",       "rescaled-distance", "inverse-distance",
                                        "distance",      "goal-angle",        "learned",
                                        "distance-field"};
constexpr std::string_view kVisibility[]{"none", "inverse-step", "heading-change"};
constexpr std::string_view kUpdate[]{"ant-system",    "elitist",    "rank",           "max-min",
                                     "colony-system", "best-share", "terminal-index", "learning"};
constexpr std::string_view kStraightDeposit[]{"none", "improving", "all"};
constexpr std::string_view kReward[]{"factor", "affine"};

// Every parameter of the grid colonies.
constexpr std::array kColony{
    Entry{{"ants", "integer", "1 .. 1000000", "ants an iteration, m"},
          Integer{&Params::ants, 1, 1000000}},
    Entry{{"iterations", "integer", "0 .. 1000000000", "iterations, T"},
          Integer{&Params::iterations, 0, 1000000000}},
    Entry{{"neighbours", "choice", "4|8|16|16k|24|32", "moves of an ant"},
          choice<&Params::neighbours>(kNeighbours)},
    Entry{{"corners", "choice", "forbid|one-side|allow",
           "free side cells that a diagonal move needs: both, one, none"},
          choice<&Params::corners>(kCorners)},
    Entry{{"polish", "choice", "none|straight|taut", "what is done with each ant's tour"},
          choice<&Params::polish>(kPolish)},
    Entry{{"dead_end", "choice", "backtrack|kill", "what an ant does when every move is closed"},
          choice<&Params::dead_end>(kDeadEnd)},
    Entry{{"selection", "choice", "roulette|inverse-roulette",
           "how a move is drawn from its row of weights"},
          choice<&Params::selection>(kSelection)},
    Entry{{"trail", "choice", "cells|arcs", "what carries pheromone"},
          choice<&Params::trail>(kTrail)},
    Entry{{"heuristic", "choice",
           "uniform|rescaled-distance|inverse-distance|distance|goal-angle|learned|distance-field",
           "weight of a move by where it leads"},
          choice<&Params::heuristic>(kHeuristic)},
    Entry{{"visibility", "choice", "none|inverse-step|heading-change",
           "weight of a move by itself and the one before"},
          choice<&Params::visibility>(kVisibility)},
    Entry{{"alpha", "number", "0 .. 20", "exponent of pheromone from the critical time on"},
          Number{&Params::alpha, 0, 20}},
    Entry{{"beta", "number", "0 .. 20", "exponent of visibility and inverse distance, likewise"},
          Number{&Params::beta, 0, 20}},
    Entry{{"greedy", "number", "0 .. 1", "share of steps that take the largest weight, q0"},
          Number{&Params::greedy, 0, 1}},
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
    Entry{{"update", "choice",
           "ant-system|elitist|rank|max-min|colony-system|best-share|terminal-index|learning",
           "how the trail changes after an iteration"},
          choice<&Params::update>(kUpdate)},
    Entry{{"persistence", "number", "0 .. 1", "share of pheromone that remains after an iteration"},
          Number{&Params::persistence, 0, 1}},
    Entry{{"initial_pheromone", "number", "0 .. 1e9",
           "pheromone everywhere at first, tau0; 0: the formula of the update's source"},
          Number{&Params::initial_pheromone, 0, 1e9}},
    Entry{{"deposit", "number", "0 .. 1e9", "an ant of tour length L deposits deposit / L, Q"},
          Number{&Params::deposit, 0, 1e9}},
    Entry{{"straight_deposit", "choice", "none|improving|all",
           "which straightened paths get pheromone too"},
          choice<&Params::straight_deposit>(kStraightDeposit)},
    Entry{{"elite_weight", "number", "0 .. 1e6", "weight of the best tour so far (elitist), e"},
          Number{&Params::elite_weight, 0, 1e6}},
    Entry{{"ranks", "integer", "1 .. 1000000", "ranks that deposit (rank), w"},
          Integer{&Params::ranks, 1, 1000000}},
    Entry{{"elite_ants", "integer", "1 .. 1000000", "ants that deposit (best-share)"},
          Integer{&Params::elite_ants, 1, 1000000}},
    Entry{{"best_so_far_every", "integer", "0 .. 1000000000",
           "iterations between deposits of the best tour so far (max-min); 0: never"},
          Integer{&Params::best_so_far_every, 0, 1000000000}},
    Entry{{"best_probability", "number", "1e-9 .. 1",
           "chance to draw the best tour again at the bounds (max-min), p_best"},
          Number{&Params::best_probability, 1e-9, 1}},
    Entry{{"local_evaporation", "number", "0 .. 1",
           "share of a crossed trail that returns to tau0 (colony-system), xi"},
          Number{&Params::local_evaporation, 0, 1}},
    Entry{{"batch", "integer", "0 .. 1000000",
           "ants that walk before a local update; 1 is the source, 0 all of them"},
          Integer{&Params::batch, 0, 1000000}},
    Entry{{"unknown_index", "number", "1 .. 1e6",
           "terminal index of unknown cells, for 20 x 20 cells"},
          Number{&Params::unknown_index, 1, 1e6}},
    Entry{{"index_spread", "number", "0 .. 1", "q of K' = K - q Kmin (terminal-index)"},
          Number{&Params::index_spread, 0, 1}},
    Entry{{"reward", "number", "0 .. 1e6", "factor of the reward (learning)"},
          Number{&Params::reward, 0, 1e6}},
    Entry{{"reward_reading", "choice", "factor|affine", "reading of the reward's formula"},
          choice<&Params::reward_reading>(kReward)},
    Entry{{"penalty", "number", "0 .. 1", "what a dead end leaves of tau and eta (learning)"},
          Number{&Params::penalty, 0, 1}},
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

constexpr auto kColonyParameters = [] {
  std::array<Parameter, kColony.size()> list;
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = kColony[i].info;
  return list;
}();

// What the genetic algorithm shares with the colonies, then its own.
constexpr auto kGeneticParameters = [] {
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

constexpr std::array kEntries{std::span<const Entry>(kColony), std::span<const Entry>(kGenetic)};

Error invalid(std::string problem, std::string remedy) {
  return {ErrorCode::invalid_parameter, std::move(problem), std::move(remedy)};
}

const Entry& entry(std::string_view name) {
  std::vector<std::string_view> names;
  for (const auto list : kEntries) {
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

}  // namespace

std::span<const Parameter> colony_parameters() noexcept { return kColonyParameters; }
std::span<const Parameter> genetic_parameters() noexcept { return kGeneticParameters; }

void set_parameter(Params& params, std::string_view name, std::string_view value) {
  const Entry& e = entry(name);
  std::visit(Setter{params, e.info, value}, e.value);
}

std::string get_parameter(const Params& params, std::string_view name) {
  return std::visit(Getter{params}, entry(name).value);
}

void validate(const Params& params) {
  find_algorithm(params.algorithm);
  for (const auto list : kEntries) {
    for (const Entry& e : list) {
      if (std::visit(InRange{params}, e.value)) continue;
      out_of_range(e.info, get_parameter(params, e.info.name));
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
  const bool mixture = params.pheromone_rule_first > 0 || params.pheromone_rule > 0 ||
                       params.distance_rule_first > 0 || params.distance_rule > 0;
  const bool inverse = params.selection == Selection::inverse_roulette;
  const bool index = params.update == Update::terminal_index;
  const bool learning = params.update == Update::learning;
  const bool cells = params.trail == Trail::cells;
  const auto refuse_if = [](bool wrong, const char* problem, const char* remedy) {
    if (wrong) throw invalid(problem, remedy);
  };
  refuse_if(!cells && params.straight_deposit != StraightDeposit::none,
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
  refuse_if(index && params.straight_deposit != StraightDeposit::none,
            "the terminal index is no pheromone that could be laid",
            "set straight_deposit to none");
  refuse_if((params.heuristic == Heuristic::learned) != learning,
            "the learned heuristic and the update learning belong together",
            "set heuristic to learned and update to learning, or neither");
  refuse_if(params.algorithm == "grid-ga" && params.neighbours > Neighbours::eight,
            "grid-ga knows moves to 4 or 8 neighbours only", "set neighbours to 4 or 8");
}

}  // namespace lasius
