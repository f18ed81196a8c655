#include "tools/study/files.h"

#include <ostream>
#include <system_error>

#include "core/base/output.h"
#include "lasius/base/error.h"

namespace lasius::study {

void make_folder(const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (!fault) return;
  throw Error(ErrorCode::output_failed, {.file = folder.string()},
              "cannot be made: " + fault.message(), "name another folder");
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  write_file(file.string(), [&](std::ostream& out) { out << text; });
}

}  // namespace lasius::study
