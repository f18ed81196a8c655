// The world of a colony on a bitmap, as the loop sees it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "core/base/kernel_choice.h"
#include "core/base/parallel.h"
#include "core/base/special_values.h"
#include "core/colony/best_path.h"
#include "core/colony/colony_memory.h"
#include "core/colony/colony_view.h"
#include "core/colony/own_update.h"
#include "core/colony/terminal_index.h"
#include "core/colony/tour_measures.h"
#include "core/colony/update.h"
#include "core/colony/walk_setup.h"
#include "core/grid/cell_distance.h"
#include "core/grid/move_rule.h"
#include "core/loop/colony_loop.h"
#include "core/loop/run_status.h"
#include "lasius/own_rules.h"
#include "lasius/path.h"
#include "lasius/progress.h"
#include "lasius/request.h"
#include "lasius/schedule.h"

namespace lasius {

/// A colony on a bitmap. Its grid and its start may change between runs.
class GridColony final : public ColonyWorld {
 public:
  /// What comes after a run: another one goes on with the trail, or nothing reads it again.
  enum class After { nothing, more_runs };

  /// `own`, checked, may take the place of some rules; disc and terrain as of run_colony(). All
  /// outlive the object. `first_ant` picks the first ant's random numbers, those after it follow.
  GridColony(const Grid& grid, const Params& params, ColonyMemory& memory, const OwnRules& own,
             After after, const disc::DiscSpace* disc, const cost::Terrain* terrain = nullptr,
             int first_ant = 0)
      : grid_(grid),
        params_(params),
        own_(own),
        memory_(memory),
        after_(after),
        disc_(disc),
        first_ant_(first_ant),
        threads_(thread_count(params.threads)),
        moves_(moves_of(params.neighbours, disc != nullptr)),
        measure_(moves_, terrain) {
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

  /// Makes the trail blank for questions like this one; its stop condition may leave it in pieces.
  void begin(const Request& request) {
    request_ = request;
    tau0_ = initial_pheromone(params_, measure_.least(distance(request.start, request.goal)));
    memory_.field.reset(grid_, moves_, request.goal, params_, untouched(), request.stop,
                        own_.heuristic, measure_.terrain());
    shape_ = walk_shape(params_, moves_, memory_.field.mixture());
    kernel_ = kernels::walk_table(chosen_isa()).walk[shape_.index()];
    trail_level_ = first_iteration_ = agreed_ = 0;
    memory_.best.drop();
    best_path_.drop();
    cut_path_.drop();
  }

  /// Gets ready for a run. A best tour that passes the new start goes on from there.
  void set_out(const Request& request, const Observer& observer) {
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
    const Ant& rest = as_ant(memory_.best.moves());
    memory_.polisher.polish({&rest, 1}, request.stop, {});
    const bool whole = request.stop.poll() == StopCondition::Cause::none;
    offer_answer(whole ? best_path_ : cut_path_);
  }

  /// Goes on from `request.start`, with the trail as it is.
  Result run(const Request& request, int iterations, const Observer& observer) {
    set_out(request, observer);
    Convergence run;
    const auto cause = run_colony_loop(*this, iterations, request_.stop, run);
    constexpr int kMany = 1 << 30;  // schedules have long ended
    if (first_iteration_ < kMany) first_iteration_ += run.iterations;
    return result_after(cause, std::move(run),
                        after_ == After::nothing ? best_path().give() : best_path().points());
  }

  /// The best path so far, of an iteration that was cut short too.
  BestPath& best_path() noexcept {
    return cut_path_.shorter_than(best_path_) ? cut_path_ : best_path_;
  }
  /// The best of ants and guests; holds until the next iteration.
  Tour best_tour() const noexcept { return memory_.best.tour(); }
  /// Another colony's tour: in the next iteration the trail learns by it as by one more ant.
  void welcome(const Tour& tour) { memory_.guest.offer({&tour, 1}); }

  /// Fits what is remembered to cells that have changed.
  void changed(const Rectangle& part) {
    memory_.field.edited(part);
    if (ants_only_teach()) {
      forget_lost_ways(memory_.field, grid_, params_.corners, moves_, request_.goal, part);
    } else if (memory_.best.passed_by(grid_, request_.start, request_.goal, part)) {
      reopen(part);
    }
    agreed_ = 0;
    BestTour& best = memory_.best;
    if (!best.walkable(grid_, params_.corners, moves_, request_.start)) best.drop();
    for (BestPath* path : {&best_path_, &cut_path_}) {
      if (!holds(path->points())) path->drop();
    }
  }

  // What the loop asks for.

  /// Sends all ants, batch by batch, measures their tours and polishes them. Where nothing reads
  /// the trail after a cut, one thread lays the walks' trails meanwhile: they have nothing to do
  /// with the polish.
  StopCondition::Cause send_ants(int q) override {
    q += first_iteration_;
    iteration_ = q;
    best_path_.begin_iteration();
    learned_ = false;
    // A path that is a little longer for a point may be the shorter one for a disc; over a terrain
    // a dearer one the cheaper once it is polished.
    const double room = measure_.terrain() != nullptr ? 1.25 : 1.002;
    memory_.polisher.want_below(best_path_.of_point() * room);
    memory_.earlier.clear();
    auto cause = walk(q);
    // Where time ran out as the last ant was measured, its tour may not be cut.
    if (cause == StopCondition::Cause::none) cause = request_.stop.poll();
    const bool whole = cause == StopCondition::Cause::none;
    if (!whole || !ants_only_teach()) {
      const bool meanwhile = whole && after_ == After::nothing && !own_.update;
      memory_.polisher.polish(ants_, request_.stop, [this, meanwhile] {
        if (meanwhile) learn_from_walks();
      });
      if (whole) cause = request_.stop.poll();
    }
    if (cause != StopCondition::Cause::none) take_back(memory_.field, memory_.earlier);
    return cause;
  }

  void offer() override {
    if (!ants_only_teach()) offer(best_path_, memory_.tours);
  }
  void offer_cut() override { offer(cut_path_, memory_.tours); }

  void update_trail(int) override {
    if (!learned_) learn_from_walks();
    if (ants_only_teach()) {
      offer_what_is_known();
    } else {
      if (own_.update)  // on the caller's thread
        own_stop_ = update_by_caller(memory_.field, own_, params_, grid_, request_.goal,
                                     tours(0, params_.ants), memory_.numbered);
      lay_straight_paths(memory_.field, params_, ants_, memory_.polisher.paths(),
                         best_path_.finder());
    }
    agreed_ = all_agree() ? agreed_ + 1 : 0;
  }

  int ants() const override { return params_.ants; }
  int threads() const override { return threads_; }
  double tour_length(int ant) const override { return memory_.raw_lengths[ant]; }
  std::optional<Walked> walked(int ant) const override {
    const Ant& one = ants_[ant];
    return Walked{memory_.tours[ant].length, one.steps, one.arrived ? one.move_count + 1 : 0,
                  one.near};
  }
  double best_length() const override { return best_path_.length(); }
  double iteration_best() const override { return best_path_.iteration_best(); }
  bool settled() const override { return params_.agreement > 0 && agreed_ >= params_.agreement; }

  double trail_entropy() const override {
    if (ants_only_teach()) return kNaN;
    return lasius::trail_entropy(memory_.field, params_.trail, moves_, request_.start,
                                 memory_.best.moves());
  }

  StopCondition::Cause observe(const Convergence& run) override {
    ColonyView view(best_path_, ants_, moves_, request_.start, memory_.field);
    view.iteration = first_iteration_;
    const auto cause = show(*observer_, run, view);
    return own_stop_ ? StopCondition::Cause::token : cause;
  }

 private:
  bool holds(std::span<const Point> path) const {
    if (disc_ == nullptr) return !path_fault(grid_, path, params_.corners);
    return !path.empty() && disc_->clear(path[0]) && disc_->reaches_along(path);
  }

  /// Lets ants leave the trail beside an opening: it becomes more alike there, and the best tour
  /// renews it no longer.
  void reopen(const Rectangle& part) {
    constexpr double kShare = 0.3;  // see docs/theory.md
    if (!memory_.best.none())
      trail_level_ = memory_.best.strongest(memory_.field, moves_, request_.start);
    if (trail_level_ > 0)
      memory_.field.equalise(part, std::max(part.width, part.height), kShare, trail_level_);
    memory_.best.drop();
  }

  /// tau where no ant has been; the terminal index of unknown cells grows with the map.
  double untouched() const {
    if (params_.update != Update::terminal_index) return tau0_;
    return params_.unknown_index * std::max(grid_.width(), grid_.height()) / 20;
  }

  /// Sends all ants of iteration q, batch by batch, and measures their tours.
  StopCondition::Cause walk(int q) {
    const StepWeights weights =
        own_.schedule ? own_weights(own_, params_, q) : schedule(params_, q);
    set_iteration(world_, params_, moves_, shape_, weights, q);
    for (Ant& ant : ants_) ant.arrived = false;
    for (Tour& tour : memory_.tours) tour = {{}, kNaN};
    std::ranges::fill(memory_.raw_lengths, kNaN);
    const int batch = params_.batch > 0 ? params_.batch : params_.ants;
    for (int first = 0; first < params_.ants; first += batch) {
      const int count = std::min(batch, params_.ants - first);
      const auto ants = ants_.subspan(first, count);
      memory_.field.refresh(weights, threads_);
      memory_.field.fill(world_);
      const auto cause = memory_.walkers.walk(world_, kernel_, ants, first_ant_ + first,
                                              request_.stop, after_walk(first));
      if (cause != StopCondition::Cause::none) return cause;
      update_locally(memory_.field, params_, tau0_, tours(first, count),
                     after_ == After::more_runs ? &memory_.earlier : nullptr);
    }
    return StopCondition::Cause::none;
  }

  /// The tour of an ant that has just ended, measured and cut; none where there was no time to.
  Tour measured(int number, int thread) {
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

  /// Tours are measured as ants end, and polished while others still walk: by a thread that has no
  /// ant left, or at once as long as there is no answer.
  AfterWalk after_walk(int first) {
    AfterWalk work;
    const bool at_once = std::isnan(best_path_.length()) && !ants_only_teach();
    work.ended = [this, first, at_once](int ant, int thread) {
      memory_.tours[first + ant] = measured(first + ant, thread);
      if (at_once) memory_.polisher.polish_ahead(ants_, first + ant, thread);
    };
    if (!ants_only_teach()) {
      work.spare = [this, first](int ant, int thread) {
        memory_.polisher.polish_ahead(ants_, first + ant, thread);
      };
    }
    return work;
  }

  Tours tours(int first, int count) const {
    return {.start = request_.start,
            .moves = moves_,
            .ants = std::span(memory_.tours).subspan(first, count),
            .best_so_far = memory_.best.tour(),
            .iteration = iteration_,
            .rows = grid_.height(),
            .ranking = memory_.ranking};
  }

  /// The best tour, and the paper's update, which a caller's own takes the place of.
  void learn_from_walks() {
    if (!memory_.guest.none()) memory_.tours.push_back(memory_.guest.tour());
    memory_.best.offer(memory_.tours);
    if (!own_.update)
      lasius::update_trail(memory_.field, params_,
                           tours(0, static_cast<int>(memory_.tours.size())));
    memory_.tours.resize(ants_.size());
    memory_.guest.drop();
    learned_ = true;
  }

  /// Did two ants or more arrive, all by one way?
  bool all_agree() const {
    const auto& tours = memory_.tours;
    return params_.ants > 1 && std::ranges::all_of(tours, [&](const Tour& tour) {
             return tour.length > 0 && std::ranges::equal(tour.moves, tours[0].moves);
           });
  }

  /// The answer of the terminal index is read from what its ants taught it.
  bool ants_only_teach() const { return params_.update == Update::terminal_index; }

  /// A way that no ant of this iteration has gone, as one more ant.
  const Ant& as_ant(std::span<const std::uint8_t> way) {
    Ant& ant = memory_.answer;
    ant.moves.grow(way.size());
    std::ranges::copy(way, ant.moves.data());
    ant.move_count = std::ssize(way);
    ant.arrived = !way.empty();
    return ant;
  }

  /// Offers what the terminal index knows by now, or where it knows no way what the ants found.
  /// Nothing is polled: the trail has changed.
  void offer_what_is_known() {
    best_known_way(memory_.field, moves_, request_.start, request_.goal, params_.index_answer,
                   memory_.way);
    const Ant& way = as_ant(memory_.way);
    memory_.polisher.polish(way.arrived ? std::span(&way, 1) : ants_, {}, {});
    if (way.arrived) return offer_answer(best_path_);
    offer(best_path_, memory_.tours);
  }

  /// Offers the way of `memory_.answer`, once it is polished.
  void offer_answer(BestPath& to) const {
    const Tour tour{memory_.answer.tour(), measure_.of(memory_.answer.tour(), request_.start)};
    offer(to, {&tour, 1});
  }
  /// Offers tours that are polished.
  void offer(BestPath& to, std::span<const Tour> tours) const {
    to.offer(memory_.polisher.paths(), tours, moves_, request_.start, measure_);
  }

  const Grid& grid_;
  Request request_;
  const Params& params_;
  const OwnRules& own_;
  ColonyMemory& memory_;
  After after_;
  const disc::DiscSpace* disc_;
  int first_ant_;
  std::span<Ant> ants_;
  const Observer* observer_ = nullptr;
  int threads_;
  kernels::Moves moves_;
  TourMeasure measure_;
  Band band_;
  double tau0_ = 0;
  kernels::WalkShape shape_;
  kernels::WalkFn kernel_ = nullptr;
  kernels::WalkWorld world_;

  int first_iteration_ = 0;  // of this run
  int iteration_ = 0;
  bool learned_ = false;    // from this iteration's walks
  bool own_stop_ = false;   // the caller's update asks for the end
  int agreed_ = 0;          // iterations in a row in which all ants took one way
  double trail_level_ = 0;  // most tau on the best tour when it was last needed
  BestPath best_path_;      // of whole iterations so far, polished
  BestPath cut_path_;       // of those that were cut short
};

}  // namespace lasius
