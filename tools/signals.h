// SIGINT and SIGTERM as a stop token.
#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace lasius::tool {

/// While it lives, the first SIGINT or SIGTERM asks the token to stop and a second one ends the
/// program at once. The handler itself only writes one byte to a pipe; a thread does the rest.
/// One at a time.
class SignalWatcher {
 public:
  SignalWatcher();
  ~SignalWatcher();
  SignalWatcher(const SignalWatcher&) = delete;
  SignalWatcher& operator=(const SignalWatcher&) = delete;

  std::stop_token token() const noexcept { return source_.get_token(); }
  bool interrupted() const noexcept { return source_.stop_requested(); }

 private:
  int pipe_[2];
  struct sigaction old_interrupt_ {};
  struct sigaction old_terminate_ {};
  std::stop_source source_;
  std::thread waiter_;
};

}  // namespace lasius::tool
