#include "lasius/status.h"

namespace lasius {

std::string_view to_string(Status status) noexcept {
  switch (status) {
    case Status::solved:
      return "solved";
    case Status::limit:
      return "limit";
    case Status::interrupted:
      return "interrupted";
    case Status::unreachable:
      return "unreachable";
    case Status::no_path:
      return "no_path";
    case Status::invalid:
      return "invalid";
  }
  return "";
}

std::string_view to_string(Fault fault) noexcept {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::start_outside:
      return "start_outside";
    case Fault::start_blocked:
      return "start_blocked";
    case Fault::goal_outside:
      return "goal_outside";
    case Fault::goal_blocked:
      return "goal_blocked";
    case Fault::disconnected:
      return "disconnected";
  }
  return "";
}

}  // namespace lasius
