#include "tools/console/streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "core/base/printable.h"
#include "lasius/base/error.h"

namespace lasius::tool {
void guard_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) {
      const int opened = ::open("/dev/null", O_RDWR);  // the lowest free number: this stream's
      if (opened != stream && opened >= 0) ::close(opened);
    }
  std::signal(SIGPIPE, SIG_IGN);
}

void print(std::string_view text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) throw ClosedOutput{};
  throw Error(ErrorCode::output_failed, {.file = "standard output"},
              std::string("cannot be written: ") + std::strerror(errno),
              "send it to a file that has room");
}

void print_verdict(std::string_view text) {
  try {
    print(text);
  } catch (const ClosedOutput&) {
    return;
  }
}

void message(std::string_view text) {
  std::fprintf(stderr, "lasius: %s\n", printable(text).c_str());
}

}  // namespace lasius::tool
