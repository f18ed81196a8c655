#include "core/base/output_target.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>
#include <vector>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/output.h"
#include "lasius/base/error.h"

namespace lasius {
namespace {

namespace fs = std::filesystem;

/// The number in /dev/fd/3 and the like, where /dev/stdout leads, too.
std::optional<int> descriptor_of(const fs::path& path) {
  const fs::path folder = path.parent_path();
  if (folder != "/dev/fd" && folder != "/proc/self/fd") return std::nullopt;
  const auto number = number_of<int>(path.filename().string());
  return number && *number >= 0 ? number : std::nullopt;
}

/// A file by what it is, not by its name.
struct FileId {
  dev_t device;
  ino_t inode;          ///< of the file, or of its folder where it is not there yet
  std::string missing;  ///< its name in that folder
  bool operator==(const FileId&) const = default;
};

/// Which regular file a name stands for; nothing for another kind of file, or where none could be.
std::optional<FileId> file_id(const std::string& path) {
  try {
    const Target target = find_target(path);
    if (target.status) {
      if (!S_ISREG(target.status->st_mode)) return std::nullopt;
      return FileId{target.status->st_dev, target.status->st_ino, {}};
    }
    struct stat folder {};
    if (::stat(target.folder().c_str(), &folder) != 0) return std::nullopt;
    return FileId{folder.st_dev, folder.st_ino, target.file.filename().string()};
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// An input or an output.
struct Known {
  std::string name;
  FileId id;
  bool stream;  ///< what is written to it may follow other things
};

}  // namespace

void refuse_output(const std::string& path, const std::string& why) {
  throw Error(ErrorCode::output_failed, {.file = path}, "cannot be written: " + why,
              "name a file in a folder that exists, may be written and has room");
}

Target find_target(const std::string& path) {
  constexpr int kMostLinks = 40;  // Linux's
  if (path.find('\0') != path.npos) refuse_output(path, "its name holds a zero byte");
  Target target{path};
  struct stat status {};
  for (int links = 0; links <= kMostLinks; ++links) {
    target.descriptor = descriptor_of(target.file);
    const bool there = (target.descriptor ? ::fstat(*target.descriptor, &status)
                                          : ::lstat(target.file.c_str(), &status)) == 0;
    if (!there && (errno != ENOENT || target.descriptor)) refuse_output(path, system_reason(errno));
    if (there && S_ISLNK(status.st_mode)) {
      std::error_code error;
      target.file = target.folder() / fs::read_symlink(target.file, error);
      if (error) refuse_output(path, error.message());
      continue;
    }
    if (there) {
      target.status = status;
    } else if (::stat(path.c_str(), &status) == 0) {  // by a link that only the kernel can follow
      target.file = path;
      target.status = status;
    }
    return target;
  }
  refuse_output(path, "its links lead in a circle");
}

void check_target(const Target& target, const std::string& path) {
  if (target.descriptor) {
    if ((::fcntl(*target.descriptor, F_GETFL) & O_ACCMODE) == O_RDONLY)
      refuse_output(path, "it is open for reading only");
    return;
  }
  if (target.status) {
    if (S_ISDIR(target.status->st_mode)) refuse_output(path, "it is a folder");
    // The superuser may write any file; one that nobody may write is not meant to be.
    if ((target.status->st_mode & 0222) == 0) refuse_output(path, "it is read-only");
    if (::access(target.file.c_str(), W_OK) != 0) refuse_output(path, system_reason(errno));
    if (target.stream()) return;
  }
  const fs::path folder = target.folder();
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    refuse_output(path, "there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    refuse_output(path, folder.string() + ": " + system_reason(errno));
}

bool is_stream(const std::string& path) {
  try {
    return find_target(path).stream();
  } catch (const Error&) {
    return false;
  }
}

void check_outputs(const std::vector<std::string>& outputs,
                   const std::vector<std::string>& inputs) {
  std::vector<Known> known;
  for (const auto& file : inputs)
    if (auto id = file_id(file)) known.push_back({"the input " + file, std::move(*id), false});
  const auto add = [&](const std::string& name, const std::string& file) {
    auto id = file_id(file);
    if (!id) return;
    const bool stream = is_stream(file);
    for (const Known& other : known)
      if (other.id == *id && !(other.stream && stream))
        refuse(name + " and " + other.name + " are one file", "name another one for the output");
    known.push_back({name, std::move(*id), stream});
  };
  add("standard output", "/dev/stdout");
  for (const auto& file : outputs) {
    check_target(find_target(file), file);
    add("the output " + file, file);
  }
}

}  // namespace lasius
