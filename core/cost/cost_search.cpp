#include "core/cost/cost_search.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "core/base/processor_time.h"
#include "core/cost/coarse_bound.h"
#include "core/cost/path_cost.h"
#include "core/cost/proof_level.h"
#include "core/cost/tube.h"

namespace lasius::cost {
namespace {

/// Cells on either side of the first walk where the first path of any angle may be: a path
/// is seldom farther from it but on another way around something.
constexpr int kTubeReach = 8;

/// Where the straight way tells most of the best path's cost already, a level with two intervals
/// tells little more: what it lowers on open ground is more than what it would leave out
/// (measured).
constexpr double kNearlyStraight = 0.3;

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
    const double cost = cost_of(terrain_, path);
    if (cost < kInfinity) return offer(std::move(path), cost, lower);
    path.assign(1, start);  // rounding, at a corner of a blocked cell
    for (const Leg& leg : legs) path.push_back(leg.to);
    return offer(std::move(path), lower);
  }
  bool offer(std::vector<Point> path, double lower) {
    const double cost = cost_of(terrain_, path);
    return offer(std::move(path), cost, lower);
  }
  double cost() const noexcept { return cost_; }
  const std::vector<Point>& path() const noexcept { return path_; }

 private:
  bool offer(std::vector<Point> path, double cost, double lower) {
    if (!(cost < cost_)) return true;
    cost_ = cost;
    path_ = std::move(path);
    return options_.improved == nullptr ||
           (*options_.improved)(path_, cost_, exact::rounded_down(lower));
  }

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

/// One search, step by step.
class CostSearch::Run {
 public:
  Run(CostSearch& search, const Terrain& terrain, const Question& asked,
      const ExactOptions& options, const StopCondition& stop, bool proof)
      : search_(search),
        terrain_(terrain),
        asked_(asked),
        options_(options),
        poller_(stop),
        best_(terrain, options),
        wants_proof_(proof),
        begin_{asked.start.x + asked.from.x, asked.start.y + asked.from.y},
        end_{asked.goal.x + asked.to.x, asked.goal.y + asked.to.y},
        lower_(StraightBound(terrain, begin_).proven(end_, asked.goal)),
        before_(std::make_unique<EdgeField>(terrain)),
        now_(std::make_unique<EdgeField>(terrain)) {}

  void run() {
    first_path();
    search_.levels_.push_back({1, 0, 0, lower_, best_.cost(), 1, seconds()});
    if (goes_on()) bound_by_blocks();
    const int most = options_.target_gap > 0 ? CellChords::kMostIntervals : kMostIntervals;
    const bool straight = best_.cost() <= (1 + kNearlyStraight) * lower_;
    for (int k = straight ? 4 : 2; k <= most && goes_on() && !reached(); k *= 2) level(k);
    // Levels that prove a target gap need not lead from end to end: what they left out may still
    // be a little cheaper.
    if (goes_on() && !traced_any_ && search_.levels_.size() > 1) {
      now_->begin(two_, asked_.goal, march_of(2, 0).slack, nullptr, asked_.to, best_.cost());
      if (now_->march(*rest_, best_.cost(), poller_)) offer_traced(*now_, true);
    }
  }

  void tell(CostAnswer& answer) const {
    answer.path = best_.path();
    answer.length = best_.cost();
    answer.lower_bound = std::min(lower_, answer.length);
    answer.optimal = answer.length - answer.lower_bound <= 1e-9 * answer.length;
    // What is proven by then is so, though time ran out behind it.
    const bool stopped = !go_on_ || (poller_.stopped() && !reached());
    answer.cause = !stopped ? StopCondition::Cause::none
                   : go_on_ ? poller_.cause()
                            : StopCondition::Cause::token;
    answer.end = stopped          ? ExactEnd::stopped
                 : answer.optimal ? ExactEnd::proven
                                  : ExactEnd::target_gap;
  }

  /// The levels that prove the lower bound.
  std::vector<CostProof::Level> proof() && {
    done_.resize(base_);
    done_.insert(done_.end(), top_.begin(), top_.end());
    return std::move(done_);
  }

 private:
  double seconds() const { return processor_seconds() - began_; }
  bool goes_on() const { return go_on_ && !poller_.stopped(); }
  bool reached() const {
    return best_.cost() - lower_ <= std::max(options_.target_gap, 1e-9) * lower_;
  }
  /// What leaving a level must cost, so that the best path is good enough if nothing is cheaper in
  /// it.
  double enough() const { return best_.cost() * std::min(1 - 1e-4, 1 / (1 + options_.target_gap)); }

  /// The cheapest walk by eight moves, then the cheapest path of any angle around it.
  void first_path() {
    const auto& [start, goal, from, to] = asked_;
    if (start == goal) return within_a_cell();
    const auto walk =
        search_.eight_moves_.search(terrain_, start, goal, Corners::one_side, poller_, true);
    if (walk.empty()) return;
    std::vector<Point> centres = centres_of(walk);
    centres.front() = begin_;
    centres.back() = end_;
    go_on_ = best_.offer(std::move(centres), lower_);
    const Tube tube(terrain_, walk, kTubeReach);
    now_->begin(two_, start, 0, nullptr, from, best_.cost());
    if (!go_on_ || !now_->march(tube, best_.cost(), poller_)) return;
    auto legs = now_->trace(goal, to);
    if (!legs) {
      const auto steps =
          search_.eight_moves_.search(terrain_, start, goal, Corners::one_side, poller_, false);
      if (!steps.empty()) {
        legs = legs_of(steps);
        legs->back().to = end_;
      }
    }
    if (legs) go_on_ = best_.offer(begin_, *legs, lower_, poller_);
  }

  /// Straight, or out over an edge, around the cell and back over that edge or another.
  void within_a_cell() {
    constexpr int kX[8] = {0, 1, 1, 1, 0, -1, -1, -1}, kY[8] = {-1, -1, 0, 1, 1, 1, 0, -1};
    const Cell cell = asked_.start;
    go_on_ = best_.offer({begin_, end_}, lower_);
    for (int out = 0; out < 8; out += 2) {
      for (const int turn : {1, 7}) {
        std::vector<Leg> legs{{cell, begin_}};
        for (int i = 0; i < 8 && go_on_; ++i) {
          const int at = (out + turn * i) % 8;
          const Cell beside{cell.x + kX[at], cell.y + kY[at]};
          const bool free = terrain_.free(beside.x, beside.y);
          if (!free && i % 2 == 0) break;
          legs.push_back({free ? beside : cell, end_});
          if (i % 2 != 0) continue;
          legs.push_back({cell, end_});
          go_on_ = best_.offer(begin_, legs, lower_, poller_);
          legs.pop_back();
        }
      }
    }
  }

  /// The first level comes back from the goal, towards what the start's bound leaves.
  void bound_by_blocks() {
    coarse_.emplace(blocks_of(terrain_));
    rest_.emplace(terrain_, *coarse_, two_, asked_.start, begin_);
    rest_->make(best_.cost(), poller_);
    if (wants_proof_ && !poller_.stopped())
      done_.push_back(proof_level(*coarse_, rest_->field(), true, Blocks::kSide));
  }

  /// A level with k intervals an edge, from either end in turn.
  void level(int k) {
    const bool backward = search_.levels_.size() % 2 == 1;
    const March how = march_of(k, options_.target_gap);
    chords_ = std::make_unique<const CellChords>(k);
    now_->begin(*chords_, backward ? asked_.goal : asked_.start, how.slack,
                chords_before_ ? before_.get() : nullptr, backward ? asked_.to : asked_.from,
                best_.cost());
    Level level{.intervals = k};
    rounds(level, backward, how.margin);
    level.lower = lower_;
    level.upper = best_.cost();
    level.seconds = seconds();
    search_.levels_.push_back(level);
    if (wants_proof_ && goes_on()) done_.push_back(proof_level(terrain_, *now_, !backward, 1));
    search_.most_bytes_ = std::max(search_.most_bytes_,
                                   search_.eight_moves_.bytes() + before_->bytes() + now_->bytes());
    std::swap(before_, now_);
    std::swap(chords_before_, chords_);
  }

  /// Marches farther until leaving what was reached costs enough.
  void rounds(Level& level, bool backward, double margin) {
    bool traced = false;
    for (level.rounds = 1;; ++level.rounds) {
      if (!now_->march(*rest_, enough() * (1 + margin), poller_)) break;
      if (!traced) traced = offer_traced(*now_, backward);
      if (!go_on_ || !now_->certify(poller_)) break;
      level.excess = now_->excess();
      const double within =
          now_->bound(backward ? asked_.start : asked_.goal, backward ? asked_.from : asked_.to);
      const double out = now_->bound_of_leaving();
      level.cells = static_cast<std::int64_t>(now_->cells().size());
      raise(std::min({within, out, leaving_}), backward);
      const double miss = enough() - out;
      if (!(miss > 0) || reached() || level.rounds == 8) {
        leaving_ = std::min(leaving_, out);
        break;
      }
      margin += std::max(margin, 1.5 * miss / best_.cost());
    }
    traced_any_ = traced_any_ || traced;
  }

  void raise(double proven, bool backward) {
    if (!(proven > lower_)) return;
    lower_ = proven;
    if (!wants_proof_) return;
    base_ = done_.size();
    top_.assign(1, proof_level(terrain_, *now_, !backward, 1));
  }

  /// The path that a field leads back along, to where it has come to the other end.
  bool offer_traced(const EdgeField& field, bool backward) {
    const auto legs =
        field.trace(backward ? asked_.start : asked_.goal, backward ? asked_.from : asked_.to);
    if (!legs) return false;
    std::vector<Leg> path = *legs;
    if (backward) {
      // Traced from the start: the same pieces the other way.
      for (std::size_t i = 0; i < path.size(); ++i)
        path[path.size() - 1 - i] = {(*legs)[i].cell, i > 0 ? (*legs)[i - 1].to : end_};
    }
    go_on_ = best_.offer(begin_, path, lower_, poller_);
    return true;
  }

  const double began_ = processor_seconds();
  CostSearch& search_;
  const Terrain& terrain_;
  const Question& asked_;
  const ExactOptions& options_;
  Poller poller_;
  Best best_;
  const bool wants_proof_;
  const Point begin_, end_;
  double lower_;
  bool go_on_ = true, traced_any_ = false;
  double leaving_ = kInfinity;  // a path that leaves the cells of some level costs this at least
  const CellChords two_{2};
  std::unique_ptr<EdgeField> before_, now_;  // the level before and this one
  std::unique_ptr<const CellChords> chords_before_, chords_;
  std::optional<Terrain> coarse_;
  std::optional<CoarseBound> rest_;
  // Levels that are done, how many of them the bound rests on, and the one above them.
  std::vector<CostProof::Level> done_, top_;
  std::size_t base_ = 0;
};

void CostSearch::search(const Terrain& terrain, const Question& asked, const ExactOptions& options,
                        const StopCondition& stop, CostAnswer& answer,
                        std::vector<CostProof::Level>* proof) {
  levels_.clear();
  most_bytes_ = 0;
  answer = {};
  Run run(*this, terrain, asked, options, stop, proof != nullptr);
  run.run();
  run.tell(answer);
  if (proof != nullptr) *proof = std::move(run).proof();
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
