#include "core/loop/batch_run.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>

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

/// Gives the answers of tasks on in their order; what throws stops the tasks under way.
class OrderedAnswers {
 public:
  OrderedAnswers(std::size_t window, const std::stop_token& token)
      : waiting_(window), link_(token, [this] { end(); }) {}

  std::stop_token token() const noexcept { return stop_.get_token(); }

  /// Waits while the task is too far ahead of the oldest answer; false where it need not begin.
  bool await(std::size_t task) {
    std::unique_lock lock(mutex_);
    moved_.wait(lock, [&] { return task - received_ < waiting_.size() || stop_.stop_requested(); });
    return !stop_.stop_requested();
  }

  void finish(std::size_t task, std::function<void()> give) {
    std::unique_lock lock(mutex_);
    waiting_[task % waiting_.size()] = std::move(give);
    if (!receiving_) give_on(lock);
  }

  /// Stops what is under way, and lets nothing more be given on.
  void fail() {
    failed_ = true;
    end();
  }

  std::size_t received() const noexcept { return received_; }

 private:
  void end() {
    const std::lock_guard lock(mutex_);
    stop_.request_stop();
    moved_.notify_all();
  }

  /// Gives on what is complete, without the lock, so that the others plan meanwhile. What `give`
  /// throws leaves `receiving_`: nothing is given on after it.
  void give_on(std::unique_lock<std::mutex>& lock) {
    receiving_ = true;
    while (auto& slot = waiting_[received_ % waiting_.size()]) {
      if (failed_) break;
      const auto give = std::exchange(slot, {});
      lock.unlock();
      give();
      lock.lock();
      ++received_;
      moved_.notify_all();
    }
    receiving_ = false;
  }

  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable moved_;
  std::size_t received_ = 0;
  bool receiving_ = false;
  std::atomic<bool> failed_ = false;
  std::vector<std::function<void()>> waiting_;  // ring: task modulo its size
  const std::stop_callback<std::function<void()>> link_;
};

}  // namespace

std::size_t run_tasks(std::size_t requests, std::uint64_t seed, const BatchOptions& options,
                      const std::function<StopCondition(std::size_t)>& stop_of,
                      const std::function<BatchWorker()>& make_worker) {
  check(options, seed);
  const auto seeds = static_cast<std::size_t>(options.seeds);
  const std::size_t tasks = requests * seeds;
  // A thread without a task would still make all that a plan works with.
  const int threads = static_cast<int>(
      std::clamp<std::size_t>(tasks, 1, static_cast<std::size_t>(thread_count(options.threads))));
  std::vector<BatchWorker> workers(static_cast<std::size_t>(threads));
  OrderedAnswers answers(64 + 8 * workers.size(), options.token);
  const auto work = [&](std::size_t number, BatchWorker& worker) {
    if (!answers.await(number)) return;
    if (!worker) worker = make_worker();
    BatchTask task{number / seeds, seed + number % seeds, stop_of(number / seeds)};
    std::optional<EitherToken> either;
    if (task.stop.token.stop_possible()) either.emplace(task.stop.token, answers.token());
    task.stop.token = either ? either->get() : answers.token();
    if (options.time_limit) {
      task.stop.deadline =
          std::min(task.stop.deadline, deadline_in(*options.time_limit, task.stop.now()));
    }
    answers.finish(number, worker(task));
  };
  // parallel_for counts in int.
  constexpr std::size_t kMost = 1 << 30;
  for (std::size_t first = 0; first < tasks; first += kMost) {
    parallel_for(static_cast<int>(std::min(kMost, tasks - first)), threads, [&](int i, int thread) {
      try {
        work(first + static_cast<std::size_t>(i), workers[static_cast<std::size_t>(thread)]);
      } catch (...) {
        answers.fail();
        throw;
      }
    });
  }
  return answers.received();
}

}  // namespace lasius
