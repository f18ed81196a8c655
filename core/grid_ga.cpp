#include "grid_ga.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "grid_ga_route.h"
#include "kernel_choice.h"
#include "kernels/random_stream.h"
#include "lasius/path.h"
#include "loop_cutter.h"
#include "parallel.h"
#include "run_status.h"
#include "straighten.h"
#include "tauten.h"

namespace lasius {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What random words are for, the last place of a counter; 0 belongs to the ants.
enum class Use : std::uint32_t { newcomer = 1, tournament, crossover, mutation };

/// Random words of one use, generation and individual.
class Draws : public kernels::RandomStream {
 public:
  Draws(std::uint64_t seed, Use use, int generation, int individual)
      : RandomStream(seed, static_cast<std::uint32_t>(individual),
                     static_cast<std::uint32_t>(generation), static_cast<std::uint32_t>(use)) {}
};

/// A chromosome with its path after polish.
struct Individual {
  std::vector<Cell> cells;    // the path, start and goal included; empty when stopped
  double tour = kNaN;         // its length
  double length = kInfinity;  // after polish: the fitness, less is fitter
  std::vector<Point> points;
};

/// What one thread works with.
struct Scratch {
  explicit Scratch(const Grid& grid, const RouteMoves& moves) : routes(grid, moves) {}
  RouteMaker routes;
  LoopCutter cutter;
  Straightener straightener;
  Tautener tautener;
  std::vector<Cell> draft;
  std::vector<std::pair<std::uint32_t, int>> places;  // cell and its index in a path
  std::vector<std::pair<int, int>> common;            // indices of a cell in both paths
};

std::uint32_t packed(Cell c) {
  return static_cast<std::uint32_t>(c.y) << 16 | static_cast<std::uint32_t>(c.x);
}

class GridGa final : public Progress {
 public:
  GridGa(const Grid& grid, const Request& request, const Params& params,
         const std::function<bool(Cell)>& joined)
      : grid_(grid),
        request_(request),
        params_(params),
        joined_(joined),
        moves_{params.neighbours == Neighbours::four ? 4 : 8, params.corners},
        threads_(std::clamp(thread_count(params), 1, params.population)) {
    for (int t = 0; t < threads_; ++t) scratch_.push_back(std::make_unique<Scratch>(grid, moves_));
    population_.resize(static_cast<std::size_t>(params.population));
    children_.resize(population_.size());
  }

  Result run(const Observer& observer) {
    auto cause = request_.stop.poll();
    for (int g = 0; g < params_.iterations && cause == StopCondition::Cause::none; ++g) {
      if (g == 0) {
        cause = make(population_, [&](Scratch& s, int i, Poller& p) { newcomer(s, i, p); });
      } else {
        hold_tournaments(g);
        cause = make(children_, [&](Scratch& s, int i, Poller& p) { child(s, g, i, p); });
        if (cause == StopCondition::Cause::none) succeed();
      }
      offer(g == 0 || cause == StopCondition::Cause::none ? population_ : children_);
      if (cause != StopCondition::Cause::none) break;
      record(g);
      if (observer) observer(*this);
    }
    return answer(cause);
  }

  // What an observer sees.
  int ants() const override { return params_.population; }
  std::vector<Cell> tour(int ant) const override { return population_.at(ant).cells; }
  double pheromone(Cell) const override { return 0; }

 private:
  /// Fills `group` over threads; `draft` leaves an individual's cells in the scratch, none when
  /// stopped.
  template <class Draft>
  StopCondition::Cause make(std::vector<Individual>& group, const Draft& draft) {
    parallel_for(static_cast<int>(group.size()), threads_, [&](int i, int thread) {
      Scratch& scratch = *scratch_[thread];
      Poller poller(request_.stop, Poller::kSteps);
      scratch.draft.clear();
      if (request_.stop.poll() == StopCondition::Cause::none) draft(scratch, i, poller);
      finish(scratch, group[i]);
    });
    return request_.stop.poll();
  }

  /// Takes loops out of the draft and polishes it.
  void finish(Scratch& scratch, Individual& made) {
    made.cells.clear();
    made.points.clear();
    made.tour = kNaN;
    made.length = kInfinity;
    if (scratch.draft.empty()) return;
    auto way = scratch.cutter.cut(grid_, scratch.draft, moves_.neighbours > 4, moves_.corners,
                                  request_.stop);
    if (way.empty()) way = scratch.draft;  // stopped
    made.cells.assign(way.begin(), way.end());
    std::span<const Cell> vertices = made.cells;
    for (const Cell c : vertices) made.points.push_back(centre(c));
    made.tour = path_length(made.points);
    if (params_.polish != Polish::none) {
      scratch.straightener.run(grid_, made.cells, request_.stop);
      vertices = scratch.straightener.vertices();
      made.points.clear();
      for (const Cell c : vertices) made.points.push_back(centre(c));
    }
    if (params_.polish == Polish::taut) {
      scratch.tautener.run(grid_, vertices, moves_.corners, request_.stop);
      const auto points = scratch.tautener.path();
      made.points.assign(points.begin(), points.end());
    }
    made.length = path_length(made.points);
  }

  /// From the draft's last cell by way of a drawn cell to the goal; straight to the goal where
  /// draws meet obstacles only. Clears the draft when stopped.
  void go_on(Scratch& scratch, Draws& draws, Poller& poller) {
    constexpr int kTries = 64;
    for (int i = 0; i < kTries; ++i) {
      const Cell via{draws.below(grid_.width()), draws.below(grid_.height())};
      if (grid_.blocked(via) || !joined_(via)) continue;
      scratch.routes.extend(scratch.draft, via, poller);
      break;
    }
    if (!scratch.routes.extend(scratch.draft, request_.goal, poller)) scratch.draft.clear();
  }

  void newcomer(Scratch& scratch, int i, Poller& poller) {
    Draws draws(params_.seed, Use::newcomer, 0, i);
    scratch.draft = {request_.start};
    if (i > 0) return go_on(scratch, draws, poller);
    if (!scratch.routes.extend(scratch.draft, request_.goal, poller)) scratch.draft.clear();
  }

  /// Every individual meets one other, twice over; the winners are the parents.
  void hold_tournaments(int generation) {
    const int count = params_.population;
    Draws draws(params_.seed, Use::tournament, generation, 0);
    parents_.clear();
    std::vector<int> order(static_cast<std::size_t>(count));
    while (static_cast<int>(parents_.size()) < count) {
      for (int i = 0; i < count; ++i) order[i] = i;
      for (int i = count - 1; i > 0; --i) std::swap(order[i], order[draws.below(i + 1)]);
      for (int i = 0; i < count && static_cast<int>(parents_.size()) < count; i += 2) {
        const int a = order[i], b = order[i + 1 < count ? i + 1 : 0];
        parents_.push_back(population_[b].length < population_[a].length ? b : a);
      }
    }
  }

  /// Crosses the parents at a drawn common cell: the draft takes the first part of one and the
  /// second part of the other, its sibling the other way round.
  void cross(Scratch& scratch, const Individual& mother, const Individual& father, bool sibling,
             Draws draws) {
    scratch.places.clear();
    scratch.common.clear();
    const int fathers = static_cast<int>(father.cells.size());
    for (int i = 1; i + 1 < fathers; ++i) scratch.places.emplace_back(packed(father.cells[i]), i);
    std::sort(scratch.places.begin(), scratch.places.end());
    const int mothers = static_cast<int>(mother.cells.size());
    for (int i = 1; i + 1 < mothers; ++i) {
      const std::uint32_t cell = packed(mother.cells[i]);
      const auto at =
          std::lower_bound(scratch.places.begin(), scratch.places.end(), std::pair{cell, 0});
      if (at != scratch.places.end() && at->first == cell)
        scratch.common.emplace_back(i, at->second);
    }
    const Individual& head = sibling ? father : mother;
    const Individual& tail = sibling ? mother : father;
    scratch.draft = head.cells;
    if (scratch.common.empty() || !draws.chance(params_.crossover)) return;
    auto [first, second] = scratch.common[draws.below(static_cast<int>(scratch.common.size()))];
    if (sibling) std::swap(first, second);
    scratch.draft.resize(static_cast<std::size_t>(first));
    scratch.draft.insert(scratch.draft.end(), tail.cells.begin() + second, tail.cells.end());
  }

  void child(Scratch& scratch, int generation, int i, Poller& poller) {
    const auto parent = [&](int p) -> const Individual& {
      return population_[parents_[p < params_.population ? p : 0]];
    };
    const int pair = i / 2;
    cross(scratch, parent(2 * pair), parent(2 * pair + 1), i % 2 == 1,
          Draws(params_.seed, Use::crossover, generation, pair));
    Draws draws(params_.seed, Use::mutation, generation, i);
    if (!draws.chance(params_.mutation)) return;
    const int kept = 1 + draws.below(static_cast<int>(scratch.draft.size()) - 1);
    scratch.draft.resize(static_cast<std::size_t>(kept));
    go_on(scratch, draws, poller);
  }

  /// The children take over; the best one lives on.
  void succeed() {
    const auto fitter = [](const Individual& a, const Individual& b) {
      return a.length < b.length;
    };
    const auto best = std::min_element(population_.begin(), population_.end(), fitter);
    const auto heir = std::min_element(children_.begin(), children_.end(), fitter);
    if (heir->length > best->length)
      *std::max_element(children_.begin(), children_.end(), fitter) = std::move(*best);
    population_.swap(children_);
  }

  void offer(const std::vector<Individual>& group) {
    for (const Individual& one : group) {
      if (!(one.length < best_length_)) continue;
      best_length_ = one.length;
      best_path_ = one.points;
    }
  }

  void record(int generation) {
    double sum = 0;
    for (const Individual& one : population_) sum += one.tour;
    iteration = generation;
    arrived = params_.population;
    mean_length = sum / arrived;
    best_length = best_length_;
    result_.best.push_back(best_length);
    result_.mean.push_back(mean_length);
    result_.arrived.push_back(arrived);
    result_.iterations = generation + 1;
  }

  Result answer(StopCondition::Cause cause) {
    const bool found = best_length_ < kInfinity;
    result_.status = status_after(cause, found ? Status::solved : Status::no_path);
    if (found) {
      result_.path = std::move(best_path_);
      result_.length = path_length(result_.path);
    }
    return std::move(result_);
  }

  const Grid& grid_;
  const Request& request_;
  const Params& params_;
  const std::function<bool(Cell)>& joined_;
  RouteMoves moves_;
  int threads_;
  std::vector<std::unique_ptr<Scratch>> scratch_;
  std::vector<Individual> population_, children_;
  std::vector<int> parents_;

  double best_length_ = kInfinity;
  std::vector<Point> best_path_;
  Result result_;
};

}  // namespace

Result run_grid_ga(const Grid& grid, const Request& request, const Params& params,
                   const std::function<bool(Cell)>& joined, const Observer& observer) {
  return GridGa(grid, request, params, joined).run(observer);
}

}  // namespace lasius
