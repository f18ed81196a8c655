#include "core/base/thread_team.h"

#include <omp.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace lasius {
namespace {

thread_local ThreadTeam* led = nullptr;

// Some 10 to 50 microseconds: longer than from one loop of an iteration to the next.
constexpr int kSpins = 1000;

void pause() noexcept {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until it is no longer `value`: looks for a while, then sleeps.
template <class T>
void await_change(const std::atomic<T>& what, T value) noexcept {
  for (int i = 0; i < kSpins; ++i) {
    if (what.load() != value) return;
    pause();
  }
  what.wait(value);
}

std::atomic<pid_t> region_process = 0;  // the one that had the first parallel region

/// Of so many threads those that the system has room for. An OpenMP runtime that gets fewer than it
/// wants ends the process, so they are tried before; by threads that touch no heap, as one that
/// only frees has malloc set aside an arena of 64 MB, and the room counted would not be there
/// afterwards. Where addresses are limited, room for an arena each, as malloc makes them for the
/// first 8 a core, is theirs, too.
int available(int wanted) noexcept {
  thread_local int had = 1;  // a region's threads stay for the next one of this thread
  if (wanted <= had) return wanted;
  std::atomic<bool> counted{false};
  const auto wait = [](void* until) -> void* {
    static_cast<const std::atomic<bool>*>(until)->wait(false);
    return nullptr;
  };
  std::vector<pthread_t> tried;
  try {
    tried.reserve(static_cast<std::size_t>(wanted - had));
  } catch (const std::bad_alloc&) {
    return had;
  }
  constexpr std::size_t kArena = 64 << 20;
  std::size_t stack = 0;
  pthread_attr_t roomy;
  pthread_attr_init(&roomy);
  pthread_attr_getstacksize(&roomy, &stack);
  pthread_attr_setstacksize(&roomy, stack + kArena);
  rlimit addresses{};
  const bool limited = getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY;
  const std::ptrdiff_t with_arena = limited ? std::ptrdiff_t{8} * omp_get_num_procs() : 0;
  const auto room = [&] { return had + std::ssize(tried) <= with_arena ? &roomy : nullptr; };
  pthread_t one{};
  while (std::ssize(tried) < wanted - had && pthread_create(&one, room(), wait, &counted) == 0)
    tried.push_back(one);
  pthread_attr_destroy(&roomy);
  counted = true;
  counted.notify_all();
  for (const pthread_t ended : tried) pthread_join(ended, nullptr);
  const int found = static_cast<int>(std::ssize(tried));
  // The last of what there is stays for others.
  if (had + found < wanted) return std::max(had, (had + found) / 2);
  return had = wanted;
}

}  // namespace

int thread_count(int wanted) noexcept {
  return wanted > 0 ? wanted : std::min(omp_get_max_threads(), 1024);
}

int region_threads(int wanted) noexcept {
  if (wanted <= 1) return wanted;
  const pid_t here = getpid();
  pid_t first = 0;
  const bool ours = region_process.compare_exchange_strong(first, here) || first == here;
  return ours ? available(wanted) : 1;
}

void ThreadTeam::lead(int threads, const std::function<void()>& run) {
  threads = region_threads(threads);
  if (threads <= 1) return run();
  ThreadTeam team;
  std::exception_ptr error;
#pragma omp parallel num_threads(threads)
  {
    if (const int member = omp_get_thread_num(); member > 0) {
      team.serve(member);
    } else {
      ThreadTeam* const before = appoint(&team);
      try {
        run();
      } catch (...) {  // none may leave the parallel region
        error = std::current_exception();
      }
      appoint(before);
      team.dismiss();
    }
  }
  if (error) std::rethrow_exception(std::move(error));
}

void ThreadTeam::share_once(int count, int threads, LoopBody body, const void* context) noexcept {
// Monotonic: a batch's tasks wait for answers of earlier ones.
#pragma omp parallel for schedule(monotonic : dynamic) num_threads(threads)
  for (int i = 0; i < count; ++i) body(context, i, omp_get_thread_num());
}

ThreadTeam* ThreadTeam::led_here() noexcept { return led; }

ThreadTeam* ThreadTeam::appoint(ThreadTeam* team) noexcept { return std::exchange(led, team); }

void ThreadTeam::take(int member) noexcept {
  for (int i; (i = next_.fetch_add(1, std::memory_order_relaxed)) < count_;) {
    body_(context_, i, member);
  }
}

// A member enters, then looks whether the loop is still open; the leader closes it, then looks who
// is inside. All four in one order (sequential consistency): one of the two sees the other.

void ThreadTeam::share(int count, int members, LoopBody body, const void* context) noexcept {
  body_ = body;
  context_ = context;
  count_ = count;
  members_ = members;
  next_.store(0, std::memory_order_relaxed);
  ++round_;
  round_.notify_all();
  appoint(nullptr);
  take(0);
  appoint(this);
  ++round_;
  for (int inside; (inside = inside_.load()) != 0;) await_change(inside_, inside);
}

void ThreadTeam::serve(int member) noexcept {
  for (std::uint32_t seen = 0;;) {
    await_change(round_, seen);
    seen = round_.load();
    if (seen % 2 == 0) continue;  // closed again
    ++inside_;
    bool done = false;
    if (round_.load() == seen) {
      done = dismissed_;
      if (!done && member < members_) take(member);
    }
    if (--inside_ == 0) inside_.notify_one();
    if (done) return;
  }
}

void ThreadTeam::dismiss() noexcept {
  dismissed_ = true;
  ++round_;
  round_.notify_all();
}

}  // namespace lasius
