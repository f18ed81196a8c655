#include "tools/console/signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "core/base/opening_pipe.h"
#include "core/base/output.h"
#include "core/base/printable.h"
#include "tools/console/exit_code.h"

namespace lasius::tool {
namespace {

constexpr char kStop = 's';
constexpr char kQuit = 'q';

volatile std::sig_atomic_t write_end = -1;
volatile std::sig_atomic_t signals_seen = 0;
volatile std::sig_atomic_t nobody_polls = 0;
std::atomic<const LastWords*> last_words = nullptr;
static_assert(decltype(last_words)::is_always_lock_free, "signal handlers read it");

/// Ends the program, with no half-written file left behind; by SIGQUIT as the system does, which
/// may save its memory for a debugger.
void end_at_once(int number) {
  abandon_outputs();
  if (const LastWords* words = last_words) words->say();
  if (number != SIGQUIT) ::_exit(kInterrupted);
  std::signal(SIGQUIT, SIG_DFL);
  ::raise(SIGQUIT);  // comes when the handler returns
}

extern "C" void on_signal(int number) {
  const bool at_once =
      write_end < 0 || signals_seen != 0 || nobody_polls != 0 || OpeningPipe::under_way();
  if (at_once || number == SIGQUIT) return end_at_once(number);
  signals_seen = 1;
  const int saved = errno;
  [[maybe_unused]] const auto written = ::write(write_end, &kStop, 1);
  errno = saved;
}

}  // namespace

void end_on_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  ::sigfillset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction before {};
    ::sigaction(number, nullptr, &before);
    // As nohup and shells wish that start the program in the background.
    const bool ignored = before.sa_handler == SIG_IGN && (number == SIGHUP || number == SIGQUIT);
    if (!ignored) ::sigaction(number, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error of writing
}

SignalWatcher::SignalWatcher() {
  if (::pipe2(pipe_, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "no pipe for signals");
  try {
    waiter_ = std::thread([this] {
      char byte = 0;
      while (::read(pipe_[0], &byte, 1) < 0 && errno == EINTR) {
      }
      if (byte == kStop) source_.request_stop();
    });
  } catch (const std::system_error& fault) {
    throw std::system_error(fault.code(), "no thread for signals");
  }
  signals_seen = 0;
  write_end = pipe_[1];
}

SignalWatcher::~SignalWatcher() {
  write_end = -1;
  [[maybe_unused]] const auto written = ::write(pipe_[1], &kQuit, 1);
  waiter_.join();
  ::close(pipe_[0]);
  ::close(pipe_[1]);
}

bool SignalWatcher::interrupted() const noexcept { return signals_seen != 0; }

EndAtOnce::EndAtOnce() noexcept { nobody_polls = 1; }
EndAtOnce::~EndAtOnce() { nobody_polls = 0; }

LastWords::LastWords(const std::string& text) : before_(last_words) {
  change(text);
  last_words = this;
}
LastWords::~LastWords() { last_words = before_; }

void LastWords::change(const std::string& text) {
  line_ = text.empty() ? nullptr : &lines_.emplace_back("lasius: " + printable(text) + "\n");
}

void LastWords::say() const noexcept {
  for (const LastWords* words = this; words != nullptr; words = words->before_)
    if (const std::string* line = words->line_) {
      [[maybe_unused]] const auto said = ::write(STDERR_FILENO, line->data(), line->size());
    }
}

}  // namespace lasius::tool
