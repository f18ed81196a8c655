#include "lasius/preparation.h"

namespace lasius {

std::string_view to_string(Preparation::State state) noexcept {
  switch (state) {
    case Preparation::State::none:
      return "none";
    case Preparation::State::ready:
      return "ready";
    case Preparation::State::too_large:
      return "too_large";
    case Preparation::State::stopped:
      return "stopped";
  }
  return "";
}

}  // namespace lasius
