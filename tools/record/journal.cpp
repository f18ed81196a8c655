#include "tools/record/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/base/number_text.h"
#include "lasius/base/error.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

std::string header_of(const std::string& key) { return "lasius-journal/1 " + key + "\n"; }

std::string entry_head(int number, std::string_view text) {
  const std::string name = std::to_string(number);
  return name + " " + std::to_string(text.size()) + " " +
         hash_text(bytes_hash(text, bytes_hash(name))) + "\n";
}

/// Takes whole entries off the front of `bytes`; returns how many bytes they are.
std::size_t read_entries(std::string_view bytes, std::map<int, std::string>& kept) {
  std::size_t at = 0;
  for (;;) {
    const std::string_view rest = bytes.substr(at);
    const auto end = rest.find('\n'), first = rest.find(' ');
    if (end == rest.npos || first >= end) return at;
    const auto second = rest.find(' ', first + 1);
    if (second >= end) return at;
    const auto number = number_of<int>(rest.substr(0, first));
    const auto size = number_of<std::int64_t>(rest.substr(first + 1, second - first - 1));
    if (!number || !size || *size < 0) return at;
    const auto length = static_cast<std::size_t>(*size);
    if (rest.size() - end - 1 < length + 1) return at;
    const std::string_view text = rest.substr(end + 1, length);
    if (rest.substr(0, end + 1) != entry_head(*number, text) || rest[end + 1 + length] != '\n')
      return at;
    kept[*number] = text;
    at += end + length + 2;
  }
}

/// The file, held against other processes; negative where it cannot be written.
/// @throws Error where another process holds it.
int held(const std::string& file) {
  for (;;) {
    constexpr int kNoOther = O_NOFOLLOW | O_NONBLOCK;  // a link, a pipe that nobody reads
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | kNoOther, 0666);
    const bool opened = descriptor >= 0;
    if (!opened && errno != ELOOP && errno != ENXIO && errno != EISDIR) return descriptor;
    const bool taken =
        opened && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    struct stat now {};
    const bool known = opened && ::fstat(descriptor, &now) == 0;
    const bool other = !opened || (known && (!S_ISREG(now.st_mode) || now.st_nlink > 1));
    if (!other && !taken && (!known || now.st_nlink > 0)) return descriptor;
    if (opened) ::close(descriptor);
    if (other)
      throw Error(ErrorCode::output_failed, {.file = file}, "is no file of its own",
                  "remove or rename it");
    if (taken)
      throw Error(ErrorCode::output_failed, {.file = file}, "another job of this command is at it",
                  "wait for its end, or end it");
  }  // it was removed before it was held
}

}  // namespace

Journal::Journal(std::string file, const std::string& key)
    : file_(std::move(file)), descriptor_(held(file_)) {
  const int descriptor = descriptor_.number();
  const auto require = [&](bool done) {
    if (!done)
      throw Error(ErrorCode::output_failed, {.file = file_},
                  std::string("cannot be written: ") + std::strerror(errno),
                  "go to a folder that may be written: what is done is kept there");
  };
  require(descriptor >= 0);
  std::ifstream in(file_, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  const std::string header = header_of(key);
  std::size_t whole = 0;
  if (bytes.starts_with(header))
    whole = header.size() + read_entries(std::string_view(bytes).substr(header.size()), kept_);
  const auto length = static_cast<off_t>(whole);
  require(::ftruncate(descriptor, length) == 0 && ::lseek(descriptor, length, SEEK_SET) == length);
  if (whole == 0) write(header);
}

void Journal::add(int number, std::string_view text) {
  write(entry_head(number, text).append(text).append("\n"));
}

void Journal::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor_.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) break;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (bytes.empty() && ::fdatasync(descriptor_.number()) == 0) return;
  throw Error(ErrorCode::output_failed, {.file = file_},
              std::string("cannot be written: ") + std::strerror(errno),
              "make room; the same command goes on from there");
}

void Journal::remove() { ::unlink(file_.c_str()); }

}  // namespace lasius::tool
