#include "core/base/output.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <locale>
#include <system_error>

#include "lasius/error.h"

namespace lasius {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& problem,
                       const std::string& remedy) {
  throw Error(ErrorCode::output_failed, Error::Place{path}, problem, remedy);
}

std::string reason() { return std::generic_category().message(errno); }

void write_to(const std::string& file, const std::string& path,
              const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out;
  out.imbue(std::locale::classic());  // no "4,096" where the program's own has it so
  out.open(file, std::ios::binary | std::ios::trunc);
  if (!out) {
    fail(path, "cannot be written (" + reason() + ")",
         "check that its folder exists and may be written");
  }
  write(out);
  out.close();
  if (!out) fail(path, "could not be written whole (" + reason() + ")", "check the free space");
}

// Removes the temporary file unless it was renamed.
class Temporary {
 public:
  explicit Temporary(std::string name) : name_(std::move(name)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    if (!renamed_) fs::remove(name_, ignored);
  }
  const std::string& name() const noexcept { return name_; }
  std::error_code rename_to(const fs::path& target) {
    std::error_code error;
    fs::rename(name_, target, error);
    renamed_ = !error;
    return error;
  }

 private:
  std::string name_;
  bool renamed_ = false;
};

// Beside the target, whose own name may be as long as names can be; unique among the threads of
// this process and among processes.
std::string temporary_name(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  const std::string name =
      ".lasius-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part";
  return (target.parent_path() / name).string();
}

/// What `path` stands for at the end of its links, which need not exist.
fs::path followed(const std::string& path) {
  constexpr int kMostLinks = 40;  // Linux's
  fs::path target = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error || links == kMostLinks) {
      fail(path, "is a link that leads nowhere", "correct the link, or name another file");
    }
    target = target.parent_path() / next;
  }
  return target;
}

}  // namespace

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (fs::is_directory(status)) fail(path, "is a folder", "name a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_to(path, path, write);

  const fs::path target = followed(path);
  Temporary temporary(temporary_name(target));
  write_to(temporary.name(), path, write);
  error = temporary.rename_to(target);
  if (error) {
    fail(path, "cannot be replaced (" + error.message() + ")",
         "check that its folder may be written");
  }
}

bool has_ending(std::string_view path, std::string_view ending) noexcept {
  if (path.size() < ending.size()) return false;
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const auto last = path.substr(path.size() - ending.size());
  return std::equal(last.begin(), last.end(), ending.begin(),
                    [&](char a, char b) { return small(a) == b; });
}

}  // namespace lasius
