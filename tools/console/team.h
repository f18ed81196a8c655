// Work shared out over threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace lasius::tool {

/// Calls `worker(i)` once for every i below `count`, in rising order, on the calling thread and
/// `threads` - 1 others, or as many as the system has. Each thread has the worker that
/// `make_worker()` gives it there. What one throws comes out when the others have finished the
/// number they are at.
template <class MakeWorker>
void share_out(std::size_t count, int threads, const MakeWorker& make_worker) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr fault;
  const auto run = [&] {
    try {
      auto worker = make_worker();
      for (std::size_t i = next++; i < count; i = next++) worker(i);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!fault) fault = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> team;
    try {
      for (int t = 1; t < threads; ++t) team.emplace_back(run);
    } catch (const std::system_error&) {  // the system has no more: these do the work
    }
    run();
  }
  if (fault) std::rethrow_exception(fault);
}

}  // namespace lasius::tool
