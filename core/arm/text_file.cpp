#include "text_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "lasius/error.h"

namespace lasius::arm {

std::string read_text(const std::string& path, std::int64_t most) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error(ErrorCode::file_missing, {.file = path}, "this is a folder", "name a file in it");
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw Error(ErrorCode::file_missing, {.file = path},
                std::string("cannot be opened (") + std::strerror(errno) + ")",
                "check the path and its permissions");
  }
  std::string text;
  char buffer[65536];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (static_cast<std::int64_t>(text.size()) > most) {
      throw Error(ErrorCode::file_unsupported, {.file = path},
                  "the file is larger than " + std::to_string(most) + " bytes",
                  "this is no file of this kind");
    }
  }
  return text;
}

std::string beside(const std::string& file, const std::string& name) {
  return (std::filesystem::path(file).parent_path() / name).string();
}

}  // namespace lasius::arm
