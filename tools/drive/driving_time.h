// The clock of a drive.
#pragma once

#include "lasius/stop.h"

namespace lasius::tool {

/// The time of a drive: it stands still while the drive is watched or drawn.
class DrivingTime final : public TimeSource {
 public:
  Clock::time_point now() const noexcept override { return Clock::now() - paused_; }
  void pause() noexcept { since_ = Clock::now(); }
  void go_on() noexcept { paused_ += Clock::now() - since_; }

 private:
  Clock::time_point since_{};
  Clock::duration paused_{};
};

}  // namespace lasius::tool
