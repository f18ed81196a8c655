// Files of prepared maps, behind a head that is right: otherwise nearly all inputs end at the
// checksum. The first byte says whether there are labels.
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "lasius/plan/planner.h"
#include "tests/fuzz/reading.h"

namespace lasius::fuzz {
namespace {

constexpr std::size_t kHead = 56, kLabels = 20, kSize = 40, kSum = 48;

/// As core/plan/planner_files.cpp has it.
std::uint64_t checksum(std::string_view text) {
  std::uint64_t sum = text.size();
  for (std::size_t i = 0; i < text.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data() + i, std::min<std::size_t>(8, text.size() - i));
    sum = (sum ^ word) * 0x9e3779b97f4a7c15;
    sum ^= sum >> 29;
  }
  return sum;
}

Planner small_map() {
  constexpr int kWidth = 12, kHeight = 7;
  std::vector<std::uint8_t> cells(kWidth * kHeight);
  for (const Cell c : {Cell{8, 1}, {4, 2}, {5, 2}, {4, 3}, {4, 4}, {5, 4}})
    cells[static_cast<std::size_t>(c.y) * kWidth + static_cast<std::size_t>(c.x)] = 1;
  return {Grid(kWidth, kHeight, cells, Nonzero::blocked), PrepareOptions{.threads = 1}};
}

struct Preparations {
  Preparations() {
    planner.save_preparation(file);
    std::ifstream in(file, std::ios::binary);
    head.assign(std::istreambuf_iterator<char>(in), {});
    head.resize(kHead);
  }
  ~Preparations() { ::unlink(file.c_str()); }
  const std::string file = (std::filesystem::temp_directory_path() /
                            ("lasius-fuzz-" + std::to_string(::getpid()) + ".prepared"))
                               .string();
  const Planner planner = small_map();
  std::string head;
};

}  // namespace

void check(const std::string& bytes) {
  static const Preparations made;
  if (bytes.empty()) return;
  const std::string_view text = std::string_view(bytes).substr(1);
  std::string head = made.head;
  const std::uint64_t size = text.size(), sum = checksum(text);
  head[kLabels] = static_cast<char>(bytes[0] & 1);
  std::memcpy(head.data() + kSize, &size, sizeof size);
  std::memcpy(head.data() + kSum, &sum, sizeof sum);
  std::ofstream(made.file, std::ios::binary) << head << text;
  try {
    (void)made.planner.load_preparation(made.file);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::file_broken && !error.remedy().empty());
  }
}

}  // namespace lasius::fuzz
