// What a planner on a bitmap is asked.
#pragma once

#include "lasius/geometry.h"
#include "lasius/stop.h"

namespace lasius {

/// One question.
struct Request {
  Cell start;
  Cell goal;
  StopCondition stop = {};
  /// Stop at this certified gap, as a fraction, 0 or more; for certifying algorithms.
  double target_gap = 0;
};

}  // namespace lasius
