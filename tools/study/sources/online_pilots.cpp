#include "tools/study/sources/online_pilots.h"

namespace lasius::study {

void ForgetfulPilot::observe(const Rectangle& part, bool blocked) {
  navigator_.observe(part, blocked);
  changed_ = true;
}
void ForgetfulPilot::observe(std::span<const Cell> cells, bool blocked) {
  navigator_.observe(cells, blocked);
  changed_ = changed_ || !cells.empty();
}
const Way& ForgetfulPilot::step(Cell robot, const StopCondition& stop) {
  if (changed_) navigator_.forget();
  changed_ = false;
  return navigator_.step(robot, stop);
}

}  // namespace lasius::study
