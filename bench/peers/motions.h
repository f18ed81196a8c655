// Motions that OMPL asks about, judged by a function.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include <utility>

namespace lasius::peers {

/// `free(from, to)` says whether a motion is free.
template <typename Free>
class Motions final : public ompl::base::MotionValidator {
  using State = ompl::base::State;

 public:
  Motions(const ompl::base::SpaceInformationPtr& space, Free free)
      : MotionValidator(space), free_(free) {}
  bool checkMotion(const State* a, const State* b) const override { return free_(a, b); }
  // Planners that ask how far a motion is free get its middle, where that helps.
  bool checkMotion(const State* a, const State* b, std::pair<State*, double>& last) const override {
    if (free_(a, b)) return true;
    last.second = 0;
    if (last.first != nullptr) si_->copyState(last.first, a);
    return false;
  }

 private:
  Free free_;
};

}  // namespace lasius::peers
