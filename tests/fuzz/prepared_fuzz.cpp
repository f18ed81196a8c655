// Files of prepared maps, behind a head that is right: otherwise nearly all inputs end at the
// checksum. The first byte says whether there are labels.
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/plan/prepared_head.h"
#include "lasius/base/error.h"
#include "lasius/plan/planner.h"
#include "tests/fuzz/reading.h"

namespace lasius::fuzz {
namespace {

Grid small_map() {
  constexpr int kWidth = 12, kHeight = 7;
  std::vector<std::uint8_t> cells(kWidth * kHeight);
  for (const Cell c : {Cell{8, 1}, {4, 2}, {5, 2}, {4, 3}, {4, 4}, {5, 4}})
    cells[static_cast<std::size_t>(c.y) * kWidth + static_cast<std::size_t>(c.x)] = 1;
  return {kWidth, kHeight, cells, Nonzero::blocked};
}

/// The file's name, which ends with the program.
struct Name {
  ~Name() { ::unlink(file.c_str()); }
  const std::string file = (std::filesystem::temp_directory_path() /
                            ("lasius-fuzz-" + std::to_string(::getpid()) + ".prepared"))
                               .string();
};

}  // namespace

void check(const std::string& bytes) {
  static const Name name;
  static const Planner planner(small_map());
  if (bytes.empty()) return;
  const std::string_view text = std::string_view(bytes).substr(1);
  std::ofstream out(name.file, std::ios::binary);
  out << prepared_head(planner.grid(), (bytes[0] & 1) != 0, text) << text;
  require(out.flush().good());
  try {
    (void)planner.load_preparation(name.file);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::file_broken && !error.remedy().empty());
  }
}

}  // namespace lasius::fuzz
