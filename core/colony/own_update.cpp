#include "core/colony/own_update.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "core/base/number_text.h"
#include "core/grid/move_rule.h"
#include "core/loop/trail_rules.h"
#include "core/params/grid_parameters.h"
#include "core/params/parameter_table.h"

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
        "heuristic[" + std::to_string(at) + "], of cell " + pair_text(cell.x, cell.y) + ", is " +
            number_text(*bad),
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
  return tours_->cells_of(ant);
}

std::span<const TrailPlace> IterationTours::places_of(int ant) const noexcept {
  return trail == Trail::cells ? tours_->cells_of(ant) : tours_->arcs_of(ant);
}

std::span<const TrailPlace> IterationTours::cells() const noexcept { return tours_->cells(); }

std::span<const TrailPlace> IterationTours::arcs() const noexcept {
  if (trail == Trail::cells) return {};
  return tours_->arcs();
}

std::span<const TrailPlace> IterationTours::best_cells() const noexcept {
  if (!(best_length > 0)) return {};
  return tours_->cells_of(ants());
}

std::span<const TrailPlace> IterationTours::best_arcs() const noexcept {
  if (trail == Trail::cells || !(best_length > 0)) return {};
  return tours_->arcs_of(ants());
}

std::span<const TrailPlace> IterationTours::best_places() const noexcept {
  return trail == Trail::cells ? best_cells() : best_arcs();
}

void check_own_rules(const OwnRules& own, const Grid& grid, const Params& params) {
  if (own.none()) return;
  if (find_algorithm(params.algorithm()).kind != Algorithm::Kind::colony)
    throw invalid_parameter("own rules are given, but " + params.algorithm() + " is no colony",
                            "choose an ant colony");
  if (params.islands > 1)
    throw invalid_parameter("own rules are given, but they are of one colony", "set islands to 1");
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

std::array<TrailPlace, kernels::kMaxMoves> NumberedTours::steps() const noexcept {
  std::array<TrailPlace, kernels::kMaxMoves> step{};
  for (int k = 0; k < tours_->moves.count; ++k)
    step[k] = std::int64_t{tours_->moves[k].to.dy} * width_ + tours_->moves[k].to.dx;
  return step;
}

IterationTours NumberedTours::view(const Tours& tours, const Grid& grid, Trail trail) {
  if (lists_ == nullptr || lists_.use_count() > 1) lists_ = std::make_shared<Lists>();
  tours_ = &tours;
  width_ = grid.width();
  start_ = std::int64_t{tours.start.y} * width_ + tours.start.x;
  written_.assign(tours.ants.size() + 1, 0);
  lists_->offsets.assign(1, 0);
  lists_->lengths.clear();
  for (int t = 0; t <= ants(); ++t)
    lists_->offsets.push_back(lists_->offsets.back() + std::ssize(tour(t).moves) + 1);
  for (const Tour& tour : tours.ants) lists_->lengths.push_back(tour.length);
  const auto places = static_cast<std::size_t>(lists_->offsets.back());
  lists_->cells.grow(places);
  if (trail == Trail::arcs) lists_->arcs.grow(places);
  const auto ranked = trail_rules::ranked(tours);
  lists_->ranked.assign(ranked.begin(), ranked.end());
  IterationTours view(*this);
  view.trail = trail;
  view.start = tours.start;
  view.iteration = tours.iteration;
  view.width = grid.width();
  view.height = grid.height();
  view.moves = tours.moves.count;
  view.offsets = std::span(lists_->offsets).first(tours.ants.size() + 1);
  view.lengths = lists_->lengths;
  view.ranked = lists_->ranked;
  view.memory = lists_;
  if (trail_rules::arrived(tours.best_so_far)) view.best_length = tours.best_so_far.length;
  return view;
}

std::span<const TrailPlace> NumberedTours::cells_of(int number) noexcept {
  const auto moves = tour(number).moves;
  TrailPlace* const cells = lists_->cells.data() + lists_->offsets[number];
  if ((written_[number] & kCells) == 0) {
    const auto step = steps();
    cells[0] = start_;
    for (std::size_t i = 0; i < moves.size(); ++i) cells[i + 1] = cells[i] + step[moves[i]];
    written_[number] |= kCells;
  }
  return {cells, moves.size() + 1};
}

std::span<const TrailPlace> NumberedTours::arcs_of(int number) noexcept {
  const auto moves = tour(number).moves;
  TrailPlace* const arcs = lists_->arcs.data() + lists_->offsets[number] - number;
  if ((written_[number] & kArcs) == 0) {
    const auto step = steps();
    TrailPlace cell = start_;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      arcs[i] = cell * tours_->moves.count + moves[i];
      cell += step[moves[i]];
    }
    written_[number] |= kArcs;
  }
  return {arcs, moves.size()};
}

std::span<const TrailPlace> NumberedTours::cells() noexcept {
  for (int ant = 0; ant < ants(); ++ant) cells_of(ant);
  return {lists_->cells.data(), static_cast<std::size_t>(lists_->offsets[ants()])};
}

std::span<const TrailPlace> NumberedTours::arcs() noexcept {
  for (int ant = 0; ant < ants(); ++ant) arcs_of(ant);
  return {lists_->arcs.data(), static_cast<std::size_t>(lists_->offsets[ants()] - ants())};
}

}  // namespace lasius
