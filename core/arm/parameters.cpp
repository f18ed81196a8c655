#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "lasius/arm_plan.h"
#include "lasius/error.h"
#include "nearest_name.h"

namespace lasius::arm {
namespace {

struct Integer {
  int Parameters::*member;
  int least, most;
};
struct Number {
  double Parameters::*member;
  double least, most;
};
/// One of a few names, kept as the number of the name.
struct Choice {
  std::span<const std::string_view> names;
  int (*get)(const Parameters&);
  void (*set)(Parameters&, int);
};

template <auto kMember>
constexpr Choice choice(std::span<const std::string_view> names) {
  using Value = std::remove_reference_t<decltype(std::declval<Parameters&>().*kMember)>;
  return {names, [](const Parameters& p) { return static_cast<int>(p.*kMember); },
          [](Parameters& p, int i) { p.*kMember = static_cast<Value>(i); }};
}

struct Entry {
  Parameter info;
  std::variant<Integer, Number, Choice> value;
};

constexpr std::string_view kPheromone[]{"arcs", "edges"};
constexpr std::string_view kDeadEnd[]{"backtrack", "kill"};
constexpr std::string_view kSwitch[]{"off", "on"};

constexpr std::array kEntries{
    Entry{{"ants", "integer", "1 .. 1000000", "ants an iteration, m"},
          Integer{&Parameters::ants, 1, 1000000}},
    Entry{{"iterations", "integer", "0 .. 1000000000", "iterations, T"},
          Integer{&Parameters::iterations, 0, 1000000000}},
    Entry{{"alpha", "number", "0 .. 8", "exponent of pheromone"}, Number{&Parameters::alpha, 0, 8}},
    Entry{{"beta", "number", "0 .. 20",
           "exponent of 1 / weight of an edge; all that exist weigh the same: without effect"},
          Number{&Parameters::beta, 0, 20}},
    Entry{{"gamma", "number", "0 .. 20",
           "exponent of u = 1 / (1 + theta), theta between a move and the way to the goal"},
          Number{&Parameters::gamma, 0, 20}},
    Entry{{"evaporation", "number", "0 .. 1", "share of pheromone lost in an iteration, rho"},
          Number{&Parameters::evaporation, 0, 1}},
    Entry{{"elite_weight", "number", "0 .. 1e6", "weight of the iteration's best tour, e"},
          Number{&Parameters::elite_weight, 0, 1e6}},
    Entry{{"initial_pheromone", "number", "0 .. 1e9",
           "pheromone everywhere at first, tau0; 0: ants / Manhattan distance"},
          Number{&Parameters::initial_pheromone, 0, 1e9}},
    Entry{{"pheromone", "choice", "arcs|edges", "what carries pheromone"},
          choice<&Parameters::pheromone>(kPheromone)},
    Entry{{"dead_end", "choice", "backtrack|kill", "what an ant does when every move is closed"},
          choice<&Parameters::dead_end>(kDeadEnd)},
    Entry{{"pitch", "number", "0 .. 1000",
           "distance of lattice points, metres; 0: a twentieth of the arm's reach"},
          Number{&Parameters::pitch, 0, 1000}},
    Entry{{"side", "integer", "0 .. 254",
           "lattice points a side, about the middle of start and goal; 0: all in reach"},
          Integer{&Parameters::side, 0, 254}},
    Entry{{"joint_step", "number", "0.000001 .. 100",
           "an edge is closed where a joint moves further, radians or metres"},
          Number{&Parameters::joint_step, 1e-6, 100}},
    Entry{{"patience", "integer", "0 .. 1000000000",
           "stop after so many iterations without a shorter path; 0: never"},
          Integer{&Parameters::patience, 0, 1000000000}},
    Entry{{"line_ants", "number", "0 .. 1e6",
           "ants whose deposits lie on the straight way before the first iteration"},
          Number{&Parameters::line_ants, 0, 1e6}},
    Entry{{"shortcut", "choice", "off|on", "cut the lattice staircase before the trajectory"},
          choice<&Parameters::shortcut>(kSwitch)},
};

constexpr auto kInfos = [] {
  std::array<Parameter, kEntries.size()> list;
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = kEntries[i].info;
  return list;
}();

const std::array kAlgorithms{Algorithm{
    "goritov2020",
    "arms among unknown obstacles (lasius arm): ants in a lattice of tip positions, drawn "
    "to pheromone and the direction of the goal",
    "Goritov, Goncharov: Motion trajectory planning for a multi-link manipulator in an "
    "unknown environment based on ant colony optimization. Proceedings of TUSUR "
    "University 23 (2), 2020",
    kInfos}};

Error invalid(std::string problem, std::string remedy) {
  return {ErrorCode::invalid_parameter, std::move(problem), std::move(remedy)};
}

const Entry& entry(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Entry& e : kEntries) {
    if (e.info.name == name) return e;
    names.push_back(e.info.name);
  }
  throw invalid("unknown parameter \"" + std::string(name) + "\"",
                "did you mean \"" + std::string(nearest_name(name, names)) + "\"?");
}

[[noreturn]] void out_of_range(const Parameter& info, std::string_view value) {
  throw invalid(std::string(info.name) + " is " + std::string(value),
                "it must be " + std::string(info.range));
}

template <class T>
T parse(const Parameter& info, std::string_view text, T least, T most) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || !(value >= least && value <= most)) out_of_range(info, text);
  return value;
}

struct Setter {
  Parameters& p;
  const Parameter& info;
  std::string_view text;

  void operator()(const Integer& v) const { p.*v.member = parse(info, text, v.least, v.most); }
  void operator()(const Number& v) const { p.*v.member = parse(info, text, v.least, v.most); }
  void operator()(const Choice& v) const {
    for (std::size_t i = 0; i < v.names.size(); ++i) {
      if (v.names[i] == text) return v.set(p, static_cast<int>(i));
    }
    throw invalid(std::string(info.name) + " is \"" + std::string(text) + "\"",
                  "did you mean \"" + std::string(nearest_name(text, v.names)) + "\"? It must be " +
                      std::string(info.range));
  }
};

struct Getter {
  const Parameters& p;

  std::string operator()(const Integer& v) const { return std::to_string(p.*v.member); }
  std::string operator()(const Number& v) const {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), p.*v.member).ptr};
  }
  std::string operator()(const Choice& v) const {
    const auto i = static_cast<std::size_t>(v.get(p));
    return i < v.names.size() ? std::string(v.names[i]) : "not one of its values";
  }
};

struct InRange {
  const Parameters& p;

  bool operator()(const Integer& v) const {
    return p.*v.member >= v.least && p.*v.member <= v.most;
  }
  bool operator()(const Number& v) const { return p.*v.member >= v.least && p.*v.member <= v.most; }
  bool operator()(const Choice& v) const {
    return static_cast<std::size_t>(v.get(p)) < v.names.size();
  }
};

}  // namespace

std::span<const Algorithm> algorithms() noexcept { return kAlgorithms; }

void set_parameter(Parameters& parameters, std::string_view name, std::string_view value) {
  const Entry& e = entry(name);
  std::visit(Setter{parameters, e.info, value}, e.value);
}

std::string get_parameter(const Parameters& parameters, std::string_view name) {
  return std::visit(Getter{parameters}, entry(name).value);
}

void validate(const Parameters& parameters) {
  for (const Entry& e : kEntries) {
    if (!std::visit(InRange{parameters}, e.value)) {
      out_of_range(e.info, get_parameter(parameters, e.info.name));
    }
  }
  if (parameters.seed > 9007199254740991u) {
    throw invalid("seed is " + std::to_string(parameters.seed), "it must be at most 2^53 - 1");
  }
  if (parameters.threads < 0) {
    throw invalid("threads is " + std::to_string(parameters.threads), "it must be 0 or more");
  }
}

}  // namespace lasius::arm
