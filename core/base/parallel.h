// Work over threads.
#pragma once

#include <atomic>
#include <exception>

#include "core/base/thread_team.h"

namespace lasius {

/// The threads asked for, or where that is 0 as many as OpenMP gives, which may be any number that
/// OMP_NUM_THREADS says; 1024 at most, as of those asked for.
LASIUS_EXPORT int thread_count(int wanted) noexcept;

/// Calls body(i, thread) once for every i below `count`, begun in rising order, on up to `threads`
/// threads; `thread`, from 0, is the number of the one that calls. Where a call throws, no other
/// begins once the exception is noted, and one such exception is thrown on when those under way
/// have ended. On a thread that leads a team, the team does it.
template <class Body>
void parallel_for(int count, int threads, const Body& body) {
  ThreadTeam* const team = ThreadTeam::led_here();
  if (team == nullptr && count > 1) threads = region_threads(threads);
  if (threads <= 1 || count <= 1) {  // a team of one would cost more than a short walk
    for (int i = 0; i < count; ++i) body(i, 0);
    return;
  }
  std::exception_ptr error;
  std::atomic<bool> failed{false};
  const auto call = [&](int i, int thread) noexcept {
    if (failed) return;
    try {
      body(i, thread);
    } catch (...) {
      if (!failed.exchange(true)) error = std::current_exception();
    }
  };
  using Call = decltype(call);
  const ThreadTeam::LoopBody loop_body = [](const void* context, int i, int thread) noexcept {
    (*static_cast<const Call*>(context))(i, thread);
  };
  if (team != nullptr)
    team->share(count, threads, loop_body, &call);
  else
    ThreadTeam::share_once(count, threads, loop_body, &call);
  if (error) std::rethrow_exception(error);
}

}  // namespace lasius
