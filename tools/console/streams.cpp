#include "tools/console/streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "lasius/error.h"

namespace lasius::tool {
namespace {

Error cannot_write(const std::string& file, const std::string& why) {
  return Error(ErrorCode::output_failed, {.file = file}, "cannot be written: " + why,
               "name a file in a folder that exists, may be written and has room");
}

}  // namespace

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
  throw cannot_write("standard output", std::strerror(errno));
}

void message(std::string_view text) {
  std::fprintf(stderr, "lasius: %.*s\n", static_cast<int>(text.size()), text.data());
}

void check_writable(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const fs::path target(file);
  if (fs::is_directory(target, fault)) throw cannot_write(file, "it is a folder");
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, fault))
    throw cannot_write(file, "there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw cannot_write(file, folder.string() + ": " + std::strerror(errno));
}

}  // namespace lasius::tool
