#include <algorithm>
#include <array>
#include <vector>

#include "core/params/parameter_table.h"
#include "lasius/polygon/plan.h"

namespace lasius::polygon {
namespace {

using Table = ParameterTable<Params>;
using Entry = Table::Entry;

constexpr Entry kIterations =
    Table::number("iterations", &Params::iterations, 0, 1000000000, "iterations, NC");
constexpr Entry kRoutes =
    Table::number("routes", &Params::routes, 1, 1000,
                  "line sequences that are searched, the shortest through midpoints first");

constexpr std::array kColony{
    Table::number("ants", &Params::ants, 1, 1000000, "ants an iteration, m"),
    kIterations,
    Table::number("values", &Params::values, 2, 10001, "crossing points of a line, evenly spaced"),
    Table::number("beta", &Params::beta, 0, 20, "exponent of visibility"),
    Table::number("greedy", &Params::greedy, 0, 1,
                  "share of choices that take the largest weight, q0"),
    Table::number("persistence", &Params::persistence, 0, 1,
                  "share of pheromone that either update leaves"),
    Table::number("initial_pheromone", &Params::initial_pheromone, 0, 1e9,
                  "pheromone everywhere at first, tau0; 0: 1 / (lines x Dijkstra's length)"),
    Table::choice<&Params::global_best, kGlobalBestNames>(
        "global_best", "which best path the global update deposits on"),
    Table::number(
        "agreement", &Params::agreement, 0, 1000000000,
        "iterations in a row with all ants on one way that end the run; the source: 1; 0: never"),
    kRoutes,
};

constexpr std::array kGenetic{
    kIterations,
    Table::number("population", &Params::population, 2, 1000000, "chromosomes"),
    Table::number("crossover", &Params::crossover, 0, 1, "probability that two parents cross"),
    Table::number("mutation", &Params::mutation, 0, 1, "probability that a gene is drawn anew"),
    Table::number("blend", &Params::blend, 0, 1,
                  "share of the other parent in a child that was crossed"),
    kRoutes,
};

constexpr auto kColonyInfos = Table::infos(kColony);
constexpr auto kGeneticInfos = Table::infos(kGenetic);

constexpr std::array kAlgorithms{
    Algorithm{"exact",
              "shortest path of the world, over corners that see each other",
              "Lozano-Perez, Wesley: An algorithm for planning collision-free paths among "
              "polyhedral obstacles. Communications of the ACM 22 (10), 1979; with lazy sight",
              {},
              Algorithm::Kind::exact},
    Algorithm{"maklink-acs", "ant colony system over crossing points of MAKLINK lines",
              "lecture on ant algorithms for robot path planning, hybrid part; lines after Habib, "
              "Asama: Efficient method to generate collision free paths for an autonomous mobile "
              "robot based on new free space structuring approach. IROS 1991",
              kColonyInfos},
    Algorithm{
        "real-ga", "real-coded genetic algorithm over the same crossing points",
        "lecture on ant algorithms for robot path planning, the comparator of its hybrid part",
        kGeneticInfos, Algorithm::Kind::genetic},
};

constexpr std::array kEntries{std::span<const Entry>(kColony), std::span<const Entry>(kGenetic)};

constexpr Table kTable(kEntries);

Params settled(Params parameters) {
  parameters.iterations = iterations_of(parameters);
  return parameters;
}

}  // namespace

int iterations_of(const Params& parameters) {
  if (parameters.iterations != Params::kUsualIterations) return parameters.iterations;
  // The source's genetic algorithm takes 912 generations on average, its ants 175 iterations with
  // 11 values, steps of a tenth.
  if (find_algorithm(parameters.algorithm()).kind == Algorithm::Kind::genetic) return 1000;
  return std::max(200, 20 * (parameters.values - 1));
}

std::span<const Algorithm> algorithms() noexcept { return kAlgorithms; }

const Algorithm& find_algorithm(std::string_view name) {
  return lasius::find_algorithm(kAlgorithms, name);
}

Params::Params(std::string_view algorithm) {
  const Algorithm& found = find_algorithm(algorithm);
  algorithm_ = found.name;
  if (found.kind != Algorithm::Kind::genetic) return;
  routes = 1;
  values = 11;  // of the discrete optimum beside it
}

void set_parameter(Params& parameters, std::string_view name, std::string_view value) {
  kTable.set(parameters, name, value);
}

std::vector<std::string> formulas(const Params& parameters) {
  if (find_algorithm(parameters.algorithm()).kind != Algorithm::Kind::colony) return {};
  return {
      "weight of the point h on the next line: tau * eta^beta, eta = (1.1 - |h - h*|) / 1.1; h* "
      "that of the best path so far",
      "tau is pheromone, tau0 its first value, h a fraction of the line, L the length of a path",
      "choice: the largest weight with probability `greedy`, else in proportion to the weight",
      "update: after each choice tau <- persistence tau + (1 - persistence) tau0; after the "
      "iteration, on the best path so far, tau <- persistence tau + (1 - persistence) / L"};
}

std::string get_parameter(const Params& parameters, std::string_view name) {
  return kTable.get(settled(parameters), name);
}

void validate(const Params& parameters) {
  const Algorithm& algorithm = find_algorithm(parameters.algorithm());
  kTable.check(settled(parameters));
  kTable.check_unread(parameters, Params(algorithm.name), algorithm);
}

}  // namespace lasius::polygon
