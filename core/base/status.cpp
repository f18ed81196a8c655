#include "lasius/base/status.h"

#include "lasius/base/enum_names.h"

namespace lasius {

std::string_view to_string(Status status) noexcept {
  static constexpr std::array<std::string_view, 6> kNames{"solved",      "limit",   "interrupted",
                                                          "unreachable", "no_path", "invalid"};
  return name_of(status, kNames);
}

std::string_view to_string(Limit limit) noexcept {
  static constexpr std::array<std::string_view, 4> kNames{"none", "time", "questions", "ticks"};
  return name_of(limit, kNames);
}

std::string_view to_string(Fault fault) noexcept {
  static constexpr std::array<std::string_view, 7> kNames{
      "none",         "start_outside", "start_blocked", "goal_outside",
      "goal_blocked", "disconnected",  "trapped"};
  return name_of(fault, kNames);
}

}  // namespace lasius
