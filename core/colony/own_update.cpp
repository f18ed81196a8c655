#include "core/colony/own_update.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/number_text.h"
#include "core/colony/pheromone_impl.h"
#include "core/grid/move_rule.h"
#include "core/loop/trail_rules.h"
#include "core/params/parameter_table.h"
#include "core/params/schedule.h"

namespace lasius {
namespace {

bool is_heuristic(double value) noexcept { return value >= 0 && value <= OwnRules::kMostHeuristic; }

/// @throws Error(invalid_parameter) for the first value that an ant could see and that is none.
void check_heuristic(std::span<const double> values, const Grid& grid, const Params& params) {
  const auto moves = moves_of(params.neighbours);
  const std::int64_t cells = std::int64_t{grid.width()} * grid.height();
  const auto size = std::ssize(values);
  if (size != cells && size != cells * moves.count)
    throw invalid_parameter("the own heuristic has " + std::to_string(size) + " values",
                            "give " + std::to_string(cells) + ", one a cell, or " +
                                std::to_string(cells * moves.count) + ", one a move");
  const int each = size == cells ? 1 : moves.count;
  for (auto bad = values.begin();; ++bad) {
    bad = std::find_if_not(bad, values.end(), is_heuristic);
    if (bad == values.end()) return;
    const auto at = bad - values.begin();
    const Cell cell{static_cast<int>(at / each % grid.width()),
                    static_cast<int>(at / each / grid.width())};
    if (grid.blocked(cell)) continue;
    if (each > 1 && !move_exists(grid, params.corners, cell, moves[static_cast<int>(at % each)]))
      continue;
    throw invalid_parameter(
        "heuristic[" + std::to_string(at) + "], of cell (" + std::to_string(cell.x) + ", " +
            std::to_string(cell.y) + "), is " + number_text(*bad),
        "a value of the heuristic is 0 .. " + number_text(OwnRules::kMostHeuristic));
  }
}

}  // namespace

std::vector<Cell> move_steps(Neighbours neighbours) {
  const auto moves = moves_of(neighbours);
  std::vector<Cell> steps(static_cast<std::size_t>(moves.count));
  for (int k = 0; k < moves.count; ++k) steps[k] = Cell{} + moves[k].to;
  return steps;
}

std::span<const TrailPlace> IterationTours::cells_of(int ant) const noexcept {
  return cells.subspan(offsets[ant], offsets[ant + 1] - offsets[ant]);
}

std::span<const TrailPlace> IterationTours::places_of(int ant) const noexcept {
  if (trail == Trail::cells) return cells_of(ant);
  return arcs.subspan(offsets[ant] - ant, offsets[ant + 1] - offsets[ant] - 1);
}

std::span<const TrailPlace> IterationTours::best_places() const noexcept {
  return trail == Trail::cells ? best_cells : best_arcs;
}

void check_own_rules(const OwnRules& own, const Grid& grid, const Params& params) {
  if (own.none()) return;
  if (find_algorithm(params.algorithm()).kind != Algorithm::Kind::colony)
    throw invalid_parameter("own rules are given, but " + params.algorithm() + " is no colony",
                            "choose a colony, as, say");
  if (own.update && params.update == Update::terminal_index)
    throw invalid_parameter("an own update is given, but the terminal index is no pheromone",
                            "choose another algorithm");
  if (own.heuristic.empty()) return;
  if (params.heuristic == Heuristic::learned)
    throw invalid_parameter("an own heuristic is given, but the ants learn theirs",
                            "choose an algorithm with another heuristic than learned");
  check_heuristic(own.heuristic, grid, params);
}

StepWeights own_weights(const OwnRules& own, const Params& params, int iteration) {
  const StepWeights w = own.schedule(iteration);
  const auto refuse = [iteration](std::string_view name, double value, const std::string& remedy) {
    throw invalid_parameter(std::string(name) + " of the own schedule at iteration " +
                                std::to_string(iteration) + " is " + number_text(value),
                            remedy);
  };
  struct Bounded {
    std::string_view name;
    double value, most;
  };
  for (const auto& [name, value, most] :
       {Bounded{"alpha", w.alpha, 20}, Bounded{"beta", w.beta, 20}, Bounded{"greedy", w.greedy, 1},
        Bounded{"pheromone_rule", w.pheromone_rule, 1e6},
        Bounded{"distance_rule", w.distance_rule, 1e6},
        Bounded{"combined_rule", w.combined_rule, 1e6}}) {
    if (!(value >= 0 && value <= most)) refuse(name, value, "it must be 0 .. " + number_text(most));
  }
  if (!mixes_rules(params) && w.pheromone_rule + w.distance_rule > 0)
    refuse(w.pheromone_rule > 0 ? "pheromone_rule" : "distance_rule",
           std::max(w.pheromone_rule, w.distance_rule),
           "give pheromone_rule or distance_rule of the parameters a share above 0, too");
  if (!(w.pheromone_rule + w.distance_rule + w.combined_rule > 0))
    refuse("every rule's share", 0, "give one of them a share above 0");
  return w;
}

void NumberedTours::Lists::add(const Tour& tour, TrailPlace cell, const kernels::Moves& moves,
                               int width, bool with_arcs) {
  std::array<TrailPlace, kernels::kMaxMoves> step{};
  for (int k = 0; k < moves.count; ++k)
    step[k] = std::int64_t{moves[k].to.dy} * width + moves[k].to.dx;
  const std::int64_t first = offsets.back(), before = std::ssize(offsets) - 1;
  TrailPlace* to = cells.data() + first;
  TrailPlace* arc = arcs.data() + (with_arcs ? first - before : 0);
  for (const int k : tour.moves) {
    *to++ = cell;
    if (with_arcs) *arc++ = cell * moves.count + k;
    cell += step[k];
  }
  *to = cell;
  offsets.push_back(first + std::ssize(tour.moves) + 1);
}

IterationTours NumberedTours::number(const Tours& tours, const Grid& grid, Trail trail,
                                     Poller& poller) {
  if (lists_ == nullptr || lists_.use_count() > 1) lists_ = std::make_shared<Lists>();
  Lists& lists = *lists_;
  const bool arcs = trail == Trail::arcs, arrived = trail_rules::arrived(tours.best_so_far);
  std::size_t cells = tours.best_so_far.moves.size() + 1;
  for (const Tour& tour : tours.ants) cells += tour.moves.size() + 1;
  lists.cells.grow(cells);
  if (arcs) lists.arcs.grow(cells);
  const TrailPlace start = std::int64_t{tours.start.y} * grid.width() + tours.start.x;
  lists.offsets.assign(1, 0);
  lists.lengths.clear();
  for (const Tour& tour : tours.ants) {
    lists.add(tour, start, tours.moves, grid.width(), arcs);
    lists.lengths.push_back(tour.length);
    if (poller.stop_after(std::ssize(tour.moves) + 1)) return {};
  }
  const auto ants = lists.lengths.size(), end = static_cast<std::size_t>(lists.offsets[ants]);
  if (arrived) lists.add(tours.best_so_far, start, tours.moves, grid.width(), arcs);
  const auto ranked = trail_rules::ranked(tours);
  lists.ranked.assign(ranked.begin(), ranked.end());
  IterationTours view;
  view.trail = trail;
  view.start = tours.start;
  view.iteration = tours.iteration;
  view.width = grid.width();
  view.height = grid.height();
  view.moves = tours.moves.count;
  view.cells = {lists.cells.data(), end};
  view.offsets = std::span(lists.offsets).first(ants + 1);
  if (arcs) view.arcs = {lists.arcs.data(), end - ants};
  view.lengths = lists.lengths;
  view.ranked = lists.ranked;
  view.memory = lists_;
  if (!arrived) return view;
  const std::size_t moves = tours.best_so_far.moves.size();
  view.best_cells = {lists.cells.data() + end, moves + 1};
  if (arcs) view.best_arcs = {lists.arcs.data() + (end - ants), moves};
  view.best_length = tours.best_so_far.length;
  return view;
}

bool update_by_caller(Field& field, const OwnRules& own, const Params& params, const Grid& grid,
                      Cell goal, const Tours& tours, NumberedTours& numbered,
                      const StopCondition& stop) {
  Poller poller(stop, Poller::kSteps);
  IterationTours view = numbered.number(tours, grid, params.trail, poller);
  if (poller.stopped()) return false;
  view.goal = goal;
  Pheromone::Impl impl(field, grid, params, tours.moves.count, poller);
  Pheromone trail(impl);
  own.update(trail, view);
  return view.stopped();
}

}  // namespace lasius
