#include "core/arm/arm_colony.h"

#include <algorithm>

#include "core/arm/lattice_ants.h"
#include "core/arm/lattice_trail.h"
#include "core/arm/lattice_way.h"
#include "core/base/special_values.h"
#include "core/loop/colony_loop.h"
#include "core/loop/run_status.h"
#include "core/loop/trail_rules.h"

namespace lasius::arm {
namespace {

using Cause = StopCondition::Cause;

constexpr double kRounding = 1e-9;

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
  ArmColony(Lattice& lattice, const Request& request, const Params& parameters,
            const Observer& observer)
      : lattice_(lattice),
        request_(request),
        parameters_(parameters),
        observer_(observer),
        rules_{.persistence = parameters.persistence,
               .deposit = 1,
               .elite_weight = parameters.elite_weight},
        trail_(lattice, parameters.pheromone, tau0(), parameters.alpha),
        walkers_(lattice, trail_, parameters),
        ants_(parameters.ants),
        tours_(parameters.ants) {
    if (parameters.line_ants > 0) seed_line();
  }

  Result run() {
    const Cause cause =
        run_colony_loop(*this, parameters_.iterations, request_.stop, result_.curves);
    result_.questions = lattice_.questions();
    if (cause == Cause::none && (!bound_ || bound_questions_ != result_.questions)) update_bound();
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
      tours_[a] = {ant.moves, ant.arrived ? length(ant.moves) : kNaN};
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

  void update_trail(int) override {
    const Tours tours{lattice_, trail_, tours_};
    // e = 0 is the plain ant system (eq. 10), else the iteration's best counts e times more (11).
    if (parameters_.elite_weight == 0 || shortest_ == nullptr)
      trail_rules::ant_system(trail_, rules_, tours);
    else
      trail_rules::elitist(trail_, rules_, tours, *shortest_);
  }

  int ants() const override { return parameters_.ants; }
  int threads() const override { return parameters_.threads; }
  double tour_length(int ant) const override { return tours_[ant].length; }
  double best_length() const override { return best_.empty() ? kNaN : best_length_; }

  bool settled() override {
    const bool blocked = lattice_.goals_blocked(false);
    const bool any = !best_.empty();
    // Without an arrival it may be that there is no way: what was learned can tell. With a shorter
    // tour the gap may be what was asked for.
    const bool gains = request_.target_gap > 0 && any && idle_ == 0;
    if (shortest_ == nullptr || gains) update_bound();
    return blocked || all_closed_ ||
           (parameters_.patience > 0 && any && idle_ >= parameters_.patience) ||
           (gains && bound_ && best_length_ <= *bound_ * (1 + request_.target_gap));
  }

  Cause observe(const Convergence& run) override {
    ArmProgress view;
    view.questions = lattice_.questions();
    view.lower_bound = bound_;
    view.joints = [this] { return joints_of(best_nodes()); };
    const Cause cause = show(observer_, run, view);
    result_.asked.push_back(lattice_.questions());
    return cause;
  }

 private:
  double length(std::span<const std::uint8_t> moves) const {
    double cost = 0;
    Node at = lattice_.start();
    for (const int move : moves) {
      cost += lattice_.cost(at, move);
      at = lattice_.to(at, move);
    }
    return cost * lattice_.unit();
  }

  double tau0() const {
    if (parameters_.initial_pheromone > 0) return parameters_.initial_pheromone;
    return parameters_.ants / (lattice_.least(lattice_.start()) * lattice_.unit());
  }

  void seed_line() {
    const auto moves = straight_moves(lattice_);
    Node at = lattice_.start();
    const double length = static_cast<double>(moves.size()) * lattice_.pitch();
    for (const int move : moves) {
      trail_.deposit(trail_.place(at, move), parameters_.line_ants / length);
      at = lattice_.to(at, move);
    }
  }

  void update_bound() {
    if (lattice_.spent()) return;  // the search, which asks nothing, would be cut at once
    const KnownWay way = shortest_known_way(lattice_, Unknown::counts_as_free, request_.stop);
    if (way.cause != Cause::none) return;
    bound_questions_ = lattice_.questions();
    all_closed_ = !way.cost;
    if (way.cost) bound_ = *way.cost * lattice_.unit();
  }

  void finish(Cause cause) {
    const bool found = !best_.empty();
    end_run(result_, cause, found ? Status::solved : Status::no_path);
    // Where every way to it is closed, no ant may have tried the goal itself.
    if (lattice_.goals_blocked(!found && all_closed_)) {
      result_.status = Status::invalid;
      result_.fault = Fault::goal_blocked;
      result_.error = "the arm touches something at the goal";
    }
    result_.questions = lattice_.questions();
    if (result_.status == Status::no_path) {
      result_.error = lattice_.not_found();
      result_.error += all_closed_ ? ", every way in it is closed; " : "; try more iterations";
      if (all_closed_) result_.error += kTryElse;
    }
    if (!found) return;
    result_.length = best_length_;
    if (bound_) result_.lower_bound = std::min(*bound_, best_length_);
    result_.optimal = bound_ && best_length_ <= *bound_ * (1 + kRounding);
    const std::vector<Node> nodes = best_nodes();
    result_.joints = joints_of(nodes);
    result_.tips.resize(3, std::ssize(nodes));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      result_.tips.col(i) = Eigen::Vector3d(lattice_.position(nodes[i]));
    result_.goal = lattice_.goal_of(nodes.back());
  }

  /// Lattice points of the best tour so far; none without one.
  std::vector<Node> best_nodes() const {
    std::vector<Node> nodes;
    if (best_.empty()) return nodes;
    nodes.push_back(lattice_.start());
    for (const int move : best_) nodes.push_back(lattice_.to(nodes.back(), move));
    return nodes;
  }

  Eigen::MatrixXd joints_of(const std::vector<Node>& nodes) const {
    const Eigen::Index joints = request_.start.size();
    Eigen::MatrixXd values(joints, std::ssize(nodes));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      std::copy_n(lattice_.configuration(nodes[i]), joints, values.col(i).data());
    return values;
  }

  Lattice& lattice_;
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
  double best_length_ = kInfinity;
  int idle_ = 0;             // iterations since it was found
  bool all_closed_ = false;  // every way is known to be
  std::optional<double> bound_;
  Questions bound_questions_{.positions = -1};  // that were asked when it was computed
  Result result_;
};

}  // namespace

Result run_arm_colony(Lattice& lattice, const Request& request, const Params& parameters,
                      const Observer& observer) {
  return ArmColony(lattice, request, parameters, observer).run();
}

}  // namespace lasius::arm
