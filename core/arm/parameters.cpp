#include <array>
#include <string>
#include <vector>

#include "core/params/parameter_table.h"
#include "lasius/arm_plan.h"

namespace lasius::arm {
namespace {

using Table = ParameterTable<Params>;
using Entry = Table::Entry;
using Integer = Table::Integer;
using Number = Table::Number;

constexpr std::array<std::string_view, 2> kSwitch{"off", "on"};

constexpr std::array kEntries{
    Entry{{"ants", "integer", "1 .. 1000000", "ants an iteration, m"},
          Integer{&Params::ants, 1, 1000000}},
    Entry{{"iterations", "integer", "0 .. 1000000000", "iterations, T"},
          Integer{&Params::iterations, 0, 1000000000}},
    Entry{{"alpha", "number", "0 .. 8", "exponent of pheromone"}, Number{&Params::alpha, 0, 8}},
    Entry{{"beta", "number", "0 .. 20",
           "exponent of 1 / weight of an edge; all that exist weigh the same: without effect"},
          Number{&Params::beta, 0, 20}},
    Entry{{"gamma", "number", "0 .. 20",
           "exponent of u = 1 / (1 + theta), theta between a move and the way to the goal"},
          Number{&Params::gamma, 0, 20}},
    Entry{{"persistence", "number", "0 .. 1", "share of pheromone that remains after an iteration"},
          Number{&Params::persistence, 0, 1}},
    Entry{{"elite_weight", "number", "0 .. 1e6", "weight of the iteration's best tour, e"},
          Number{&Params::elite_weight, 0, 1e6}},
    Entry{{"initial_pheromone", "number", "0 .. 1e9",
           "pheromone everywhere at first, tau0; 0: ants / Manhattan distance"},
          Number{&Params::initial_pheromone, 0, 1e9}},
    Table::choice<&Params::pheromone, kPheromoneNames>("pheromone", "what carries pheromone"),
    Table::choice<&Params::dead_end, kDeadEndNames>("dead_end",
                                                    "what an ant does when every move is closed"),
    Entry{{"pitch", "number", "0 .. 1000",
           "distance of lattice points, metres; 0: a twentieth of the arm's reach"},
          Number{&Params::pitch, 0, 1000}},
    Entry{{"side", "integer", "0 .. 254",
           "lattice points a side, about the middle of start and goal; 0: all in reach"},
          Integer{&Params::side, 0, 254}},
    Entry{{"joint_step", "number", "0.000001 .. 100",
           "an edge is closed where a joint moves further, radians or metres"},
          Number{&Params::joint_step, 1e-6, 100}},
    Entry{{"patience", "integer", "0 .. 1000000000",
           "stop after so many iterations without a shorter path; 0: never"},
          Integer{&Params::patience, 0, 1000000000}},
    Entry{{"line_ants", "number", "0 .. 1e6",
           "ants whose deposits lie on the straight way before the first iteration"},
          Number{&Params::line_ants, 0, 1e6}},
    Table::choice<&Params::shortcut, kSwitch>("shortcut",
                                              "cut the lattice staircase before the trajectory"),
    Entry{{"postures", "integer", "1 .. 16",
           "joint values that a lattice point may have, K; 1: the source's one, continued", "1"},
          Integer{&Params::postures, 1, 16}},
    Table::choice<&Params::direct, kSwitch>("direct", "first try the straight joint-space line",
                                            "off"),
    Entry{{"lines", "number", "0 .. 0.99",
           "weight of the straight joint-space line from where an ant is to a goal", "0"},
          Number{&Params::lines, 0, 0.99}},
    Entry{{"leash", "number", "0 .. 1e6",
           "steps that an ant may take, in those of the shortest way; 0: any number", "0"},
          Number{&Params::leash, 0, 1e6}},
    Entry{{"vias", "integer", "0 .. 1000",
           "random joint values tried to get past by, where ants ran out of steps", "0"},
          Integer{&Params::vias, 0, 1000}},
    Entry{{"refine", "integer", "0 .. 4", "halve the pitch so often where nothing is found", "0"},
          Integer{&Params::refine, 0, 4}},
    Table::choice<&Params::prove, kSwitch>("prove",
                                           "stop when no way in the lattice can be shorter", "off"),
    Table::choice<&Params::scout, kSwitch>(
        "scout", "the first ant sets out on the shortest way that may be open", "off"),
    Table::choice<&Params::objective, kObjectiveNames>("objective", "what is optimised", "length"),
    Entry{{"max_questions", "integer", "0 .. 2000000000",
           "questions that may be asked, the motion's included; 0: any number", "0"},
          Integer{&Params::max_questions, 0, 2000000000}},
    Entry{{"shortcuts", "integer", "0 .. 1000000",
           "random straight motions tried to shorten the motion", "0"},
          Integer{&Params::shortcuts, 0, 1000000}},
};

constexpr auto kInfos = Table::infos(kEntries);

constexpr std::string_view kSource =
    "Goritov, Goncharov: Motion trajectory planning for a multi-link manipulator in an "
    "unknown environment based on ant colony optimization. Proceedings of TUSUR "
    "University 23 (2), 2020";

const std::array kAlgorithms{
    Algorithm{"postures",
              "arms among unknown obstacles (lasius arm): ants in a lattice of tip positions, "
              "several postures a point; few questions",
              kSource, kInfos},
    Algorithm{"goritov2020",
              "arms among unknown obstacles: the source's ants, one posture a lattice point, drawn "
              "to pheromone and the direction of the goal",
              kSource, kInfos}};

constexpr std::array kLists{std::span<const Entry>(kEntries)};
constexpr Table kTable(kLists);

}  // namespace

std::span<const Algorithm> algorithms() noexcept { return kAlgorithms; }

const Algorithm& find_algorithm(std::string_view name) {
  return lasius::find_algorithm(kAlgorithms, name);
}

Params::Params(std::string_view algorithm) : algorithm_(find_algorithm(algorithm).name) {
  if (algorithm_ == "goritov2020") {
    initial_pheromone = 0.01;  // "a small positive number", the same whatever m is
    return;
  }
  ants = 2;
  iterations = 200;
  gamma = 8;
  joint_step = 1.5;
  postures = 6;
  direct = true;
  lines = 0.05;
  leash = 2;
  vias = 16;
  refine = 1;
  prove = true;
  scout = true;
  shortcuts = 100;
}

void set_parameter(Params& parameters, std::string_view name, std::string_view value) {
  kTable.set(parameters, name, value);
}

std::vector<std::string> formulas(const Params& parameters) {
  if (find_algorithm(parameters.algorithm()).kind != Algorithm::Kind::colony) return {};
  return {
      "weight of the move from v to w: tau^alpha * (1 / s)^beta * (1 / (1 + theta))^gamma; s the "
      "length of the move, theta the angle between it and the way to the goal, radians",
      "choice: in proportion to the weight among points not yet visited",
      "tau is pheromone, L the length of a tour",
      "update: tau <- persistence tau + sum over the arrived ants of 1 / L + elite_weight / L of "
      "the iteration's best"};
}

std::string get_parameter(const Params& parameters, std::string_view name) {
  return kTable.get(parameters, name);
}

void validate(const Params& parameters) {
  kTable.check(parameters);
  if (parameters.initial_pheromone > 0 && parameters.initial_pheromone < kLeastPheromone) {
    throw invalid_parameter("initial_pheromone is positive, but below 1e-12",
                            "give a larger one, or 0 for ants / Manhattan distance");
  }
}

}  // namespace lasius::arm
