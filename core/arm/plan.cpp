#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "colony_loop.h"
#include "lasius/arm_plan.h"
#include "lasius/error.h"
#include "lattice_ants.h"
#include "lattice_bound.h"
#include "lattice_trail.h"
#include "trail_rules.h"

namespace lasius::arm {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
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

lasius::Params rule_params(const Parameters& p) {
  lasius::Params params;
  params.persistence = 1 - p.evaporation;
  params.deposit = 1;
  params.elite_weight = p.elite_weight;
  return params;
}

/// The moves from start to goal that keep nearest to the straight line: each along the axis that
/// lags most behind its share of the way.
std::vector<int> straight_moves(const Lattice& lattice) {
  const auto goal = lattice.coordinates(lattice.goal());
  const int count = lattice.manhattan(lattice.start());
  std::array<int, 3> done{};
  std::vector<int> moves;
  for (int i = 1; i <= count; ++i) {
    int next = 0;
    double most = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const int all = std::abs(goal[axis]);
      const double behind = static_cast<double>(i) * all / count - done[axis];
      if (done[axis] < all && behind > most) {
        most = behind;
        next = axis;
      }
    }
    ++done[next];
    moves.push_back(2 * next + (goal[next] > 0 ? 0 : 1));
  }
  return moves;
}

class ArmColony final : public ColonyWorld {
 public:
  ArmColony(const Lattice& lattice, const Request& request, const Parameters& parameters,
            const Observer& observer)
      : lattice_(lattice),
        request_(request),
        parameters_(parameters),
        observer_(observer),
        rules_(rule_params(parameters)),
        trail_(lattice, parameters.pheromone, tau0(), parameters.alpha),
        walkers_(lattice, trail_, parameters),
        ants_(parameters.ants),
        tours_(parameters.ants) {
    if (parameters.line_ants > 0) seed_line();
  }

  Result run() {
    Convergence run;
    const Cause cause = run_colony_loop(*this, parameters_.iterations, request_.stop, run);
    result_.iterations = run.iterations;
    result_.best = std::move(run.best);
    result_.mean = std::move(run.mean);
    result_.arrived = std::move(run.arrived);
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
  double tour_length(int ant) const override { return tours_[ant].length; }
  double best_length() const override { return best_.empty() ? kNaN : best_length_; }

  bool settled() const override { return settled_; }

  void observe(const Convergence& run) override {
    if (observer_) {
      observer_({.iteration = run.iterations - 1,
                 .best_length = run.best.back(),
                 .mean_length = run.mean.back(),
                 .arrived = run.arrived.back(),
                 .questions = lattice_.questions()});
    }
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
    result_.status = found ? Status::solved : Status::no_path;
    if (cause == Cause::deadline) result_.status = Status::limit;
    if (cause == Cause::token) result_.status = Status::interrupted;
    if (!found && unreachable_) {
      result_.status = Status::unreachable;
      result_.error = "every way from start to goal in this lattice is closed";
    }
    if (lattice_.known_blocked(lattice_.goal())) {
      result_.status = Status::invalid;
      result_.error = "the arm touches something at the goal";
    }
    if (!found) return;
    result_.lower_bound = bound_;
    result_.length = best_length_;
    result_.optimal = bound_ && best_length_ <= *bound_;
    Node at = lattice_.start();
    add(at);
    for (const int k : best_) add(at = lattice_.to(at, k));
  }

  void add(Node v) {
    const double* q = lattice_.configuration(v);
    result_.joints.emplace_back(q, q + request_.start.size());
    result_.tips.push_back(lattice_.position(v));
  }

  const Lattice& lattice_;
  const Request& request_;
  const Parameters& parameters_;
  const Observer& observer_;
  lasius::Params rules_;
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
  Questions bound_at_{-1, -1};  // what was known when it was computed
  Result result_;
};

Result invalid(std::string why) {
  Result result;
  result.status = Status::invalid;
  result.error = std::move(why);
  return result;
}

std::string joint_name(const Robot& robot, std::size_t j) {
  const std::string& name = robot.joints[j].name;
  return "joint " + std::to_string(j + 1) + (name.empty() ? "" : " (" + name + ")");
}

std::string text(Vec3 p) {
  return std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.z);
}

/// Why the arm cannot stand at `start`; empty where it can, as far as kinematics tells.
std::string start_fault(const Robot& robot, const std::vector<double>& start) {
  if (start.size() != robot.joints.size()) {
    return "start has " + std::to_string(start.size()) + " joint values, the robot has " +
           std::to_string(robot.joints.size()) + " joints";
  }
  for (std::size_t j = 0; j < start.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (start[j] >= joint.low && start[j] <= joint.high) continue;
    return "start: " + joint_name(robot, j) + " is " + std::to_string(start[j]) +
           ", its limits are " + std::to_string(joint.low) + " .. " + std::to_string(joint.high);
  }
  return {};
}

/// The box of the lattice: all that the arm can reach, or `side` points about the middle of start
/// and goal; start and goal within.
struct Box {
  std::array<int, 3> low, high;
};
Box box_of(const Kinematics& arm, Vec3 from, double pitch, int side,
           const std::array<int, 3>& goal) {
  const std::array<double, 3> start{from.x, from.y, from.z};
  const Vec3 s = arm.shoulder();
  const std::array<double, 3> shoulder{s.x, s.y, s.z};
  Box box;
  double points = 1;
  for (int i = 0; i < 3; ++i) {
    if (side > 0) {
      const int middle = goal[i] / 2;
      box.low[i] = middle - (side - 1) / 2;
      box.high[i] = box.low[i] + side - 1;
    } else {
      const auto most = [](double v) { return static_cast<int>(std::clamp(v, -1e6, 1e6)); };
      box.low[i] = most(std::ceil((shoulder[i] - arm.reach() - start[i]) / pitch));
      box.high[i] = most(std::floor((shoulder[i] + arm.reach() - start[i]) / pitch));
    }
    box.low[i] = std::min({box.low[i], 0, goal[i]});
    box.high[i] = std::max({box.high[i], 0, goal[i]});
    points *= box.high[i] - box.low[i] + 3;
  }
  if (points > static_cast<double>(Lattice::kMostNodes)) {
    throw Error(ErrorCode::invalid_parameter,
                "pitch is " + std::to_string(pitch) + ", which makes a lattice of " +
                    std::to_string(points) + " points",
                "take a larger pitch or a smaller side: at most " +
                    std::to_string(Lattice::kMostNodes) + " points fit");
  }
  return box;
}

}  // namespace

Result::Result() : length(kNaN) {}

std::optional<double> Result::gap() const {
  if (std::isnan(length)) return std::nullopt;
  if (length == 0) return 0;
  if (!lower_bound || *lower_bound <= 0) return std::nullopt;
  return (length - *lower_bound) / *lower_bound;
}

namespace {

/// Checks a question, lays out its lattice, and has it answered by `search(lattice, parameters)`.
template <class Search>
Result answer(const Robot& robot, const Sensor& sensor, const Request& request,
              const Parameters& given, const Search& search) {
  validate(robot);
  validate(given);
  Parameters parameters = given;
  if (parameters.threads == 0) parameters.threads = omp_get_max_threads();
  if (std::string fault = start_fault(robot, request.start); !fault.empty()) {
    return invalid(std::move(fault));
  }
  const Kinematics arm(robot);
  if (parameters.pitch == 0) parameters.pitch = arm.reach() / 20;
  Kinematics::Poses poses;
  arm.place(request.start, poses);
  const Vec3 from = arm.tip(poses);
  const Vec3 way = (1 / parameters.pitch) * (request.goal - from);
  if (!(distance(request.goal, arm.shoulder()) <= arm.reach() + Kinematics::kTolerance)) {
    return invalid("goal " + text(request.goal) +
                   " is outside: " + std::to_string(distance(request.goal, arm.shoulder())) +
                   " m from the first joint, the arm reaches " + std::to_string(arm.reach()) +
                   " m");
  }
  if (!(length(way) < 1e6)) {
    throw Error(ErrorCode::invalid_parameter,
                "pitch is " + std::to_string(parameters.pitch) + ", too small for this goal",
                "take a larger one");
  }
  const std::array<int, 3> goal{static_cast<int>(std::lround(way.x)),
                                static_cast<int>(std::lround(way.y)),
                                static_cast<int>(std::lround(way.z))};
  const bool at_start = goal == std::array<int, 3>{0, 0, 0};
  if (at_start && distance(from, request.goal) > Kinematics::kTolerance) {
    return invalid("goal " + text(request.goal) +
                   " is less than half a pitch from the start; take a smaller pitch");
  }
  const Box box = box_of(arm, from, parameters.pitch, parameters.side, goal);
  const Lattice lattice(arm, sensor, request.start, parameters.pitch, box.low, box.high, goal,
                        request.goal, parameters);

  Result result;
  const auto sized = [&](Result r) {
    r.pitch = parameters.pitch;
    for (int i = 0; i < 3; ++i) r.points[i] = box.high[i] - box.low[i] + 1;
    r.questions = lattice.questions();
    return r;
  };
  if (!lattice.position_free(lattice.start())) {
    return sized(invalid("the arm touches something at the start"));
  }
  if (at_start) {
    result.status = Status::solved;
    result.length = 0;
    result.lower_bound = 0;
    result.optimal = true;
    result.joints = {request.start};
    result.tips = {from};
    return sized(std::move(result));
  }
  if (lattice.configuration(lattice.goal()) == nullptr) {
    return sized(invalid("goal " + text(request.goal) +
                         " is outside: the arm does not get there from the start within its joint "
                         "limits"));
  }
  return sized(search(lattice, parameters));
}

}  // namespace

Result plan(const Robot& robot, const Sensor& sensor, const Request& request,
            const Parameters& parameters, const Observer& observer) {
  return answer(robot, sensor, request, parameters,
                [&](const Lattice& lattice, const Parameters& p) {
                  return ArmColony(lattice, request, p, observer).run();
                });
}

Result shortest_lattice_way(const Robot& robot, const Sensor& sensor, const Request& request,
                            const Parameters& parameters) {
  const auto search = [&](const Lattice& lattice, const Parameters&) {
    const KnownWay way = shortest_known_way(lattice, Unknown::is_asked, request.stop);
    Result result;
    result.status = way.cause == Cause::token      ? Status::interrupted
                    : way.cause == Cause::deadline ? Status::limit
                    : way.moves                    ? Status::solved
                                                   : Status::unreachable;
    if (!way.moves) return result;
    result.length = static_cast<double>(*way.moves) * lattice.pitch();
    result.lower_bound = result.length;
    result.optimal = true;
    return result;
  };
  return answer(robot, sensor, request, parameters, search);
}

Result straight_lattice_way(const Robot& robot, const Sensor& sensor, const Request& request,
                            const Parameters& parameters) {
  const auto search = [](const Lattice& lattice, const Parameters&) {
    Result result;
    Node at = lattice.start();
    const auto moves = straight_moves(lattice);
    for (const int move : moves) {
      if (!lattice.open(at, move)) return result;
      at = lattice.to(at, move);
    }
    result.status = Status::solved;
    result.length = static_cast<double>(moves.size()) * lattice.pitch();
    return result;
  };
  return answer(robot, sensor, request, parameters, search);
}

}  // namespace lasius::arm
