#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lasius/error.h"
#include "lasius/polygon_plan.h"
#include "nearest_name.h"

namespace lasius::polygon {
namespace {

struct Integer {
  int Parameters::*member;
  int least, most;
};
struct Number {
  double Parameters::*member;
  double least, most;
};
struct GlobalBestChoice {};

struct Entry {
  Parameter info;
  std::variant<Integer, Number, GlobalBestChoice> value;
};

constexpr std::array<std::string_view, 2> kGlobalBest{"so-far", "iteration"};

constexpr Entry kIterations{{"iterations", "integer", "0 .. 1000000000", "iterations, NC"},
                            Integer{&Parameters::iterations, 0, 1000000000}};
constexpr Entry kRoutes{{"routes", "integer", "1 .. 1000",
                         "line sequences that are searched, the shortest through midpoints first"},
                        Integer{&Parameters::routes, 1, 1000}};

constexpr std::array kColony{
    Entry{{"ants", "integer", "1 .. 1000000", "ants an iteration, m"},
          Integer{&Parameters::ants, 1, 1000000}},
    kIterations,
    Entry{{"values", "integer", "2 .. 10001", "crossing points of a line, evenly spaced"},
          Integer{&Parameters::values, 2, 10001}},
    Entry{{"beta", "number", "0 .. 20", "exponent of visibility"},
          Number{&Parameters::beta, 0, 20}},
    Entry{{"greedy", "number", "0 .. 1", "share of choices that take the largest weight, q0"},
          Number{&Parameters::greedy, 0, 1}},
    Entry{{"evaporation", "number", "0 .. 1", "share of pheromone lost by either update, rho"},
          Number{&Parameters::evaporation, 0, 1}},
    Entry{{"initial_pheromone", "number", "0 .. 1e9",
           "pheromone everywhere at first, tau0; 0: 1 / (lines x Dijkstra's length)"},
          Number{&Parameters::initial_pheromone, 0, 1e9}},
    Entry{{"global_best", "choice", "so-far|iteration",
           "which best path the global update deposits on"},
          GlobalBestChoice{}},
    Entry{
        {"agreement", "integer", "0 .. 1000000000",
         "iterations in a row with all ants on one way that end the run; the source: 1; 0: never"},
        Integer{&Parameters::agreement, 0, 1000000000}},
    kRoutes,
};

constexpr std::array kGenetic{
    kIterations,
    Entry{{"population", "integer", "2 .. 1000000", "chromosomes"},
          Integer{&Parameters::population, 2, 1000000}},
    Entry{{"crossover", "number", "0 .. 1", "probability that two parents cross"},
          Number{&Parameters::crossover, 0, 1}},
    Entry{{"mutation", "number", "0 .. 1", "probability that a gene is drawn anew"},
          Number{&Parameters::mutation, 0, 1}},
    Entry{{"blend", "number", "0 .. 1", "share of the other parent in a child that was crossed"},
          Number{&Parameters::blend, 0, 1}},
    kRoutes,
};

template <std::size_t kCount>
constexpr std::array<Parameter, kCount> infos(const std::array<Entry, kCount>& entries) {
  std::array<Parameter, kCount> list;
  for (std::size_t i = 0; i < kCount; ++i) list[i] = entries[i].info;
  return list;
}
constexpr auto kColonyInfos = infos(kColony);
constexpr auto kGeneticInfos = infos(kGenetic);

constexpr std::array kAlgorithms{
    Algorithm{"exact",
              "shortest path of the world, over corners that see each other",
              "Lozano-Perez, Wesley: An algorithm for planning collision-free paths among "
              "polyhedral obstacles. Communications of the ACM 22 (10), 1979; with lazy sight",
              {}},
    Algorithm{"maklink-acs", "ant colony system over crossing points of MAKLINK lines",
              "lecture on ant algorithms for robot path planning, hybrid part; lines after Habib, "
              "Asama: Efficient method to generate collision free paths for an autonomous mobile "
              "robot based on new free space structuring approach. IROS 1991",
              kColonyInfos},
    Algorithm{
        "real-ga", "real-coded genetic algorithm over the same crossing points",
        "lecture on ant algorithms for robot path planning, the comparator of its hybrid part",
        kGeneticInfos},
};

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
  void operator()(GlobalBestChoice) const {
    const auto found = std::find(kGlobalBest.begin(), kGlobalBest.end(), text);
    if (found == kGlobalBest.end()) {
      throw invalid(std::string(info.name) + " is \"" + std::string(text) + "\"",
                    "did you mean \"" + std::string(nearest_name(text, kGlobalBest)) +
                        "\"? It must be " + std::string(info.range));
    }
    p.global_best = static_cast<GlobalBest>(found - kGlobalBest.begin());
  }
};

struct Getter {
  const Parameters& p;

  std::string operator()(const Integer& v) const { return std::to_string(p.*v.member); }
  std::string operator()(const Number& v) const {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), p.*v.member).ptr};
  }
  std::string operator()(GlobalBestChoice) const {
    const auto i = static_cast<std::size_t>(p.global_best);
    return i < kGlobalBest.size() ? std::string(kGlobalBest[i]) : "not one of its values";
  }
};

struct InRange {
  const Parameters& p;

  bool operator()(const Integer& v) const {
    return p.*v.member >= v.least && p.*v.member <= v.most;
  }
  bool operator()(const Number& v) const { return p.*v.member >= v.least && p.*v.member <= v.most; }
  bool operator()(GlobalBestChoice) const {
    return static_cast<std::size_t>(p.global_best) < kGlobalBest.size();
  }
};

}  // namespace

std::span<const Algorithm> algorithms() noexcept { return kAlgorithms; }

Parameters defaults(std::string_view algorithm) {
  std::vector<std::string_view> names;
  names.reserve(kAlgorithms.size());
  for (const Algorithm& known : kAlgorithms) names.push_back(known.name);
  if (std::find(names.begin(), names.end(), algorithm) == names.end()) {
    throw invalid("unknown algorithm \"" + std::string(algorithm) + "\"",
                  "did you mean \"" + std::string(nearest_name(algorithm, names)) + "\"?");
  }
  Parameters p;
  p.algorithm = algorithm;
  // The source's genetic algorithm takes 912 generations on average, its ants 175 iterations.
  if (algorithm == "real-ga") p.iterations = 1000;
  return p;
}

void set_parameter(Parameters& parameters, std::string_view name, std::string_view value) {
  const Entry& e = entry(name);
  std::visit(Setter{parameters, e.info, value}, e.value);
}

std::string get_parameter(const Parameters& parameters, std::string_view name) {
  return std::visit(Getter{parameters}, entry(name).value);
}

void validate(const Parameters& parameters) {
  defaults(parameters.algorithm);
  for (const auto list : kEntries) {
    for (const Entry& e : list) {
      if (std::visit(InRange{parameters}, e.value)) continue;
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

}  // namespace lasius::polygon
