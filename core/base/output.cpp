#include "core/base/output.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <locale>
#include <streambuf>

#include "core/base/descriptor.h"
#include "core/base/opening_pipe.h"
#include "core/base/output_target.h"
#include "lasius/base/error.h"

namespace lasius {
namespace {

[[noreturn]] void fail_at_end(const std::string& path, int error = errno) {
  const std::string why = error == 0 ? "its text could not be made" : system_reason(error);
  throw Error(ErrorCode::output_failed, {.file = path}, "could not be written whole (" + why + ")",
              error == EPIPE ? "keep its reader open" : "check the free space");
}

/// A stream opened for writing; a named pipe once somebody reads it.
Descriptor opened(const std::string& stream) {
  const OpeningPipe opening(stream);
  return Descriptor(::open(stream.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
}

/// The bytes of a stream, written to a descriptor.
class Bytes : public std::streambuf {
 public:
  explicit Bytes(int descriptor) : descriptor_(descriptor), buffer_(1 << 16) { empty(); }
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  int sync() override {
    for (const char* from = pbase(); from < pptr();) {
      const auto written = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
      if (written >= 0) {
        from += written;
      } else if (errno != EINTR) {
        error_ = errno;
        return -1;
      }
    }
    empty();
    return 0;
  }

 private:
  void empty() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

  int descriptor_;
  std::vector<char> buffer_;
  int error_ = 0;
};

void write_to(int descriptor, const std::string& path,
              const std::function<void(std::ostream&)>& write) {
  Bytes bytes(descriptor);
  std::ostream out(&bytes);
  out.imbue(std::locale::classic());  // no "4,096" where the program's own has it so
  write(out);
  out.flush();
  if (out) return;
  fail_at_end(path, bytes.error());
}

/// Held while temporary files get, change and lose their names. Who holds it gets no signals, so
/// that a signal handler that waits for it waits for another thread.
class NamesLock {
 public:
  NamesLock() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    take();
  }
  NamesLock(const NamesLock&) = delete;
  NamesLock& operator=(const NamesLock&) = delete;
  ~NamesLock() {
    taken_.clear();
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  /// For good.
  static void take() noexcept {
    while (taken_.test_and_set()) ::sched_yield();
  }

 private:
  static inline std::atomic_flag taken_;
  sigset_t before_;
};

/// A file that takes the target's place when it is whole. Where the file system has such files, it
/// has no name until then, so that nothing is left of it whatever ends the process; elsewhere it is
/// in a list for `abandon_outputs`.
class Temporary {
 public:
  Temporary(const Target& target, const std::string& path)
      : path_(path), folder_(::open(target.folder().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
    file_.reset(::openat(folder_.number(), ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666));
    if (file_.number() < 0 || ::access(link().c_str(), F_OK) != 0) make_named();
    struct stat made {};
    ::fstat(descriptor(), &made);
    mode_ = made.st_mode & 0777;
    ::fchmod(descriptor(), 0600);  // until it is known who may read it
    if (target.status) take_over(*target.status);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    const NamesLock lock;
    if (!name_.empty()) unlink();
    for (Temporary** at = &first_; *at != nullptr; at = &(*at)->next_) {
      if (*at != this) continue;
      *at = next_;
      break;
    }
  }

  int descriptor() const { return file_.number(); }

  void replace(const Target& target) {
    ::fchmod(descriptor(), mode_);
    // Some file systems find only at a close that there is no room.
    const int copy = ::dup(descriptor());
    if (copy >= 0 && ::close(copy) != 0) fail_at_end(path_);
    const std::string name = target.file.filename().string();
    const NamesLock lock;
    if (name_.empty()) {
      if (give_name(name.c_str())) return;  // nothing was to be replaced
      find_name([this](const char* free) { return give_name(free); });
    }
    if (::renameat(folder_.number(), name_.c_str(), folder_.number(), name.c_str()) != 0)
      fail_at_end(path_);
    name_.clear();
  }

  /// Precondition: NamesLock is held.
  static void remove_all() noexcept {
    for (const Temporary* t = first_; t != nullptr; t = t->next_) t->unlink();
  }

 private:
  std::string link() const { return "/proc/self/fd/" + std::to_string(descriptor()); }
  void unlink() const noexcept { ::unlinkat(folder_.number(), name_.c_str(), 0); }

  bool give_name(const char* name) {
    return ::linkat(AT_FDCWD, link().c_str(), folder_.number(), name, AT_SYMLINK_FOLLOW) == 0;
  }
  /// The first name that `take` takes. Names of other processes and of those killed may be there.
  template <class Take>
  void find_name(const Take& take) {
    static unsigned counter = 0;  // under the lock
    for (;;) {
      std::string name =
          ".lasius-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part";
      if (take(name.c_str())) {
        name_ = std::move(name);
        return;
      }
      if (errno != EEXIST) refuse_output(path_, system_reason(errno));
    }
  }
  void make_named() {
    const NamesLock lock;
    find_name([this](const char* name) {
      constexpr int kNew = O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC;
      file_.reset(::openat(folder_.number(), name, kNew, 0666));
      return descriptor() >= 0;
    });
    next_ = first_;
    first_ = this;
  }

  /// Owner, group and permissions of the file that is replaced.
  void take_over(const struct stat& old) {
    mode_ = old.st_mode & 0777;
    const bool kept = ::fchown(descriptor(), old.st_uid, old.st_gid) == 0 ||
                      ::fchown(descriptor(), static_cast<uid_t>(-1), old.st_gid) == 0;
    if (!kept) mode_ &= ~static_cast<mode_t>(070);  // they were meant for another group
  }

  static inline Temporary* first_ = nullptr;

  const std::string& path_;
  Descriptor folder_, file_;
  std::string name_;
  mode_t mode_ = 0;
  Temporary* next_ = nullptr;
};

}  // namespace

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  const Target target = find_target(path);
  check_target(target, path);
  if (target.descriptor) return write_to(*target.descriptor, path, write);
  if (target.stream()) {
    const Descriptor file = opened(target.file);
    if (file.number() < 0) refuse_output(path, system_reason(errno));
    return write_to(file.number(), path, write);
  }
  Temporary temporary(target, path);
  write_to(temporary.descriptor(), path, write);
  temporary.replace(target);
}

void abandon_outputs() noexcept {
  NamesLock::take();
  Temporary::remove_all();
}

bool has_ending(std::string_view path, std::string_view ending) noexcept {
  if (path.size() < ending.size()) return false;
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const auto last = path.substr(path.size() - ending.size());
  return std::equal(last.begin(), last.end(), ending.begin(),
                    [&](char a, char b) { return small(a) == b; });
}

}  // namespace lasius
