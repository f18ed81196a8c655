#include "core/cost/cost_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>
#include <optional>
#include <span>
#include <utility>

#include "core/cost/coarse_bound.h"
#include "core/cost/path_cost.h"
#include "core/cost/proof_level.h"
#include "core/cost/tube.h"

namespace lasius::cost {
namespace {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Cells on either side of the first walk where the first path of any angle may be: a path
/// is seldom farther from it but on another way around something.
constexpr int kTubeReach = 8;

/// How a level marches.
struct March {
  double slack;   ///< weights are divided by 1 more than that, so that less is left to lower
  double margin;  ///< how far beyond what leaving must cost, as a fraction of it
};
/// What is lost by straight lines between places falls with the square of their distance; what a
/// target gap allows is taken: then next to nothing is left to lower, and the margin leads to the
/// other end.
March march_of(int intervals, double target_gap) {
  March march = intervals == 2   ? March{0.03, 0.004}
                : intervals == 4 ? March{0.003, 0.003}
                : intervals == 8 ? March{0.0003, 0.0012}
                                 : March{0, 0.0005};
  const double allowed = std::min(0.9 * target_gap, 0.02);
  if (allowed > march.slack) march = {allowed, std::max(0.2 * target_gap, 0.0005)};
  return march;
}

/// The best path so far, and who is told of it.
class Best {
 public:
  Best(const Terrain& terrain, const ExactOptions& options)
      : terrain_(terrain), polish_(terrain), options_(options) {}

  /// Polishes a path and keeps it if it is cheaper. False where whoever looks on asks to end.
  bool offer(Point start, std::span<const Leg> legs, double lower, Poller& poller) {
    std::vector<Point> path = polish_.polish(start, legs, poller);
    return offer(std::move(path), lower);
  }
  bool offer(std::vector<Point> path, double lower) {
    const double cost = cost_of(terrain_, path);
    if (!(cost < cost_)) return true;
    cost_ = cost;
    path_ = std::move(path);
    return options_.improved == nullptr ||
           (*options_.improved)(path_, cost_, exact::rounded_down(lower));
  }
  double cost() const noexcept { return cost_; }
  const std::vector<Point>& path() const noexcept { return path_; }

 private:
  const Terrain& terrain_;
  Polish polish_;
  const ExactOptions& options_;
  double cost_ = kInfinity;
  std::vector<Point> path_;
};

std::vector<Point> centres_of(std::span<const Cell> walk) {
  std::vector<Point> path;
  for (const Cell c : walk) path.push_back(centre(c));
  return path;
}

}  // namespace

void CostSearch::search(const Terrain& terrain, Cell start, Cell goal, const ExactOptions& options,
                        const StopCondition& stop, CostAnswer& answer,
                        std::vector<CostProof::Level>* proof, Point from, Point to) {
  const double began = processor_seconds();
  levels_.clear();
  most_bytes_ = 0;
  answer = {};
  Poller poller(stop);
  Best best(terrain, options);
  const Point begin{start.x + from.x, start.y + from.y}, end{goal.x + to.x, goal.y + to.y};
  double lower = StraightBound(terrain, begin).proven(end, goal);
  bool go_on = true;
  const auto walk = eight_moves_.search(terrain, start, goal, Corners::one_side, poller, true);
  const CellChords two(2);
  auto before = std::make_unique<EdgeField>(terrain), now = std::make_unique<EdgeField>(terrain);
  if (!walk.empty()) {
    std::vector<Point> centres = centres_of(walk);
    centres.front() = begin;
    centres.back() = end;
    go_on = best.offer(std::move(centres), lower);
    const Tube tube(terrain, walk, kTubeReach);
    now->begin(two, start, 0, nullptr, from, best.cost());
    if (go_on && now->march(tube, best.cost(), poller)) {
      auto legs = now->trace(goal, to);
      if (!legs) {
        const auto steps =
            eight_moves_.search(terrain, start, goal, Corners::one_side, poller, false);
        if (!steps.empty()) {
          legs = legs_of(steps);
          legs->back().to = end;
        }
      }
      if (legs) go_on = best.offer(begin, *legs, lower, poller);
    }
  }
  levels_.push_back({1, 0, 0, lower, best.cost(), 1, processor_seconds() - began});
  const auto reached = [&] {
    return best.cost() - lower <= std::max(options.target_gap, 1e-9) * lower;
  };
  // What leaving a level must cost, so that the best path is good enough if nothing is cheaper in
  // it.
  const auto enough = [&] {
    return best.cost() * std::min(1 - 1e-4, 1 / (1 + options.target_gap));
  };
  // A path that leaves the cells of some level costs this at least.
  double leaving = kInfinity;
  // The first level comes back from the goal, towards what the start's bound leaves.
  std::optional<Terrain> coarse;
  std::optional<CoarseBound> rest;
  if (go_on && !poller.stopped()) {
    coarse.emplace(blocks_of(terrain));
    rest.emplace(terrain, *coarse, two, start, begin);
    rest->make(best.cost(), poller);
  }
  // Levels that are done, how many of them the bound rests on, and the one above them.
  std::vector<CostProof::Level> done, top;
  std::size_t base = 0;
  if (proof != nullptr && rest && !poller.stopped())
    done.push_back(proof_level(*coarse, rest->field(), true, Blocks::kSide));
  // The path that a field leads back along, to where it has come to the other end.
  const auto offer_traced = [&](const EdgeField& field, bool backward) {
    const auto legs = field.trace(backward ? start : goal, backward ? from : to);
    if (!legs) return false;
    std::vector<Leg> path = *legs;
    if (backward) {
      // Traced from the start: the same pieces the other way.
      for (std::size_t i = 0; i < path.size(); ++i)
        path[path.size() - 1 - i] = {(*legs)[i].cell, i > 0 ? (*legs)[i - 1].to : end};
    }
    go_on = best.offer(begin, path, lower, poller);
    return true;
  };
  bool traced = false, traced_any = false;
  std::unique_ptr<const CellChords> chords_before, chords;
  for (int k = 2; go_on && !poller.stopped() && !reached(); k *= 2) {
    if (k > (options.target_gap > 0 ? CellChords::kMostIntervals : kMostIntervals)) break;
    const bool backward = std::countr_zero(static_cast<unsigned>(k)) % 2 == 1;
    const Cell source = backward ? goal : start, target = backward ? start : goal;
    const Point source_at = backward ? to : from, target_at = backward ? from : to;
    const March how = march_of(k, options.target_gap);
    chords = std::make_unique<const CellChords>(k);
    now->begin(*chords, source, how.slack, chords_before ? before.get() : nullptr, source_at,
               best.cost());
    Level level{.intervals = k};
    double margin = how.margin;
    traced = false;
    for (level.rounds = 1;; ++level.rounds) {
      const double limit = enough() * (1 + margin);
      if (!now->march(*rest, limit, poller)) break;
      if (!traced) traced = offer_traced(*now, backward);
      if (!go_on) break;
      if (!now->certify(poller)) break;
      level.excess = now->excess();
      const double within = now->bound(target, target_at);
      const double out = now->bound_of_leaving();
      level.cells = static_cast<std::int64_t>(now->cells().size());
      if (const double proven = std::min({within, out, leaving}); proven > lower) {
        lower = proven;
        if (proof != nullptr) {
          base = done.size();
          top.assign(1, proof_level(terrain, *now, !backward, 1));
        }
      }
      const double miss = enough() - out;
      if (!(miss > 0) || reached() || level.rounds == 8) {
        leaving = std::min(leaving, out);
        break;
      }
      margin += std::max(margin, 1.5 * miss / best.cost());
    }
    traced_any = traced_any || traced;
    level.lower = lower;
    level.upper = best.cost();
    level.seconds = processor_seconds() - began;
    levels_.push_back(level);
    if (proof != nullptr && go_on && !poller.stopped())
      done.push_back(proof_level(terrain, *now, !backward, 1));
    most_bytes_ = std::max(most_bytes_, eight_moves_.bytes() + before->bytes() + now->bytes());
    std::swap(before, now);
    std::swap(chords_before, chords);
  }
  // Levels that prove a target gap need not lead from end to end: what they left out may still be
  // a little cheaper.
  if (go_on && !poller.stopped() && !traced_any && levels_.size() > 1) {
    now->begin(two, goal, march_of(2, 0).slack, nullptr, to, best.cost());
    if (now->march(*rest, best.cost(), poller)) offer_traced(*now, true);
  }
  if (proof != nullptr) {
    done.resize(base);
    done.insert(done.end(), top.begin(), top.end());
    *proof = std::move(done);
  }
  answer.path = best.path();
  answer.length = best.cost();
  answer.lower_bound = std::min(lower, answer.length);
  answer.optimal = answer.length - answer.lower_bound <= 1e-9 * answer.length;
  // What is proven by then is so, though time ran out behind it.
  const bool stopped = !go_on || (poller.stopped() && !reached());
  answer.cause = !stopped ? StopCondition::Cause::none
                 : go_on  ? poller.cause()
                          : StopCondition::Cause::token;
  answer.end = stopped          ? ExactEnd::stopped
               : answer.optimal ? ExactEnd::proven
                                : ExactEnd::target_gap;
}

void CostSearch::search_eight_moves(const Terrain& terrain, Cell start, Cell goal, Corners corners,
                                    const StopCondition& stop, CostAnswer& answer) {
  answer = {};
  Poller poller(stop);
  const ExactOptions options;
  Best best(terrain, options);
  const auto walk = eight_moves_.search(terrain, start, goal, corners, poller, false);
  answer.cause = poller.cause();
  answer.end = poller.stopped() ? ExactEnd::stopped : ExactEnd::unreachable;
  if (walk.empty()) return;
  answer.path = centres_of(walk);
  best.offer(answer.path, 0);
  answer.end = ExactEnd::proven;
  answer.length = answer.lower_bound = best.cost();
  answer.optimal = true;
}

}  // namespace lasius::cost
