#include "python/extension/interrupt.h"

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <thread>

namespace lasius::python {

/// What the watches of a process share with its handler and its thread. Never destroyed: the thread
/// waits until the process ends.
struct Watcher {
  Watcher() {
    ::sem_init(&raised, 0, 0);
    std::thread([this] { wait(); }).detach();
  }
  void wait();
  void add(InterruptWatch& watch);
  void remove(InterruptWatch& watch);

  const pid_t process = ::getpid();
  sem_t raised;
  std::atomic<std::uint64_t> signals = 0;
  std::mutex mutex;  ///< of what follows
  InterruptWatch* innermost = nullptr;
  struct sigaction before {};
  bool installed = false;
};

namespace {

Watcher* watcher = nullptr;

extern "C" void on_interrupt(int number, siginfo_t* info, void* context) {
  const int saved = errno;
  ++watcher->signals;
  ::sem_post(&watcher->raised);
  const struct sigaction& before = watcher->before;
  if ((before.sa_flags & SA_SIGINFO) != 0)
    before.sa_sigaction(number, info, context);
  else
    before.sa_handler(number);
  errno = saved;
}

bool is_ours(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 && action.sa_sigaction == on_interrupt;
}

bool has_handler(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 ||
         (action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN);
}

/// This process's: a fork copies no thread. One from within a call copies its handler.
Watcher& process_watcher() {
  if (watcher == nullptr || watcher->process != ::getpid()) {
    auto* const fresh = new Watcher;
    if (watcher != nullptr) {
      fresh->before = watcher->before;
      fresh->installed = watcher->installed;
    }
    watcher = fresh;
  }
  return *watcher;
}

}  // namespace

void Watcher::wait() {
  for (;;) {
    while (::sem_wait(&raised) != 0) {
    }
    const std::lock_guard lock(mutex);
    if (innermost != nullptr && signals != innermost->seen_) innermost->source_.request_stop();
  }
}

void Watcher::add(InterruptWatch& watch) {
  const std::lock_guard lock(mutex);
  watch.seen_ = signals;
  watch.outer_ = innermost;
  innermost = &watch;
  struct sigaction now {};
  ::sigaction(SIGINT, nullptr, &now);
  if (is_ours(now) || !has_handler(now)) return;
  before = now;
  now.sa_flags |= SA_SIGINFO;
  now.sa_sigaction = on_interrupt;
  installed = ::sigaction(SIGINT, &now, nullptr) == 0;
}

void Watcher::remove(InterruptWatch& watch) {
  const std::lock_guard lock(mutex);
  innermost = watch.outer_;
  if (innermost != nullptr || !installed) return;
  struct sigaction now {};
  ::sigaction(SIGINT, nullptr, &now);
  if (is_ours(now)) ::sigaction(SIGINT, &before, nullptr);  // else a callback has set another
  installed = false;
}

InterruptWatch::InterruptWatch() : on_main_thread_(::gettid() == ::getpid()) {
  if (on_main_thread_) process_watcher().add(*this);
}

InterruptWatch::~InterruptWatch() {
  if (on_main_thread_) watcher->remove(*this);
}

}  // namespace lasius::python
