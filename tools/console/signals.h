// SIGINT, SIGTERM, SIGHUP and SIGQUIT: the end of the program, or a stop token.
#pragma once

#include <atomic>
#include <deque>
#include <stop_token>
#include <string>
#include <thread>

namespace lasius::tool {

/// From here on SIGINT, SIGTERM and SIGHUP end the program at once with exit code 130: right where
/// nothing is being written. SIGQUIT ends it as it does any program. No temporary file is left. A
/// SIGHUP or SIGQUIT that was ignored stays so.
void end_on_signals();

/// While it lives, the first of SIGINT, SIGTERM and SIGHUP asks the token to stop instead, and only
/// a second signal, or one while a named pipe waits for its other end, ends the program at once.
/// The handler itself only writes one byte to a pipe; a thread does the rest. One at a time.
/// Precondition: end_on_signals was called. So it lives where the token is polled: elsewhere the
/// first signal is to end the program.
class SignalWatcher {
 public:
  SignalWatcher();  ///< @throws std::system_error where the system has no pipe or thread left
  ~SignalWatcher();
  SignalWatcher(const SignalWatcher&) = delete;
  SignalWatcher& operator=(const SignalWatcher&) = delete;

  std::stop_token token() const noexcept { return source_.get_token(); }
  bool interrupted() const noexcept;  ///< from the signal on, perhaps just before the token

 private:
  int pipe_[2];
  std::stop_source source_;
  std::thread waiter_;
};

/// While it lives, a signal ends the program at once though a SignalWatcher lives, too: for work
/// that polls nothing, and whose files are whole or not there.
class EndAtOnce {
 public:
  EndAtOnce() noexcept;
  ~EndAtOnce();
  EndAtOnce(const EndAtOnce&) = delete;
  EndAtOnce& operator=(const EndAtOnce&) = delete;
};

/// While it lives, a signal that ends the program at once has it say "lasius: TEXT" on standard
/// error, the last one made first: what it then leaves undone. They end in the order opposite to
/// that of their making.
class LastWords {
 public:
  explicit LastWords(const std::string& text = {});
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

  void change(const std::string& text);  ///< nothing is said where it is empty
  void say() const noexcept;             ///< what signal handlers may call: all that live

 private:
  std::deque<std::string> lines_;  ///< all live on: a signal may come at any moment
  std::atomic<const std::string*> line_ = nullptr;
  const LastWords* before_;
};

}  // namespace lasius::tool
