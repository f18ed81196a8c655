// The clocks of the benchmarks.
#pragma once

#include <chrono>
#include <ctime>
#include <utility>
#include <vector>

#include "bench/statistics.h"
#include "lasius/base/stop.h"

namespace lasius::bench {

/// Wall clock, from its construction.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  double microseconds() const { return 1e6 * seconds(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Processor time, from its construction: what other programs do does not count.
template <clockid_t kClock>
class ProcessorClock {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    std::timespec t{};
    clock_gettime(kClock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  double start_ = now();
};
using ProcessorStopwatch = ProcessorClock<CLOCK_PROCESS_CPUTIME_ID>;  ///< of all threads
using ThreadStopwatch = ProcessorClock<CLOCK_THREAD_CPUTIME_ID>;      ///< of this one

/// This thread's processor time as what a deadline is told by, from its construction.
class ThreadTime : public TimeSource {
 public:
  Clock::time_point now() const noexcept override {
    return Clock::time_point{} +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(used()));
  }
  double used() const noexcept { return watch_.seconds(); }  ///< seconds

 private:
  ThreadStopwatch watch_;
};

/// Microseconds of processor time that a call takes: the median of so many.
template <class Call>
double median_microseconds(int rounds, const Call& call) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    const ThreadStopwatch watch;
    call();
    times.push_back(1e6 * watch.seconds());
  }
  return median(std::move(times));
}

}  // namespace lasius::bench
