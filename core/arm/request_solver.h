// One request on its way to a result: checks, the straight line, then two trees or a lattice.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/arm/lattice.h"
#include "lasius/arm/plan.h"

namespace lasius::arm {

class RequestSolver {
 public:
  /// Plans in one lattice.
  using Search = std::function<Result(Lattice&, const Params&)>;

  /// @throws Error(invalid_parameter) as `plan` does. Robot and sensor must outlive it. The
  /// request is copied; values outside a limit by Request::kLimitTolerance at most are moved to it.
  RequestSolver(const Robot& robot, const Sensor& sensor, const Request& request,
                const Params& given);

  /// The result; `search` is called where a lattice is needed.
  Result solve(const Search& search);

  const Request& request() const noexcept { return request_; }

 private:
  Result reach_goals(const Search& search);
  /// The result where goal `goal` is reached at the start.
  Result stay_at_goal(int goal) const;
  bool position_free(const JointVector& q);
  /// True when told to stop, or when no question is left.
  bool ended() { return cause() != StopCondition::Cause::none; }
  /// Why to end; `deadline` also where no question is left, which sets out_of_questions_.
  StopCondition::Cause cause();
  /// True where the lattice has a point that is moved onto the goal.
  bool is_point(int g) const { return request_.goals[g].kind == Goal::Kind::position; }
  /// Fills ends_ with free postures that reach the goals. A result where the search can end here:
  /// a straight line is free, or all postures touch something.
  std::optional<Result> find_targets();
  /// Of ends_; a result where the straight joint-space line to one is free.
  std::optional<Result> drop_blocked_ends();
  /// False where some posture at the goals is free, or there was no time to look for one.
  bool every_posture_blocked();
  Result grow_trees();
  Vec3 tip_of(const JointVector& q) const;
  /// The length of a straight line in the unit of the objective; of `length` pitch times the
  /// lattice moves between the tips, or times the joint steps where those are more.
  double line_length(const JointVector& a, const JointVector& b) const;
  Result straight_line_result(const End& end) const;
  Targets targets_at(double pitch) const;
  Result search_lattice(const Search& search);
  /// The answer where no posture reaches a goal, as far as it is known.
  Result no_ends();
  /// Pitch and points of the lattice, where none was laid out.
  void fill_lattice_fields(Result& result) const;

  const Robot& robot_;
  const Sensor& sensor_;
  Request request_;
  Params parameters_;
  std::optional<Kinematics> arm_;
  Vec3 from_;
  std::vector<int> goals_;          // of the request, those not proven out of reach
  std::vector<End> ends_;           // postures that reach them
  std::vector<std::string> notes_;  // on what of the request was changed
  Questions asked_;
  bool out_of_questions_ = false;
};

}  // namespace lasius::arm
