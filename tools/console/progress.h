// One line on a terminal that says how far a run is.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "tools/options/options.h"

namespace lasius::tool {

/// True where progress is to be shown: asked for, or standard error is a terminal.
bool wants_progress(const Messages& messages);

/// Redraws itself at most ten times a second; wiped when it goes.
class ProgressLine {
 public:
  /// `total` 0: not known, the time goes instead. `limit_seconds`: a run ends then at the latest;
  /// 0: no limit.
  ProgressLine(bool shown, std::int64_t total, double limit_seconds = 0);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `done` of the total; `note` is shown behind the bar.
  void update(std::int64_t done, const std::string& note);

 private:
  using Clock = std::chrono::steady_clock;
  bool shown_;
  bool drawn_ = false;
  std::int64_t total_;
  double limit_seconds_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
};

}  // namespace lasius::tool
