#include "core/loop/batch_run.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/params/parameter_table.h"

namespace lasius {
namespace {

void check(const BatchOptions& options, std::uint64_t seed) {
  check_threads(options.threads);
  const double limit = options.time_limit ? options.time_limit->count() : 0;
  require_parameter(limit >= 0, "time_limit", limit, "it must be 0 or more seconds, or none");
  require_parameter(options.seeds >= 1 && options.seeds <= 1 << 20, "seeds", options.seeds,
                    "it must be from 1 to 1048576");
  check_seed(seed + static_cast<std::uint64_t>(options.seeds) - 1);
}

/// A token that asks to stop when either of two does.
class EitherToken {
 public:
  EitherToken(const std::stop_token& a, const std::stop_token& b)
      : first_(a, Relay{source_}), second_(b, Relay{source_}) {}
  std::stop_token get() const noexcept { return source_.get_token(); }

 private:
  struct Relay {
    std::stop_source& source;
    void operator()() const { source.request_stop(); }
  };
  std::stop_source source_;
  std::stop_callback<Relay> first_, second_;
};

/// Hands out tasks in order, and gives their answers on in order.
class Sequencer {
 public:
  Sequencer(std::size_t count, std::size_t window, const std::stop_token& token)
      : count_(count), link_(token, [this] { stop_.request_stop(); }), waiting_(window) {}

  std::stop_token token() const noexcept { return stop_.get_token(); }

  /// The next task to begin, or nothing. Waits while it is too far ahead of the oldest answer.
  std::optional<std::size_t> next() {
    std::unique_lock lock(mutex_);
    moved_.wait(lock, [this] { return begun_ - received_ < waiting_.size() || fault_; });
    if (begun_ == count_ || stop_.stop_requested()) return std::nullopt;
    return begun_++;
  }

  void finish(std::size_t task, std::function<void()> give) {
    std::unique_lock lock(mutex_);
    waiting_[task % waiting_.size()] = std::move(give);
    if (!receiving_) give_on(lock);
  }

  void fail(std::exception_ptr fault) {
    const std::lock_guard lock(mutex_);
    note(std::move(fault));
    moved_.notify_all();
  }

  std::size_t result() const {
    if (fault_) std::rethrow_exception(fault_);
    return received_;
  }

 private:
  /// Keeps the first fault, and stops what is in flight.
  void note(std::exception_ptr fault) {
    if (!fault_) fault_ = std::move(fault);
    stop_.request_stop();
  }

  /// Gives on what is complete, without the lock, so that the others plan meanwhile.
  void give_on(std::unique_lock<std::mutex>& lock) {
    receiving_ = true;
    while (auto& slot = waiting_[received_ % waiting_.size()]) {
      if (fault_) break;
      const auto give = std::exchange(slot, {});
      lock.unlock();
      std::exception_ptr fault;
      try {
        give();
      } catch (...) {
        fault = std::current_exception();
      }
      lock.lock();
      if (fault)
        note(std::move(fault));
      else
        ++received_;
      moved_.notify_all();
    }
    receiving_ = false;
  }

  const std::size_t count_;
  std::stop_source stop_;
  const std::stop_callback<std::function<void()>> link_;
  std::mutex mutex_;
  std::condition_variable moved_;
  std::size_t begun_ = 0;
  std::size_t received_ = 0;
  bool receiving_ = false;
  std::exception_ptr fault_;
  std::vector<std::function<void()>> waiting_;  // ring: task modulo its size
};

}  // namespace

std::size_t run_tasks(std::size_t requests, std::uint64_t seed, const BatchOptions& options,
                      const std::function<StopCondition(std::size_t)>& stop_of,
                      const std::function<BatchWorker()>& make_worker) {
  check(options, seed);
  const auto seeds = static_cast<std::size_t>(options.seeds);
  const std::size_t tasks = requests * seeds;
  // A worker without a task would still make all that a plan works with.
  const int threads = static_cast<int>(
      std::clamp<std::size_t>(tasks, 1, static_cast<std::size_t>(thread_count(options.threads))));
  Sequencer sequencer(tasks, 64 + 8 * static_cast<std::size_t>(threads), options.token);

  const auto work = [&] {
    const BatchWorker worker = make_worker();
    while (const auto number = sequencer.next()) {
      BatchTask task{*number / seeds, seed + *number % seeds, stop_of(*number / seeds)};
      std::optional<EitherToken> either;
      if (task.stop.token.stop_possible()) either.emplace(task.stop.token, sequencer.token());
      task.stop.token = either ? either->get() : sequencer.token();
      if (options.time_limit) {
        task.stop.deadline =
            std::min(task.stop.deadline, deadline_in(*options.time_limit, task.stop.now()));
      }
      sequencer.finish(*number, worker(task));
    }
  };
#pragma omp parallel num_threads(region_threads(threads))
  {
    try {
      work();
    } catch (...) {
      sequencer.fail(std::current_exception());
    }
  }
  return sequencer.result();
}

}  // namespace lasius
