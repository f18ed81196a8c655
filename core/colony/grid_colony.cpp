#include "core/colony/grid_colony.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/kernel_choice.h"
#include "core/base/parallel.h"
#include "core/base/special_values.h"
#include "core/colony/colony_view.h"
#include "core/colony/terminal_index.h"
#include "core/colony/walk_setup.h"
#include "core/grid/move_rule.h"
#include "core/loop/run_status.h"
#include "lasius/path/path.h"

namespace lasius {

GridColony::GridColony(const Grid& grid, const Params& params, ColonyMemory& memory,
                       const OwnRules& own, After after, const disc::DiscSpace* disc,
                       const cost::Terrain* terrain, int first_ant)
    : grid_(grid),
      params_(params),
      memory_(memory),
      disc_(disc),
      after_(after),
      first_ant_(first_ant),
      threads_(thread_count(params.threads)),
      moves_(moves_of(params.neighbours, disc != nullptr)),
      measure_(moves_, terrain),
      trail_(grid, params, own, after == After::more_runs, moves_, memory) {
  const auto ants = static_cast<std::size_t>(params.ants);
  if (memory_.ants.size() < ants) memory_.ants.resize(ants);  // to free some may take long
  ants_ = std::span(memory_.ants).first(ants);
  memory_.tours.reserve(ants + 1);  // and a guest
  memory_.tours.resize(ants);
  memory_.guest.drop();
  memory_.raw_lengths.resize(ants);
  if (params.walk_cut != WalkCut::none && std::ssize(memory_.cutters) < threads_)
    memory_.cutters.resize(threads_);
}

void GridColony::begin(const Request& request) {
  request_ = request;
  trail_.begin(request, measure_);
  shape_ = walk_shape(params_, moves_, memory_.field.mixture());
  kernel_ = kernels::walk_table(chosen_isa()).walk[shape_.index()];
  first_iteration_ = agreed_ = 0;
  memory_.best.drop();
  best_path_.drop();
  cut_path_.drop();
}

void GridColony::set_out(const Request& request, const Observer& observer) {
  if (request.start != request_.start) {
    memory_.best.go_on_from(request_.start, request.start, moves_, measure_);
    best_path_.drop();
    cut_path_.drop();
  }
  request_ = request;
  observer_ = &observer;
  band_ = Band(request.start, request.goal, moves_);
  world_ = walk_world(params_, moves_, request.start, request.goal);
  memory_.walkers.reset(grid_.width(), grid_.height(), threads_, params_.ants,
                        params_.polish == Polish::straight || params_.polish == Polish::taut ||
                            params_.walk_cut == WalkCut::entered_cells,
                        request_.stop);
  memory_.polisher.reset(grid_, request_, moves_, params_, threads_, disc_, measure_);
  if (!best_path_.none() || memory_.best.none()) return;
  offer_way(memory_.best.moves(), request.stop);
}

Result GridColony::run(const Request& request, int iterations, const Observer& observer) {
  set_out(request, observer);
  Convergence run;
  const auto cause = run_colony_loop(*this, iterations, request_.stop, run);
  constexpr int kMany = 1 << 30;  // schedules have long ended
  if (first_iteration_ < kMany) first_iteration_ += run.iterations;
  return result_after(cause, std::move(run),
                      after_ == After::nothing ? best_path().give() : best_path().points());
}

void GridColony::changed(const Rectangle& part) {
  trail_.changed(part, request_.start);
  agreed_ = 0;
  BestTour& best = memory_.best;
  if (!best.walkable(grid_, params_.corners, moves_, request_.start)) best.drop();
  const auto holds = [this](const std::vector<Point>& path) {
    if (disc_ == nullptr) return !path_fault(grid_, path, params_.corners);
    return !path.empty() && disc_->clear(path[0]) && disc_->reaches_along(path);
  };
  for (BestPath* path : {&best_path_, &cut_path_})
    if (!holds(path->points())) path->drop();
}

StopCondition::Cause GridColony::send_ants(int q) {
  iteration_ = first_iteration_ + q;
  best_path_.begin_iteration();
  learned_ = false;
  // A path that is a little longer for a point may be the shorter one for a disc; over a terrain
  // a dearer one the cheaper once it is polished.
  const double room = measure_.terrain() != nullptr ? 1.25 : 1.002;
  memory_.polisher.want_below(best_path_.of_point() * room);
  auto cause = walk();
  // Where time ran out as the last ant was measured, its tour may not be cut.
  if (cause == StopCondition::Cause::none) cause = request_.stop.poll();
  const bool whole = cause == StopCondition::Cause::none;
  if (!whole || !trail_.answers()) {
    memory_.polisher.polish(ants_, request_.stop, [this, aside = whole && trail_.learns_aside()] {
      if (aside) learn_from_walks();
    });
    if (whole) cause = request_.stop.poll();
  }
  if (cause != StopCondition::Cause::none) trail_.take_back();
  return cause;
}

void GridColony::update_trail(int) {
  if (!learned_) learn_from_walks();
  if (trail_.answers())
    offer_what_is_known();
  else
    trail_.learn_from_paths(tours(0, params_.ants), ants_, memory_.polisher.paths(),
                            best_path_.finder());
  // Did two ants or more arrive, all by one way?
  const auto& all = memory_.tours;
  const bool agree = params_.ants > 1 && std::ranges::all_of(all, [&](const Tour& tour) {
                       return tour.length > 0 && std::ranges::equal(tour.moves, all[0].moves);
                     });
  agreed_ = agree ? agreed_ + 1 : 0;
}

StopCondition::Cause GridColony::observe(const Convergence& run) {
  ColonyView view(best_path_, ants_, moves_, request_.start, memory_.field);
  view.iteration = first_iteration_;
  const auto cause = show(*observer_, run, view);
  return trail_.stopped() ? StopCondition::Cause::token : cause;
}

// Sends all ants, batch by batch, and measures their tours.
StopCondition::Cause GridColony::walk() {
  const StepWeights weights = trail_.begin_iteration(iteration_);
  set_iteration(world_, params_, moves_, shape_, weights, iteration_);
  for (Ant& ant : ants_) ant.arrived = false;
  for (Tour& tour : memory_.tours) tour = {{}, kNaN};
  std::ranges::fill(memory_.raw_lengths, kNaN);
  const int batch = params_.batch > 0 ? params_.batch : params_.ants;
  for (int first = 0; first < params_.ants; first += batch) {
    const int count = std::min(batch, params_.ants - first);
    memory_.field.refresh(weights, threads_);
    memory_.field.fill(world_);
    const auto cause = memory_.walkers.walk(world_, kernel_, ants_.subspan(first, count),
                                            first_ant_ + first, request_.stop, after_walk(first));
    if (cause != StopCondition::Cause::none) return cause;
    trail_.pass(tours(first, count));
  }
  return StopCondition::Cause::none;
}

// Tours are measured as ants end, and polished while others still walk: by a thread that has no
// ant left, or at once as long as there is no answer.
AfterWalk GridColony::after_walk(int first) {
  AfterWalk work;
  const bool at_once = std::isnan(best_path_.length()) && !trail_.answers();
  work.ended = [this, first, at_once](int ant, int thread) {
    memory_.tours[first + ant] = measured(first + ant, thread);
    if (at_once) memory_.polisher.polish_ahead(ants_, first + ant, thread);
  };
  if (trail_.answers()) return work;
  work.spare = [this, first](int ant, int thread) {
    memory_.polisher.polish_ahead(ants_, first + ant, thread);
  };
  return work;
}

// The tour of an ant that has just ended, measured and cut; none where there was no time to.
Tour GridColony::measured(int number, int thread) {
  Ant& ant = ants_[number];
  Tour tour{ant.tour(), kNaN};
  ant.near = 0;
  if (ant.arrived) {
    MoveCounts count{};
    ant.near = band_.count(tour.moves, count);
    tour.length = measure_.of(tour.moves, request_.start, count);
  }
  memory_.raw_lengths[number] = tour.length;
  ant.cut_count = -1;
  if (params_.walk_cut == WalkCut::none || !ant.arrived) return tour;
  const bool entered = params_.walk_cut == WalkCut::entered_cells;
  const auto more = entered ? ant.dead_ends() : std::span<const kernels::PackedCell>{};
  ant.cut_count = memory_.cutters[thread].cut(grid_, params_.corners, moves_, request_.start,
                                              tour.moves, more, request_.stop, ant.cut);
  if (ant.cut_count < 0) return tour;
  return {ant.left(), measure_.of(ant.left(), request_.start)};
}

Tours GridColony::tours(int first, int count) const {
  return {.start = request_.start,
          .moves = moves_,
          .ants = std::span(memory_.tours).subspan(first, count),
          .best_so_far = memory_.best.tour(),
          .iteration = iteration_,
          .rows = grid_.height(),
          .ranking = memory_.ranking};
}

// The best tour, and the trail by the walks: a guest's, too.
void GridColony::learn_from_walks() {
  if (!memory_.guest.none()) memory_.tours.push_back(memory_.guest.tour());
  memory_.best.offer(memory_.tours);
  trail_.learn(tours(0, static_cast<int>(memory_.tours.size())));
  memory_.tours.resize(ants_.size());
  memory_.guest.drop();
  learned_ = true;
}

// Offers what the trail answers by now, or where it knows no way what the ants found. Nothing is
// polled: the trail has changed.
void GridColony::offer_what_is_known() {
  best_known_way(memory_.field, moves_, request_.start, request_.goal, params_.index_answer,
                 memory_.way);
  if (!memory_.way.empty()) return offer_way(memory_.way, {});
  memory_.polisher.polish(ants_, {}, {});
  offer(best_path_, memory_.tours);
}

// Offers a way that no ant of this iteration has gone, as one more ant.
void GridColony::offer_way(std::span<const std::uint8_t> way, const StopCondition& stop) {
  Ant& ant = memory_.answer;
  ant.moves.grow(way.size());
  std::ranges::copy(way, ant.moves.data());
  ant.move_count = std::ssize(way);
  ant.arrived = true;
  memory_.polisher.polish({&ant, 1}, stop, {});
  const Tour tour{ant.tour(), measure_.of(ant.tour(), request_.start)};
  offer(stop.poll() == StopCondition::Cause::none ? best_path_ : cut_path_, {&tour, 1});
}

// Offers tours that are polished.
void GridColony::offer(BestPath& to, std::span<const Tour> tours) const {
  to.offer(memory_.polisher.paths(), tours, moves_, request_.start, measure_);
}

}  // namespace lasius
