#include "core/colony/colony.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/base/kernel_choice.h"
#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/colony/polish.h"
#include "core/colony/update.h"
#include "core/colony/walk_setup.h"
#include "core/grid/cell_distance.h"
#include "core/grid/move_rule.h"
#include "core/loop/colony_loop.h"
#include "core/loop/run_status.h"
#include "core/params/schedule.h"

namespace lasius {
namespace {

using MoveCounts = std::array<std::int64_t, kernels::kMaxMoves>;

/// Length of a tour. Moves are counted by kind, so that the sum does not depend on their order.
double length_of(MoveCounts count, const kernels::Moves& moves) {
  // Moves of one length, met first to last, make one product.
  double length = 0;
  for (int k = 0; k < moves.count; ++k) {
    std::int64_t alike = 0;
    for (int j = moves.count - 1; j >= k; --j) {
      if (moves[j].length != moves[k].length) continue;
      alike += count[j];
      count[j] = 0;
    }
    length += static_cast<double>(alike) * moves[k].length;
  }
  return length;
}

double length_of(std::span<const std::uint8_t> tour, const kernels::Moves& moves) {
  MoveCounts count{};
  for (const int k : tour) ++count[k];
  return length_of(count, moves);
}

/// The band within a tenth of the distance from start to goal of the straight line between them.
class Band {
 public:
  Band(Cell start, Cell goal, const kernels::Moves& moves) {
    const std::int64_t dx = goal.x - start.x, dy = goal.y - start.y;
    most_ = dx * dx + dy * dy;
    for (int k = 0; k < moves.count; ++k)
      aside_[k] = 10 * (moves[k].to.dx * dy - moves[k].to.dy * dx);
  }
  /// Cells of a tour from the start that lie within; counts its moves by kind, too.
  std::int64_t count(std::span<const std::uint8_t> tour, MoveCounts& count) const {
    std::int64_t off = 0, near = 1;
    for (const int k : tour) {
      ++count[k];
      off += aside_[k];
      near += off <= most_ && -off <= most_;
    }
    return near;
  }

 private:
  std::int64_t most_;
  std::array<std::int64_t, kernels::kMaxMoves> aside_{};  // ten times, by move
};

/// A colony on a bitmap.
class GridColony final : public ColonyWorld {
 public:
  GridColony(const Grid& grid, const Request& request, const Params& params, ColonyMemory& memory,
             const Observer& observer)
      : grid_(grid),
        request_(request),
        params_(params),
        memory_(memory),
        observer_(observer),
        threads_(thread_count(params.threads)),
        moves_(moves_of(params.neighbours)),
        band_(request.start, request.goal, moves_),
        tau0_(initial_pheromone(params, distance(request.start, request.goal))) {
    memory_.field.reset(grid, moves_, request.goal, params, untouched(), request.stop);
    memory_.walkers.reset(grid.width(), grid.height(), threads_, params.ants,
                          params.polish == Polish::straight || params.polish == Polish::taut ||
                              params.walk_cut == WalkCut::entered_cells,
                          request.stop);
    memory_.polisher.reset(grid_, request_, moves_, params_, threads_);
    const auto ants = static_cast<std::size_t>(params.ants);
    if (memory_.ants.size() < ants) memory_.ants.resize(ants);  // to free some may take long
    ants_ = std::span(memory_.ants).first(ants);
    memory_.tours.resize(ants);
    memory_.raw_lengths.resize(ants);
    if (params.walk_cut != WalkCut::none && std::ssize(memory_.cutters) < threads_)
      memory_.cutters.resize(threads_);
    memory_.best_moves.clear();
    shape_ = walk_shape(params, moves_, memory_.field.mixture());
    kernel_ = kernels::walk_table(chosen_isa()).walk[shape_.index()];
    world_ = walk_world(params, moves_, request.start, request.goal);
  }

  Result run() {
    Convergence run;
    const auto cause = run_colony_loop(*this, params_.iterations, request_.stop, run);
    return result_after(cause, std::move(run), std::move(best_path_));
  }

  // What the loop asks for.

  /// Sends all ants, batch by batch, and measures their tours.
  StopCondition::Cause send_ants(int q) override {
    iteration_ = q;
    iteration_best_ = kNaN;
    all_walked_ = false;
    const StepWeights weights = schedule(params_, q);
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
      const auto cause =
          memory_.walkers.walk(world_, kernel_, ants, first, request_.stop, after_walk(first));
      if (cause != StopCondition::Cause::none) return cause;
      note_best(first, count);
      update_locally(memory_.field, params_, tau0_, tours(first, count), request_.stop);
    }
    all_walked_ = true;
    return StopCondition::Cause::none;
  }

  /// One thread lays the walks' trails meanwhile: they have nothing to do with the polish.
  void offer() override {
    if (ants_only_teach() && all_walked_) return;
    offer(ants_, memory_.tours, [this] {
      if (all_walked_) lay_trails();
    });
  }

  void update(int) override {
    if (ants_only_teach()) {
      lay_trails();
      const Ant& ant = answer();
      if (!ant.arrived) return offer(ants_, memory_.tours, {});  // no way is known, or no time left
      const Tour tour = tour_of(ant);
      offer({&ant, 1}, {&tour, 1}, {});
    } else {
      lay_straight_trails();
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
  double best_length() const override { return best_length_ < kInfinity ? best_length_ : kNaN; }
  double iteration_best() const override { return iteration_best_; }
  bool settled() const override { return params_.agreement > 0 && agreed_ >= params_.agreement; }

  double trail_entropy() const override {
    if (ants_only_teach()) return kNaN;
    return lasius::trail_entropy(memory_.field, params_.trail, moves_, request_.start,
                                 memory_.best_moves);
  }

  StopCondition::Cause observe(const Convergence& run) override {
    return show(observer_, run, View(*this));
  }

 private:
  /// What an observer sees.
  class View final : public GridProgress {
   public:
    explicit View(const GridColony& colony) : colony_(colony) {}
    std::vector<Point> path() const override { return colony_.best_path_; }
    int ants() const override { return colony_.ants(); }
    std::vector<Cell> tour(int ant) const override {
      return walked(ant).arrived ? walk(ant) : std::vector<Cell>{};
    }
    std::vector<Cell> walk(int ant) const override {
      std::vector<Cell> cells;
      along_tour(walked(ant).tour(), colony_.moves_, colony_.request_.start,
                 [&](Cell c) { cells.push_back(c); });
      return cells;
    }
    double pheromone(Cell c) const override { return colony_.memory_.field.pheromone(c); }

   private:
    const Ant& walked(int ant) const {
      if (ant < 0 || ant >= ants()) throw std::out_of_range("there is no such ant");
      return colony_.ants_[ant];
    }
    const GridColony& colony_;
  };

  /// tau where no ant has been; the terminal index of unknown cells grows with the map.
  double untouched() const {
    if (params_.update != Update::terminal_index) return tau0_;
    return params_.unknown_index * std::max(grid_.width(), grid_.height()) / 20;
  }

  Tour tour_of(const Ant& ant) const {
    return {ant.tour(), ant.arrived ? length_of(ant.tour(), moves_) : kNaN};
  }

  /// The tour of an ant that has just ended, measured and cut; none where there was no time to.
  Tour measured(int number, int thread) {
    Ant& ant = ants_[number];
    Tour tour{ant.tour(), kNaN};
    ant.near = 0;
    if (ant.arrived) {
      MoveCounts count{};
      ant.near = band_.count(tour.moves, count);
      tour.length = length_of(count, moves_);
    }
    memory_.raw_lengths[number] = tour.length;
    ant.cut_count = -1;
    if (params_.walk_cut == WalkCut::none || !ant.arrived) return tour;
    const bool entered = params_.walk_cut == WalkCut::entered_cells;
    const auto more = entered ? ant.dead_ends() : std::span<const kernels::PackedCell>{};
    ant.cut_count = memory_.cutters[thread].cut(grid_, params_.corners, moves_, request_.start,
                                                tour.moves, more, request_.stop, ant.cut);
    if (ant.cut_count < 0) return tour;
    return {ant.left(), length_of(ant.left(), moves_)};
  }

  /// Tours are measured as ants end, and polished while others still walk: by a thread that has no
  /// ant left, or at once as long as there is no answer.
  AfterWalk after_walk(int first) {
    AfterWalk work;
    const bool at_once = best_length_ == kInfinity && !ants_only_teach();
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

  void note_best(int first, int count) {
    const Tour* best = nullptr;
    for (const Tour& tour : std::span(memory_.tours).subspan(first, count)) {
      if (!(tour.length < best_tour_length_)) continue;
      best = &tour;
      best_tour_length_ = tour.length;
    }
    if (best != nullptr) memory_.best_moves.assign(best->moves.begin(), best->moves.end());
  }

  Tours tours(int first, int count) const {
    return {
        .start = request_.start,
        .moves = moves_,
        .ants = std::span(memory_.tours).subspan(first, count),
        .best_so_far = {memory_.best_moves, memory_.best_moves.empty() ? kNaN : best_tour_length_},
        .iteration = iteration_,
        .rows = grid_.height(),
        .ranking = memory_.ranking};
  }

  void lay_trails() { update_trail(memory_.field, params_, tours(0, params_.ants), request_.stop); }

  /// Did two ants or more arrive, all by one way?
  bool all_agree() const {
    const auto& tours = memory_.tours;
    return params_.ants > 1 && std::ranges::all_of(tours, [&](const Tour& tour) {
             return tour.length > 0 && std::ranges::equal(tour.moves, tours[0].moves);
           });
  }

  /// The answer of the terminal index is read from what its ants taught it, where there is time.
  bool ants_only_teach() const { return params_.update == Update::terminal_index; }

  /// The generation's answer as one more ant.
  const Ant& answer() {
    Ant& ant = memory_.answer;
    best_known_way(memory_.field, moves_, request_.start, request_.goal, params_.index_answer,
                   request_.stop, memory_.way);
    ant.moves.grow(memory_.way.size());
    std::copy(memory_.way.begin(), memory_.way.end(), ant.moves.data());
    ant.move_count = static_cast<std::int64_t>(memory_.way.size());
    ant.arrived = !memory_.way.empty();
    return ant;
  }

  /// Polishes the tours and offers every path as the best one, ties to the lower index. Of tours
  /// that are not polished, by choice or for lack of time, the shortest is offered.
  void offer(std::span<const Ant> ants, std::span<const Tour> tours,
             const std::function<void()>& meanwhile) {
    memory_.polisher.polish(ants, meanwhile);
    const auto paths = memory_.polisher.paths();
    improving_ant_ = -1;
    int left = -1;
    double shortest = best_length_;
    for (int a = 0; a < static_cast<int>(ants.size()); ++a) {
      iteration_best_ = std::fmin(iteration_best_,
                                  std::isnan(paths[a].length) ? tours[a].length : paths[a].length);
      if (paths[a].length < best_length_) {
        improving_ant_ = a;
        best_length_ = paths[a].length;
      } else if (std::isnan(paths[a].length) && tours[a].length < shortest) {
        left = a;
        shortest = tours[a].length;
      }
    }
    if (improving_ant_ >= 0) best_path_ = paths[improving_ant_].points;
    if (!(shortest < best_length_)) return;
    auto path = as_walked(tours[left]);
    const double length = path_length(path);
    if (!(length < best_length_)) return;  // by rounding it was
    improving_ant_ = left;
    best_length_ = length;
    best_path_ = std::move(path);
  }

  std::vector<Point> as_walked(const Tour& tour) const {
    std::vector<Point> path;
    path.reserve(tour.moves.size() + 1);
    along_tour(tour.moves, moves_, request_.start, [&](Cell c) { path.push_back(centre(c)); });
    return path;
  }

  /// Q / L on the cells under straightened paths (Fan et al. 2004, step 3).
  void lay_straight_trails() {
    if (params_.straight_deposit == StraightDeposit::none) return;
    constexpr int kStepsADeposit = 8;  // some make a tile
    Poller poller(request_.stop, Poller::kSteps);
    for (int a = 0; a < params_.ants; ++a) {
      if (!ants_[a].arrived) continue;
      if (params_.straight_deposit == StraightDeposit::improving && a != improving_ant_) continue;
      const PolishedPath& path = memory_.polisher.paths()[a];
      for (const Cell c : path.raster) {
        if (poller.stop_after(kStepsADeposit)) return;
        memory_.field.deposit(c, 0, params_.deposit / path.length);
      }
    }
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  const Grid& grid_;
  const Request& request_;
  const Params& params_;
  ColonyMemory& memory_;
  std::span<Ant> ants_;
  const Observer& observer_;
  int threads_;
  kernels::Moves moves_;
  Band band_;
  double tau0_;
  kernels::WalkShape shape_;
  kernels::WalkFn kernel_ = nullptr;
  kernels::WalkWorld world_;

  int iteration_ = 0;
  bool all_walked_ = false;
  double iteration_best_ = kNaN;
  int agreed_ = 0;  // iterations in a row in which all ants took one way
  double best_tour_length_ = kInfinity;
  double best_length_ = kInfinity;  // the best path so far, polished
  std::vector<Point> best_path_;
  int improving_ant_ = -1;  // who found it, if in this iteration
};

}  // namespace

Result run_colony(const Grid& grid, const Request& request, const Params& params,
                  ColonyMemory& memory, const Observer& observer) {
  return GridColony(grid, request, params, memory, observer).run();
}

}  // namespace lasius
