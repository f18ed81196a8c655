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

/// What marching of a level divides weights by, less 1: what is lost by straight lines between
/// places falls with the square of their distance.
double slack_of(int intervals) {
  switch (intervals) {
    case 2:
      return 0.03;
    case 4:
      return 0.003;
    case 8:
      return 0.0003;
    default:
      return 0;
  }
}
/// How far beyond the best path's cost a level marches, as a fraction of it: what lowering takes.
double margin_of(int intervals) {
  switch (intervals) {
    case 2:
      return 0.004;
    case 4:
      return 0.003;
    case 8:
      return 0.0012;
    default:
      return 0.0005;
  }
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
    now->begin(two, start, 0, nullptr, from);
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
  std::unique_ptr<const CellChords> chords_before, chords;
  for (int k = 2; go_on && !poller.stopped() && !reached(); k *= 2) {
    if (k > (options.target_gap > 0 ? CellChords::kMostIntervals : kMostIntervals)) break;
    const bool backward = std::countr_zero(static_cast<unsigned>(k)) % 2 == 1;
    const Cell source = backward ? goal : start, target = backward ? start : goal;
    const Point source_at = backward ? to : from, target_at = backward ? from : to;
    chords = std::make_unique<const CellChords>(k);
    now->begin(*chords, source, slack_of(k), chords_before ? before.get() : nullptr, source_at);
    Level level{.intervals = k};
    double margin = margin_of(k);
    for (level.rounds = 1;; ++level.rounds) {
      const double limit = best.cost() * (1 + margin);
      if (!now->march(*rest, limit, poller)) break;
      if (level.rounds == 1) {
        if (const auto legs = now->trace(target, target_at)) {
          std::vector<Leg> path = *legs;
          if (backward) {
            // Traced from the start: the same pieces the other way.
            std::vector<Leg> turned;
            for (std::size_t i = path.size(); i-- > 0;)
              turned.push_back({path[i].cell, i > 0 ? path[i - 1].to : end});
            path.assign(turned.begin(), turned.end());
          }
          go_on = best.offer(begin, path, lower, poller);
          if (!go_on) break;
        }
      }
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
      const double miss = best.cost() * (1 - 1e-4) - out;
      if (!(miss > 0) || reached() || level.rounds == 8) {
        leaving = std::min(leaving, out);
        break;
      }
      margin += std::max(margin, 1.5 * miss / best.cost());
    }
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
  if (proof != nullptr) {
    done.resize(base);
    done.insert(done.end(), top.begin(), top.end());
    *proof = std::move(done);
  }
  answer.path = best.path();
  answer.length = best.cost();
  answer.lower_bound = std::min(lower, answer.length);
  answer.optimal = answer.length - answer.lower_bound <= 1e-9 * answer.length;
  answer.cause = go_on ? poller.cause() : StopCondition::Cause::token;
  answer.end = poller.stopped() || !go_on ? ExactEnd::stopped
               : answer.optimal           ? ExactEnd::proven
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
