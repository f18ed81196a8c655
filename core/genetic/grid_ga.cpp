#include "core/genetic/grid_ga.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/loop/colony_loop.h"
#include "core/loop/run_status.h"
#include "kernels/base/random_stream.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

/// What random words are for, the last place of a counter; 0 belongs to the ants.
enum class Use : std::uint32_t { newcomer = 1, tournament, crossover, mutation };

/// Random words of one use, generation and individual.
class Draws : public kernels::RandomStream {
 public:
  Draws(std::uint64_t seed, Use use, int generation, int individual)
      : RandomStream(seed, static_cast<std::uint32_t>(individual),
                     static_cast<std::uint32_t>(generation), static_cast<std::uint32_t>(use)) {}
};

std::uint32_t pack(Cell c) { return kernels::pack(c.x, c.y); }

class GridGa final : public ColonyWorld {
 public:
  GridGa(const Grid& grid, const Request& request, const Params& params,
         const std::function<bool(Cell)>& joined, GridGaMemory& memory, const Observer& observer,
         const disc::DiscSpace* disc)
      : grid_(grid),
        request_(request),
        params_(params),
        joined_(joined),
        memory_(memory),
        observer_(observer),
        disc_(disc),
        threads_(std::clamp(thread_count(params.threads), 1, params.population)) {
    const auto threads = static_cast<std::size_t>(threads_);
    if (memory.scratch.size() < threads) memory.scratch.resize(threads);
    for (int t = 0; t < threads_; ++t) {
      memory.scratch[t].routes.reset(grid, params.neighbours, params.corners, request.stop);
      memory.scratch[t].maker.forget();
    }
    resize(memory.population);
    resize(memory.children);
  }

  Result run() {
    Convergence run;
    const auto cause = run_colony_loop(*this, params_.iterations, request_.stop, run);
    return result_after(cause, std::move(run), std::move(best_path_));
  }

  // What the loop asks for.

  StopCondition::Cause send_ants(int q) override {
    if (q == 0) return make_children([this](Scratch& s, int i, Poller& p) { newcomer(s, i, p); });
    hold_tournaments(q);
    return make_children([=, this](Scratch& s, int i, Poller& p) { child(s, q, i, p); });
  }

  void offer() override {
    for (const Individual& one : memory_.children) {
      if (!(one.length < best_length_)) continue;
      best_length_ = one.length;
      best_path_ = one.points;
    }
  }

  /// The children take over; the best one of their parents lives on.
  void update_trail(int q) override {
    if (q > 0) {
      const auto best = fittest(memory_.population), heir = fittest(memory_.children);
      if (heir->length > best->length)
        std::swap(*std::ranges::max_element(memory_.children, fitter), *best);
    }
    memory_.population.swap(memory_.children);
  }

  int ants() const override { return params_.population; }
  int threads() const override { return threads_; }
  double tour_length(int ant) const override { return memory_.population[ant].tour; }
  double best_length() const override { return best_length_ < kInfinity ? best_length_ : kNaN; }

  StopCondition::Cause observe(const Convergence& run) override {
    return show(observer_, run, View(memory_, best_path_));
  }

 private:
  using Scratch = GridGaMemory::Scratch;

  /// What an observer sees.
  class View final : public GridProgress {
   public:
    View(const GridGaMemory& memory, const std::vector<Point>& best)
        : memory_(memory), best_(best) {}
    std::vector<Point> path() const override { return best_; }
    int ants() const override { return static_cast<int>(memory_.population.size()); }
    std::vector<Cell> tour(int ant) const override { return memory_.population.at(ant).cells; }

   private:
    const GridGaMemory& memory_;
    const std::vector<Point>& best_;
  };

  /// Leaves too many where it is stopped before their memory is given back.
  void resize(std::vector<Individual>& group) const {
    const auto wanted = static_cast<std::size_t>(params_.population);
    while (group.size() > wanted && request_.stop.poll() == StopCondition::Cause::none)
      group.pop_back();
    if (group.size() < wanted) group.resize(wanted);
  }

  static bool fitter(const Individual& a, const Individual& b) { return a.length < b.length; }
  static std::vector<Individual>::iterator fittest(std::vector<Individual>& group) {
    return std::ranges::min_element(group, fitter);
  }

  /// Makes all children over threads; `draft` leaves one's cells in the scratch, none when stopped.
  template <class Draft>
  StopCondition::Cause make_children(const Draft& draft) {
    parallel_for(params_.population, threads_, [&](int i, int thread) {
      Scratch& scratch = memory_.scratch[thread];
      Poller poller(request_.stop, Poller::kSteps);
      scratch.draft.clear();
      if (request_.stop.poll() == StopCondition::Cause::none) draft(scratch, i, poller);
      finish(scratch, memory_.children[i]);
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
    auto way = scratch.maker.cut(grid_, scratch.draft, params_.neighbours != Neighbours::four,
                                 params_.corners, request_.stop);
    const bool stopped = way.empty();
    if (stopped) way = scratch.draft;
    made.cells.assign(way.begin(), way.end());
    for (const Cell c : way) made.points.push_back(centre(c));
    made.tour = path_length(made.points);
    if (params_.polish != Polish::none && !stopped) {
      if (disc_ != nullptr)
        scratch.maker.polish(grid_, *disc_, kInfinity, way, params_, request_.stop, made.points);
      else
        scratch.maker.polish(grid_, way, params_, request_.stop, made.points);
    }
    made.length = path_length(made.points);
  }

  /// From the draft's last cell by way of a drawn cell to the goal; straight to the goal where
  /// draws meet obstacles only. Clears the draft when stopped.
  void go_on(Scratch& scratch, Draws& draws, Poller& poller) {
    constexpr int kTries = 64, kStepsATry = 256;
    for (int i = 0; i < kTries && !poller.stop_after(kStepsATry); ++i) {
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
    std::vector<int>& parents = memory_.parents;
    std::vector<int>& order = memory_.order;
    parents.clear();
    order.resize(memory_.population.size());
    while (static_cast<int>(parents.size()) < count) {
      std::iota(order.begin(), order.end(), 0);
      for (int i = count - 1; i > 0; --i) std::swap(order[i], order[draws.below(i + 1)]);
      for (int i = 0; i < count && static_cast<int>(parents.size()) < count; i += 2) {
        const int a = order[i], b = order[i + 1 < count ? i + 1 : 0];
        parents.push_back(fitter(memory_.population[b], memory_.population[a]) ? b : a);
      }
    }
  }

  /// Finds the cells inside both paths, in the mother's order; some of them only when stopped.
  static void find_common(Scratch& scratch, const Individual& mother, const Individual& father,
                          Poller& poller) {
    constexpr std::int32_t kNone = -1;
    std::vector<std::int32_t>& places = scratch.places;
    places.assign(std::bit_ceil(2 * father.cells.size()), kNone);
    const auto place = [&](Cell c) -> std::int32_t& {
      std::size_t at = (pack(c) * std::uint64_t{0x9e3779b97f4a7c15}) >> 32;
      for (;; ++at) {
        std::int32_t& i = places[at & (places.size() - 1)];
        if (i == kNone || father.cells[i] == c) return i;
      }
    };
    scratch.common.clear();
    const int fathers = static_cast<int>(father.cells.size());
    for (int i = 1; i + 1 < fathers && !poller.stop_after(1); ++i) place(father.cells[i]) = i;
    const int mothers = static_cast<int>(mother.cells.size());
    for (int i = 1; i + 1 < mothers && !poller.stop_after(1); ++i) {
      const std::int32_t at = place(mother.cells[i]);
      if (at != kNone) scratch.common.emplace_back(i, at);
    }
  }

  /// Crosses the parents at a drawn common cell: the draft takes the first part of one and the
  /// second part of the other, its sibling the other way round.
  void cross(Scratch& scratch, const Individual& mother, const Individual& father, bool sibling,
             Draws draws, Poller& poller) {
    find_common(scratch, mother, father, poller);
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
      return memory_.population[memory_.parents[p < params_.population ? p : 0]];
    };
    const int pair = i / 2;
    cross(scratch, parent(2 * pair), parent(2 * pair + 1), i % 2 == 1,
          Draws(params_.seed, Use::crossover, generation, pair), poller);
    if (poller.stopped()) return scratch.draft.clear();
    Draws draws(params_.seed, Use::mutation, generation, i);
    if (!draws.chance(params_.mutation)) return;
    const int kept = 1 + draws.below(static_cast<int>(scratch.draft.size()) - 1);
    scratch.draft.resize(static_cast<std::size_t>(kept));
    go_on(scratch, draws, poller);
  }

  const Grid& grid_;
  const Request& request_;
  const Params& params_;
  const std::function<bool(Cell)>& joined_;
  GridGaMemory& memory_;
  const Observer& observer_;
  const disc::DiscSpace* disc_;
  int threads_;

  double best_length_ = kInfinity;
  std::vector<Point> best_path_;
};

}  // namespace

Result run_grid_ga(const Grid& grid, const Request& request, const Params& params,
                   const std::function<bool(Cell)>& joined, GridGaMemory& memory,
                   const Observer& observer, const disc::DiscSpace* disc) {
  return GridGa(grid, request, params, joined, memory, observer, disc).run();
}

}  // namespace lasius
