// What a map was prepared with, in files.
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/opening_pipe.h"
#include "core/base/output.h"
#include "core/base/stored_arrays.h"
#include "core/plan/planner_impl.h"
#include "core/plan/prepared_head.h"

namespace lasius {
namespace {

static_assert(std::endian::native == std::endian::little, "files are little-endian");

/// What a file begins with.
struct Header {
  std::array<char, 16> name;
  std::uint32_t version;
  std::uint32_t labels;  ///< 1 where it has them
  std::uint64_t map;     ///< hash
  std::uint32_t width, height;
  std::uint64_t size;  ///< bytes that follow
  std::uint64_t sum;   ///< of these
};
static_assert(sizeof(Header) == 56);
constexpr std::array<char, 16> kName{'l', 'a', 's', 'i', 'u', 's', '-', 'p',
                                     'r', 'e', 'p', 'a', 'r', 'e', 'd', '\n'};
constexpr std::uint32_t kVersion = 1;

/// Tells texts apart that differ by accident.
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

[[noreturn]] void refuse_file(const std::string& file, std::int64_t offset, std::string problem,
                              std::string remedy = "remove it, to have it made anew") {
  throw Error(ErrorCode::file_broken, {.file = file, .offset = offset}, std::move(problem),
              std::move(remedy));
}

std::string read_all(const std::string& file) {
  std::error_code none;
  const auto kind = std::filesystem::status(file, none).type();
  if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found)
    refuse_file(file, 0, "is no regular file", "name another");
  std::ifstream in;
  {
    const OpeningPipe opening(file);
    in.open(file, std::ios::binary);
  }
  std::string text;
  if (in) text.assign(std::istreambuf_iterator<char>(in), {});
  if (!in || in.bad())
    throw Error(ErrorCode::file_missing, {.file = file}, "cannot be read", "check its name");
  return text;
}

/// What a file of a map's preparation begins with. @throws Error(file_broken) where it is none.
Header checked_header(std::string_view whole, const Grid& map, const std::string& file) {
  Header header{};
  if (whole.size() >= sizeof header) std::memcpy(&header, whole.data(), sizeof header);
  if (header.name != kName)
    refuse_file(file, 0, "is no file of a prepared map", "name another, or remove it");
  if (header.version != kVersion)
    refuse_file(file, 16,
                "is of version " + std::to_string(header.version) + ", this program reads " +
                    std::to_string(kVersion));
  if (header.labels > 1)
    refuse_file(file, 20, "is damaged: it says neither that it has labels nor none");
  if (header.map != map.hash() || header.width != static_cast<std::uint32_t>(map.width()) ||
      header.height != static_cast<std::uint32_t>(map.height()))
    refuse_file(file, 24,
                "was prepared for another map, of " +
                    size_text(static_cast<int>(header.width), static_cast<int>(header.height)) +
                    " cells",
                "name another file, or remove it, to have it made anew");
  const auto length = static_cast<std::int64_t>(whole.size());
  const std::string_view text = whole.substr(sizeof header);
  if (text.size() < header.size) refuse_file(file, length, "is cut short");
  if (text.size() > header.size)
    refuse_file(file, length, "has more than what it was written with");
  if (checksum(text) != header.sum)
    refuse_file(file, static_cast<std::int64_t>(sizeof header), "is damaged: its checksum differs");
  return header;
}

}  // namespace

std::string prepared_head(const Grid& map, bool labels, std::string_view text) {
  const Header header{kName,
                      kVersion,
                      labels ? 1U : 0U,
                      map.hash(),
                      static_cast<std::uint32_t>(map.width()),
                      static_cast<std::uint32_t>(map.height()),
                      text.size(),
                      checksum(text)};
  return {reinterpret_cast<const char*>(&header), sizeof header};
}

void Planner::save_preparation(const std::string& file) const {
  if (impl_->graph == nullptr)
    throw invalid_parameter(
        "there is no preparation to write to " + file,
        impl_->disc == nullptr ? "prepare the map first" : "a disc's is kept in no file");
  ArrayWriter arrays;
  impl_->graph->save(arrays);
  if (impl_->labels != nullptr) impl_->labels->save(arrays);
  const std::string head = prepared_head(impl_->grid, impl_->labels != nullptr, arrays.text());
  write_file(file, [&](std::ostream& out) { out << head << arrays.text(); });
}

Planner Planner::load_preparation(const std::string& file) const {
  if (impl_->disc != nullptr)
    throw invalid_parameter("a disc's preparation is kept in no file", "plan for a point");
  const auto begin = Clock::now();
  const std::string whole = read_all(file);
  const Grid& map = impl_->grid;
  const Header header = checked_header(whole, map, file);
  auto more =
      std::make_shared<Impl>(impl_->grid, impl_->four, impl_->excluded, impl_->closed, impl_->disc);
  ArrayReader arrays(std::string_view(whole).substr(sizeof header), file, sizeof header);
  const auto graph = exact::CornerGraph::load(map, arrays);
  Preparation& report = more->preparation;
  if (header.labels == 1) {
    more->labels = exact::CornerLabels::load(map, *graph, arrays);
    report.labels = {.state = Preparation::State::ready,
                     .entries = more->labels->entry_count(),
                     .bytes = more->labels->bytes(),
                     .seconds = 0};
  }
  arrays.require(arrays.at_end());
  report.state = Preparation::State::ready;
  report.vertices = graph->size();
  report.edges = graph->edge_count();
  report.bytes = graph->bytes();
  report.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  more->graph = graph;
  more->from_file = true;
  return Planner(std::move(more));
}

}  // namespace lasius
