// What is told beside a start or goal that does not serve.
#pragma once

#include <optional>
#include <string>

namespace lasius {

/// Goes on with a sentence about such an end: which free cell is nearest, and which of those that
/// are joined to the other end.
/// @param reachable  empty where that is not known
inline std::string nearest_text(bool at_start, const std::string& free,
                                const std::optional<std::string>& reachable) {
  const std::string nearest = "; the nearest free cell ";
  if (!reachable || *reachable == free) return nearest + "is " + free;
  return nearest + (at_start ? "from which the goal" : "that") + " can be reached" +
         (at_start ? "" : " from the start") + " is " + *reachable + "; " + free +
         " is nearer, but " + (at_start ? "does not lead there" : "cannot be reached");
}

}  // namespace lasius
