// How a search ended.
#pragma once

#include <string_view>

#include "lasius/export.h"

namespace lasius {

/// How a plan ended: outcomes, not errors.
enum class Status {
  solved,       ///< the algorithm ended by its own rule, with a path
  limit,        ///< a Limit ended it; the best so far
  interrupted,  ///< the stop token or an observer ended it; the best path so far, if any
  unreachable,  ///< proven: no path exists
  no_path,      ///< none was found, none is proven impossible
  invalid,      ///< start or goal outside or blocked
};
/// The name, as in "no_path".
LASIUS_EXPORT std::string_view to_string(Status status) noexcept;

/// What ended a plan, a motion's making or a drive as Status::limit.
enum class Limit {
  none,       ///< it ended otherwise
  time,       ///< a deadline
  questions,  ///< of an arm's sensor: arm::Params::max_questions, TrajectoryOptions::max_questions
  ticks,      ///< DriveOptions::max_ticks
};
/// The name, as in "ticks".
LASIUS_EXPORT std::string_view to_string(Limit limit) noexcept;

/// Why a request is invalid or its goal unreachable.
enum class Fault {
  none,
  start_outside,  ///< of the map, the boundary or the joint limits
  start_blocked,  ///< by an obstacle; an arm touches something
  goal_outside,   ///< of the map or the boundary, or out of an arm's reach
  goal_blocked,   ///< by an obstacle; an arm touches something
  disconnected,   ///< proven: no path leads from start to goal
  trapped,        ///< of a drive: moving obstacles stand in the way for good
};
/// The name, as in "start_outside".
LASIUS_EXPORT std::string_view to_string(Fault fault) noexcept;

}  // namespace lasius
