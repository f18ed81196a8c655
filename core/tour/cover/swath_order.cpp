#include "core/tour/cover/swath_order.h"

namespace lasius::tour {

std::vector<int> whole_swaths(std::vector<int> order, const SwathPricer& swaths, bool open) {
  if (!open && order.size() > 2 && swaths.joined(order.front(), order.back()))
    std::rotate(order.begin(), order.begin() + 1, order.end());
  std::vector<char> seen(order.size(), 0);
  std::vector<int> whole;
  for (const int end : order) {
    if (seen[end]) continue;
    for (const int one : {end, end ^ 1}) {
      if (one != end && (one >= static_cast<int>(order.size()) || !swaths.joined(end, one)))
        continue;
      seen[one] = 1;
      whole.push_back(one);
    }
  }
  return whole;
}

}  // namespace lasius::tour
