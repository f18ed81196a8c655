// One question under way: what is checked before a lattice is laid out, and the lattices.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/arm/lattice.h"
#include "lasius/arm_plan.h"

namespace lasius::arm {

class Inquiry {
 public:
  /// Answers a question in one lattice.
  using Search = std::function<Result(const Lattice&, const Params&)>;

  /// @throws Error(invalid_parameter) as `plan` does. All are read as long as it is there.
  /// The request is kept with start and joint goals within the limits that they miss by a hair.
  Inquiry(const Robot& robot, const Sensor& sensor, const Request& request, const Params& given);

  /// Has the question answered, by `search` once for each pitch where it comes to that.
  Result answer(const Search& search);

  const Request& request() const noexcept { return request_; }

 private:
  Result to_goals(const Search& search);
  /// The answer where a goal is the start.
  Result stay(int goal) const;
  bool position_free(const JointVector& q);
  /// True when nothing more is to be asked: told to stop, or no question is left.
  bool ended() { return cause() != StopCondition::Cause::none; }
  /// Questions that are spent count as a deadline; that it was they is noted.
  StopCondition::Cause cause();
  /// True where the goal is a lattice point moved onto it.
  bool is_point(int g) const { return request_.goals[g].kind == Goal::Kind::position; }
  /// Postures that reach the goals, and the straight lines to them. An answer where there is one
  /// already.
  std::optional<Result> find_targets();
  /// Drops the ends that are not free. The answer, where a straight line to one is.
  std::optional<Result> keep_free();
  /// False where some posture at the goals is free, or there was no time to look for one.
  bool all_touch();
  /// The straight joint-space line. Its length is the moves that the tip would need, or the joint
  /// steps where those are more.
  Result along_line(const End& end) const;
  Targets targets_at(double pitch) const;
  Result search_lattices(const Search& search);
  /// The lattice that was, or would have been, laid out first.
  void tell_lattice(Result& result) const;
  /// Those of the ends, then others in which the tip is where it starts.
  void add_postures(Lattice& lattice) const;

  const Robot& robot_;
  const Sensor& sensor_;
  Request request_;
  Params parameters_;
  std::optional<Kinematics> arm_;
  Vec3 from_;
  std::vector<int> goals_;  // that are not proven out of reach
  std::vector<End> ends_;
  std::vector<std::string> notes_;  // of the request
  Questions asked_;
  bool questions_ended_it_ = false;
};

}  // namespace lasius::arm
