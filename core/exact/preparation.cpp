#include "lasius/plan/preparation.h"

#include "lasius/base/enum_names.h"

namespace lasius {

std::string_view to_string(Preparation::State state) noexcept {
  static constexpr std::array<std::string_view, 4> kNames{"none", "ready", "too_large", "stopped"};
  return name_of(state, kNames);
}

}  // namespace lasius
