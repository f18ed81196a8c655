#include "core/arm/arm_colony.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arm/lattice_ants.h"
#include "core/arm/lattice_trail.h"
#include "core/arm/lattice_way.h"
#include "core/loop/colony_loop.h"
#include "core/loop/run_status.h"
#include "core/loop/trail_rules.h"

namespace lasius::arm {
namespace {

using Cause = StopCondition::Cause;

/// A tour as the trail rules see it.
struct Tour {
  std::span<const std::uint8_t> moves;
  double length = kNaN;
};

struct Tours {
  const Lattice& lattice;
  const LatticeTrail& trail;
  std::span<const Tour> ants;

  template <class Visit>
  void along(const Tour& tour, const Visit& visit) const {
    Node at = lattice.start();
    for (const int k : tour.moves) {
      visit(trail.place(at, k));
      at = lattice.to(at, k);
    }
  }
};

class ArmColony final : public ColonyWorld {
 public:
  ArmColony(const Lattice& lattice, const Request& request, const Params& parameters,
            const Observer& observer)
      : lattice_(lattice),
        request_(request),
        parameters_(parameters),
        observer_(observer),
        rules_{.persistence = 1 - parameters.evaporation,
               .deposit = 1,
               .elite_weight = parameters.elite_weight},
        trail_(lattice, parameters.pheromone, tau0(), parameters.alpha),
        walkers_(lattice, trail_, parameters),
        ants_(parameters.ants),
        tours_(parameters.ants) {
    if (parameters.line_ants > 0) seed_line();
  }

  Result run() {
    const Cause cause = run_colony_loop(*this, parameters_.iterations, request_.stop, result_);
    result_.questions = lattice_.questions();
    if (cause == Cause::none && (!bound_ || bound_at_ != result_.questions)) bound();
    finish(cause);
    return std::move(result_);
  }

  // What the loop asks for.
  Cause send_ants(int q) override {
    trail_.refresh();
    const Cause cause = walkers_.walk(q, ants_, request_.stop);
    for (int a = 0; a < parameters_.ants; ++a) {
      const LatticeAnt& ant = ants_[a];
      result_.steps += ant.steps;
      tours_[a] = {ant.moves, ant.arrived ? length(ant.moves.size()) : kNaN};
    }
    return cause;
  }

  void offer() override {
    shortest_ = nullptr;
    for (const Tour& tour : tours_) {
      if (!trail_rules::arrived(tour)) continue;
      if (shortest_ == nullptr || tour.length < shortest_->length) shortest_ = &tour;
    }
    ++idle_;
    if (shortest_ == nullptr || shortest_->length >= best_length_) return;
    best_.assign(shortest_->moves.begin(), shortest_->moves.end());
    best_length_ = shortest_->length;
    idle_ = 0;
  }

  void update(int) override {
    const Tours tours{lattice_, trail_, tours_};
    // e = 0 is the plain ant system (eq. 10), else the iteration's best counts e times more (11).
    if (parameters_.elite_weight == 0 || shortest_ == nullptr) {
      trail_rules::ant_system(trail_, rules_, tours);
    } else {
      trail_rules::elitist(trail_, rules_, tours, *shortest_);
    }
  }

  int ants() const override { return parameters_.ants; }
  int threads() const override { return parameters_.threads; }
  double tour_length(int ant) const override { return tours_[ant].length; }
  double best_length() const override { return best_.empty() ? kNaN : best_length_; }

  bool settled() const override { return settled_; }

  Cause observe(const Convergence& run) override {
    ArmProgress view;
    view.questions = lattice_.questions();
    view.lower_bound = bound_;
    const Cause cause = show(observer_, run, view);
    if (lattice_.known_blocked(lattice_.goal())) settled_ = true;
    if (parameters_.patience > 0 && !best_.empty() && idle_ >= parameters_.patience)
      settled_ = true;
    // Without an arrival it may be that there is no way: what was learned can tell.
    if (run.arrived.back() == 0) bound();
    if (request_.target_gap > 0 && !best_.empty() && idle_ == 0) {
      bound();
      settled_ |= bound_ && best_length_ <= *bound_ * (1 + request_.target_gap);
    }
    settled_ |= unreachable_;
    return cause;
  }

 private:
  double length(std::size_t moves) const { return static_cast<double>(moves) * lattice_.pitch(); }

  double tau0() const {
    if (parameters_.initial_pheromone > 0) return parameters_.initial_pheromone;
    const double nearest = length(static_cast<std::size_t>(lattice_.manhattan(lattice_.start())));
    return parameters_.ants / nearest;
  }

  void seed_line() {
    const auto moves = straight_moves(lattice_);
    Node at = lattice_.start();
    for (const int move : moves) {
      trail_.deposit(trail_.place(at, move), parameters_.line_ants / length(moves.size()));
      at = lattice_.to(at, move);
    }
  }

  void bound() {
    const KnownWay way = shortest_known_way(lattice_, Unknown::counts_as_free, request_.stop);
    if (way.cause != Cause::none) return;
    bound_at_ = lattice_.questions();
    unreachable_ = !way.moves;
    if (way.moves) bound_ = length(static_cast<std::size_t>(*way.moves));
  }

  void finish(Cause cause) {
    const bool found = !best_.empty();
    result_.status = status_after(cause, found ? Status::solved : Status::no_path);
    if (!found && unreachable_) {
      result_.status = Status::unreachable;
      result_.fault = Fault::disconnected;
      result_.error = "every way from start to goal in this lattice is closed";
    }
    // Where every way to it is closed, no ant may have tried the goal itself.
    if (lattice_.known_blocked(lattice_.goal()) ||
        (result_.status == Status::unreachable && !lattice_.position_free(lattice_.goal()))) {
      result_.status = Status::invalid;
      result_.fault = Fault::goal_blocked;
      result_.error = "the arm touches something at the goal";
    }
    if (!found) return;
    result_.lower_bound = bound_;
    result_.length = best_length_;
    result_.optimal = bound_ && best_length_ <= *bound_;
    const auto points = static_cast<Eigen::Index>(best_.size()) + 1;
    result_.joints.resize(request_.start.size(), points);
    result_.tips.resize(3, points);
    Node at = lattice_.start();
    for (Eigen::Index i = 0; i < points; ++i) {
      if (i > 0) at = lattice_.to(at, best_[i - 1]);
      std::copy_n(lattice_.configuration(at), request_.start.size(), result_.joints.col(i).data());
      result_.tips.col(i) = Eigen::Vector3d(lattice_.position(at));
    }
  }

  const Lattice& lattice_;
  const Request& request_;
  const Params& parameters_;
  const Observer& observer_;
  TrailParams rules_;
  LatticeTrail trail_;
  LatticeAnts walkers_;
  std::vector<LatticeAnt> ants_;
  std::vector<Tour> tours_;
  const Tour* shortest_ = nullptr;  // of the iteration

  std::vector<std::uint8_t> best_;  // moves of the best tour so far
  double best_length_ = std::numeric_limits<double>::infinity();
  int idle_ = 0;  // iterations since it was found
  bool settled_ = false;
  bool unreachable_ = false;
  std::optional<double> bound_;
  Questions bound_at_{.positions = -1};  // what was known when it was computed
  Result result_;
};

}  // namespace

Result run_arm_colony(const Lattice& lattice, const Request& request, const Params& parameters,
                      const Observer& observer) {
  return ArmColony(lattice, request, parameters, observer).run();
}

}  // namespace lasius::arm
