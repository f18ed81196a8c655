#include "bench/peers/sampling.h"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <chrono>
#include <limits>

#include "bench/peers/motions.h"
#include "bench/peers/segment.h"

namespace lasius::peers {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Space = ob::RealVectorStateSpace;
using Stopwatch = std::chrono::steady_clock;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::array<std::string_view, 4> kNames = {"RRT*", "Informed RRT*", "BIT*",
                                                    "RRTConnect + simplification"};

Point point_of(const ob::State* state) {
  const double* values = state->as<Space::StateType>()->values;
  return {values[0], values[1]};
}

// One query set up for OMPL, with the clock.
class Trial {
 public:
  Trial(const Grid& grid, Cell start, Cell goal, double optimum, double cap)
      : optimum_(optimum), cap_(cap), space_(std::make_shared<Space>(2)) {
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0);
    bounds.setHigh(0, grid.width());
    bounds.setHigh(1, grid.height());
    space_->setBounds(bounds);
    information_ = std::make_shared<ob::SpaceInformation>(space_);
    information_->setStateValidityChecker([&grid](const ob::State* state) {
      const Point p = point_of(state);
      return grid.free({static_cast<int>(p.x), static_cast<int>(p.y)});
    });
    const auto free = [&grid](const ob::State* a, const ob::State* b) {
      return segment_clear(grid, point_of(a), point_of(b));
    };
    information_->setMotionValidator(std::make_shared<Motions<decltype(free)>>(information_, free));
    information_->setup();
    problem_ = std::make_shared<ob::ProblemDefinition>(information_);
    problem_->setOptimizationObjective(
        std::make_shared<ob::PathLengthOptimizationObjective>(information_));
    ob::ScopedState<Space> from(space_), to(space_);
    from->values[0] = centre(start).x;
    from->values[1] = centre(start).y;
    to->values[0] = centre(goal).x;
    to->values[1] = centre(goal).y;
    problem_->setStartAndGoalStates(from, to);
    problem_->setIntermediateSolutionCallback([this](const ob::Planner*,
                                                     const std::vector<const ob::State*>&,
                                                     const ob::Cost cost) { note(cost.value()); });
    trial_.seconds.fill(kNever);
    trial_.first_seconds = kNever;
  }

  SamplingTrial optimise(const ob::PlannerPtr& planner) {
    begin(planner);
    planner->solve(until_done());
    if (problem_->hasExactSolution()) note(problem_->getSolutionPath()->length());
    return trial_;
  }

  SamplingTrial restart(const ob::PlannerPtr& planner, std::uint32_t seed) {
    begin(planner);
    for (std::uint32_t i = 0; !done(); ++i) {
      ompl::RNG::setSeed(seed + 1000 * i);
      planner->clear();
      problem_->clearSolutionPaths();
      if (planner->solve(until_done()) != ob::PlannerStatus::EXACT_SOLUTION) break;
      og::PathGeometric path(*problem_->getSolutionPath()->as<og::PathGeometric>());
      og::PathSimplifier(information_, problem_->getGoal()).simplifyMax(path);
      note(path.length());
    }
    return trial_;
  }

  const ob::SpaceInformationPtr& information() const { return information_; }

 private:
  void begin(const ob::PlannerPtr& planner) {
    planner->setProblemDefinition(problem_);
    planner->setup();
    began_ = Stopwatch::now();
  }
  double elapsed() const {
    return std::chrono::duration<double>(Stopwatch::now() - began_).count();
  }
  bool done() const { return trial_.seconds.back() < kNever || elapsed() >= cap_; }
  ob::PlannerTerminationCondition until_done() const {
    return ob::PlannerTerminationCondition([this] { return done(); });
  }

  void note(double length) {
    const double now = elapsed();
    if (trial_.first_seconds == kNever) trial_.first_seconds = now;
    for (std::size_t i = 0; i < kGaps.size(); ++i) {
      if (length <= optimum_ * (1 + kGaps[i])) trial_.seconds[i] = std::min(trial_.seconds[i], now);
    }
  }

  double optimum_, cap_;
  std::shared_ptr<Space> space_;
  ob::SpaceInformationPtr information_;
  ob::ProblemDefinitionPtr problem_;
  Stopwatch::time_point began_;
  SamplingTrial trial_;
};

}  // namespace

std::span<const std::string_view> sampler_names() noexcept { return kNames; }

std::string ompl_version() { return "OMPL " LASIUS_OMPL_VERSION; }

SamplingTrial run_sampler(Sampler sampler, const Grid& grid, Cell start, Cell goal, double optimum,
                          double cap_seconds, std::uint32_t seed) {
  ompl::msg::noOutputHandler();  // it would print to stdout
  ompl::RNG::setSeed(seed);
  Trial trial(grid, start, goal, optimum, cap_seconds);
  const auto& information = trial.information();
  switch (sampler) {
    case Sampler::rrt_star:
      return trial.optimise(std::make_shared<og::RRTstar>(information));
    case Sampler::informed_rrt_star:
      return trial.optimise(std::make_shared<og::InformedRRTstar>(information));
    case Sampler::bit_star:
      return trial.optimise(std::make_shared<og::BITstar>(information));
    case Sampler::rrt_connect:
      break;
  }
  return trial.restart(std::make_shared<og::RRTConnect>(information), seed);
}

}  // namespace lasius::peers
