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

}  // namespace lasius
