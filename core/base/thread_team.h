// Threads that stand by for the parallel loops of one run.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "lasius/export.h"

namespace lasius {

/// How many threads a parallel region that is about to begin may have: `wanted`, or fewer where the
/// system has no more, but 1 in a process that was forked from one that had such regions. GNU's
/// OpenMP runtime would wait there for threads that a fork does not copy.
LASIUS_EXPORT int region_threads(int wanted) noexcept;

/// The threads of one OpenMP region, kept over many loops. One of them leads; it never waits for a
/// thread that has not begun, so that on a busy machine a loop takes no longer than on one thread.
/// (At the end of a region of its own OpenMP waits for all, for milliseconds without giving up its
/// core, even to one of them.) Used through parallel_for.
class ThreadTeam {
 public:
  /// Calls run() on this thread; parallel_for in it shares its loops with up to `threads` - 1
  /// others. Throws what `run` throws.
  LASIUS_EXPORT static void lead(int threads, const std::function<void()>& run);

  /// The team that this thread leads, or null.
  LASIUS_EXPORT static ThreadTeam* led_here() noexcept;

  /// Calls body(context, i, member) for every i below `count` on up to `members` threads, the
  /// leader's number being 0. The body must not throw. Meanwhile the leader leads nobody: a loop
  /// within the body is not the team's.
  using LoopBody = void (*)(const void* context, int i, int member) noexcept;
  LASIUS_EXPORT void share(int count, int members, LoopBody body, const void* context) noexcept;

  /// Calls `body` on a thread that leads no team, in a region that OpenMP makes for this loop.
  LASIUS_EXPORT static void share_once(int count, int threads, LoopBody body,
                                       const void* context) noexcept;

 private:
  static ThreadTeam* appoint(ThreadTeam* team) noexcept;  ///< returns the one before
  void serve(int member) noexcept;
  void dismiss() noexcept;
  void take(int member) noexcept;

  // Written by the leader while nobody is inside.
  LoopBody body_ = nullptr;
  const void* context_ = nullptr;
  int count_ = 0;
  int members_ = 0;
  bool dismissed_ = false;

  alignas(64) std::atomic<std::uint32_t> round_{0};  ///< odd while a loop is open
  alignas(64) std::atomic<int> next_{0};
  alignas(64) std::atomic<int> inside_{0};
};

}  // namespace lasius
