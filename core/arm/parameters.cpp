#include <array>
#include <string>
#include <vector>

#include "core/params/parameter_table.h"
#include "lasius/arm/plan.h"

namespace lasius::arm {
namespace {

using Table = ParameterTable<Params>;
using Entry = Table::Entry;

constexpr std::array<std::string_view, 2> kSwitch{"off", "on"};

constexpr Table::Condition kAnts{"trees=0", [](const Params& p) { return p.trees == 0; }};

constexpr std::array kEntries{
    Table::number("ants", &Params::ants, 1, 1000000, "ants an iteration, m").only_with(kAnts),
    Table::number("iterations", &Params::iterations, 0, 1000000000, "iterations, T")
        .only_with(kAnts),
    Table::number("alpha", &Params::alpha, 0, 8, "exponent of pheromone").only_with(kAnts),
    Table::number(
        "beta", &Params::beta, 0, 20,
        "exponent of 1 / weight of an edge; all that exist weigh the same: without effect")
        .only_with(kAnts),
    Table::number("gamma", &Params::gamma, 0, 20,
                  "exponent of u = 1 / (1 + theta), theta between a move and the way to the goal")
        .only_with(kAnts),
    Table::number("persistence", &Params::persistence, 0, 1,
                  "share of pheromone that remains after an iteration")
        .only_with(kAnts),
    Table::number("elite_weight", &Params::elite_weight, 0, 1e6,
                  "weight of the iteration's best tour, e")
        .only_with(kAnts),
    Table::number("initial_pheromone", &Params::initial_pheromone, 0, 1e9,
                  "pheromone everywhere at first, tau0; 0: ants / Manhattan distance")
        .only_with(kAnts),
    Table::choice<&Params::pheromone, kPheromoneNames>("pheromone", "what carries pheromone")
        .only_with(kAnts),
    Table::choice<&Params::dead_end, kDeadEndNames>("dead_end",
                                                    "what an ant does when every move is closed")
        .only_with(kAnts),
    Table::number("pitch", &Params::pitch, 0, 1000,
                  "distance of lattice points, metres; 0: a twentieth of the arm's reach"),
    Table::number("side", &Params::side, 0, 254,
                  "lattice points a side, about the middle of start and goal; 0: all in reach"),
    Table::number("joint_step", &Params::joint_step, 1e-6, 100,
                  "an edge is closed where a joint moves further, radians or metres"),
    Table::number("patience", &Params::patience, 0, 1000000000,
                  "stop after so many iterations without a shorter path; 0: never")
        .only_with(kAnts),
    Table::number("line_ants", &Params::line_ants, 0, 1e6,
                  "ants whose deposits lie on the straight way before the first iteration")
        .only_with(kAnts),
    Table::choice<&Params::shortcut, kSwitch>("shortcut",
                                              "cut the lattice staircase before the trajectory"),
    Table::choice<&Params::direct, kSwitch>("direct", "first try the straight joint-space line",
                                            "off"),
    Table::number("trees", &Params::trees, 0, 1000000000,
                  "then grow two trees by so many joint values; 0: search the lattice", "0"),
    Table::choice<&Params::objective, kObjectiveNames>("objective", "what is optimised", "length"),
    Table::number("max_questions", &Params::max_questions, 0, 2000000000,
                  "questions that may be asked, the motion's included; 0: any number", "0"),
    Table::number("shortcuts", &Params::shortcuts, 0, 1000000,
                  "random straight motions tried to shorten the motion", "0"),
    Table::choice<&Params::timing, kTimingNames>(
        "timing", "rounded corners and the least time, or the source's splines", "splines"),
};

constexpr auto kInfos = Table::infos(kEntries);

constexpr std::string_view kSource =
    "Goritov, Goncharov: Motion trajectory planning for a multi-link manipulator in an "
    "unknown environment based on ant colony optimization. Proceedings of TUSUR "
    "University 23 (2), 2020";

constexpr std::array kAlgorithms{
    Algorithm{"postures",
              "arms (lasius arm): the straight line, then two trees of motions that are free all "
              "along, shortened",
              kSource, kInfos},
    Algorithm{"goritov2020",
              "arms among unknown obstacles: the source's ants, one posture a lattice point, drawn "
              "to pheromone and the direction of the goal",
              kSource, kInfos}};

/// tau0 is "a small positive number", whatever m is.
void goritov2020(Params& p) { p.initial_pheromone = 0.01; }

/// Ours.
void postures(Params& p) {
  goritov2020(p);
  p.joint_step = 1.5;
  p.direct = true;
  p.trees = 50000;
  p.shortcuts = 100;
  p.timing = Timing::optimal;
}

// In the order of kAlgorithms.
constexpr std::array<void (*)(Params&), kAlgorithms.size()> kPresets{postures, goritov2020};

constexpr std::array kLists{std::span<const Entry>(kEntries)};
constexpr Table kTable(kLists);

}  // namespace

std::span<const Algorithm> algorithms() noexcept { return kAlgorithms; }

const Algorithm& find_algorithm(std::string_view name) {
  return lasius::find_algorithm(kAlgorithms, name);
}

Params::Params(std::string_view algorithm) {
  const Algorithm& found = find_algorithm(algorithm);
  algorithm_ = found.name;
  kPresets[static_cast<std::size_t>(&found - kAlgorithms.data())](*this);
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

std::string why_unread(const Params& parameters, std::string_view name) {
  const Entry& e = kTable.entry(name);
  if (e.is_read == nullptr || e.is_read(parameters)) return {};
  return "it is read only with " + std::string(e.info.only_with);
}

std::string get_parameter(const Params& parameters, std::string_view name) {
  return kTable.get(parameters, name);
}

void validate(const Params& parameters) {
  kTable.check(parameters);
  if (parameters.initial_pheromone > 0 && parameters.initial_pheromone < kLeastPheromone)
    refuse("initial_pheromone is positive, but below 1e-12",
           "give a larger one, or 0 for ants / Manhattan distance");
}

}  // namespace lasius::arm
