// How a run ended that was, or was not, cut short.
#pragma once

#include "lasius/planner.h"
#include "lasius/stop.h"

namespace lasius {

/// The status of a run that `cause` cut short; `otherwise` where nothing did.
constexpr Status status_after(StopCondition::Cause cause, Status otherwise) noexcept {
  switch (cause) {
    case StopCondition::Cause::deadline:
      return Status::limit;
    case StopCondition::Cause::token:
      return Status::interrupted;
    case StopCondition::Cause::none:
      break;
  }
  return otherwise;
}

}  // namespace lasius
