#include "lasius/result.h"

#include <limits>

#include "lasius/progress.h"

namespace lasius {

Result::Result() : length(std::numeric_limits<double>::quiet_NaN()) {}

std::optional<double> Result::gap() const {
  if (!lower_bound || path.empty()) return std::nullopt;
  return length == 0 ? 0.0 : (length - *lower_bound) / *lower_bound;
}

Progress::~Progress() = default;

}  // namespace lasius
