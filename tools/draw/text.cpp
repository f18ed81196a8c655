#include "tools/draw/text.h"

#include <cmath>

#include "tools/console/values.h"

namespace lasius::tool {

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  const std::string text = printed("%.*f", decimals, value);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string p_text(double p) { return p < 0.001 ? "< 0.001" : fixed(p, 3); }

std::string seconds_text(double seconds) {
  if (!(seconds > 0)) return fixed(seconds, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(seconds)));
  return fixed(seconds, std::max(0, std::min(decimals, 5)));
}

std::string against(double length, double optimum, const std::string& name,
                    const std::string& shown) {
  const double gap = 100 * (length / optimum - 1), size = std::abs(gap);
  if (!std::isfinite(gap)) return {};
  const std::string how =
      size < 1e-6 ? "equal to"
                  : fixed(size, size < 0.01 ? 5 : 2) + (gap < 0 ? "% below" : "% above");
  return ", " + how + " the " + name + " " + shown;
}

std::string no_path_text(Status status) {
  switch (status) {
    case Status::limit:
      return "no path within the time limit";
    case Status::interrupted:
      return "no path before the interruption";
    case Status::unreachable:
      return "no path: the goal is unreachable, proven";
    case Status::invalid:
      return "no path: start or goal is outside or blocked";
    case Status::solved:
    case Status::no_path:
      break;
  }
  return "no path found in all iterations";
}

}  // namespace lasius::tool
