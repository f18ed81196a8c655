// Ctrl-C during a call of the library, which Python itself would see only when the call is over.
#pragma once

#include <cstdint>
#include <stop_token>

namespace lasius::python {

/// While it lives on the main thread, SIGINT asks the token to stop, besides what Python's own
/// handler does. On another thread, and where Python does not handle SIGINT, it does nothing.
/// They may be nested, as calls from callbacks are: the innermost is stopped.
///
/// The handler counts and posts a semaphore; a thread of the process, made by the first watch, does
/// the rest, since a stop token must not be used in a handler.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  std::stop_source& source() noexcept { return source_; }

 private:
  friend struct Watcher;
  bool on_main_thread_;
  std::uint64_t seen_ = 0;           ///< signals before this watch
  InterruptWatch* outer_ = nullptr;  ///< the one that this is nested in
  std::stop_source source_;
};

}  // namespace lasius::python
