// Where an output goes: what its name stands for, and what keeps it from being written.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

namespace lasius {

/// Where the bytes for a name go.
struct Target {
  std::filesystem::path file;              ///< at the end of its links; need not be there
  std::optional<int> descriptor = {};      ///< of an open file that is to be written as it is
  std::optional<struct stat> status = {};  ///< nothing where there is no file yet

  bool stream() const {
    return descriptor || (status && !S_ISREG(status->st_mode) && !S_ISDIR(status->st_mode));
  }
  std::filesystem::path folder() const {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  }
};

/// What `path` stands for at the end of its links. @throws Error(output_failed)
Target find_target(const std::string& path);

/// @throws Error(output_failed) where the target of `path` cannot be written.
void check_target(const Target& target, const std::string& path);

/// What the system calls an `errno`.
inline std::string system_reason(int error) { return std::generic_category().message(error); }

/// "`path`: cannot be written: `why`". @throws Error(output_failed)
[[noreturn]] void refuse_output(const std::string& path, const std::string& why);

}  // namespace lasius
