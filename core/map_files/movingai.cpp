#include "core/map_files/movingai.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "core/base/text_lines.h"
#include "core/map_files/map_size.h"

namespace lasius {
namespace {

constexpr std::size_t kLongestHeaderLine = 200;
constexpr const char* kHeaderRemedy =
    "a map starts with the lines 'type octile', 'height H', 'width W' and 'map'";

constexpr std::uint8_t kUnknown = 2;
constexpr auto kCells = [] {
  std::array<std::uint8_t, 256> cells{};
  cells.fill(kUnknown);
  for (const char c : {'.', 'G', 'S'}) cells[static_cast<unsigned char>(c)] = 0;
  for (const char c : {'@', 'O', 'T', 'W'}) cells[static_cast<unsigned char>(c)] = 1;
  return cells;
}();

constexpr std::string_view kBlanks = " \t";
bool is_blank(char c) noexcept { return kBlanks.find(c) != kBlanks.npos; }

std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte > 32 && byte < 127) return std::string("'") + c + "'";
  return "code " + std::to_string(byte);
}

// "KEY VALUE" of one header line.
struct HeaderLine {
  std::string key;
  std::string value;
};

HeaderLine header_line(ByteReader& in, std::string& line) {
  const std::int64_t number = in.line();
  if (!in.get_line(line, kLongestHeaderLine))
    in.fail_at_line(number, "the header ends early", kHeaderRemedy);
  const std::string_view text = trimmed(line, kBlanks);
  const auto gap = std::ranges::find_if(text, is_blank) - text.begin();
  return {std::string(text.substr(0, gap)), std::string(trimmed(text.substr(gap), kBlanks))};
}

int read_side(const ByteReader& in, std::int64_t line, const HeaderLine& header) {
  int side = 0;
  const char* end = header.value.data() + header.value.size();
  const auto [stop, error] = std::from_chars(header.value.data(), end, side);
  if (error == std::errc::result_out_of_range && stop == end) {
    in.fail_at_line(line, header.key + " is " + header.value.substr(0, 20),
                    "at most " + std::to_string(Grid::kMaxSide) + " is read",
                    ErrorCode::file_unsupported);
  }
  if (error != std::errc{} || stop != end) {
    in.fail_at_line(line, header.key + " is '" + header.value.substr(0, 20) + "'",
                    "it must be a whole number");
  }
  return side;
}

struct Header {
  int width = 0;
  int height = 0;
  SizePlace place;  // of the first side that is refused; else of the second
};

Header read_header(ByteReader& in) {
  std::string text;
  HeaderLine line = header_line(in, text);
  if (line.key != "type") in.fail_at_line(1, "this is not a map", kHeaderRemedy);
  if (line.value != "octile") {
    in.fail_at_line(1, "the map's type is '" + line.value.substr(0, 20) + "'",
                    "only 'octile' is read", ErrorCode::file_unsupported);
  }
  Header header;
  bool has_width = false;
  bool has_height = false;
  bool refused = false;
  for (;;) {
    const std::int64_t number = in.line();
    line = header_line(in, text);
    if (line.key == "map" && line.value.empty()) break;
    const bool is_width = line.key == "width";
    if ((!is_width && line.key != "height") || (is_width ? has_width : has_height)) {
      in.fail_at_line(number, "unexpected '" + text.substr(0, 20) + "' in the header",
                      kHeaderRemedy);
    }
    const int side = read_side(in, number, line);
    (is_width ? header.width : header.height) = side;
    (is_width ? has_width : has_height) = true;
    if (!refused) header.place.line = number;
    refused = refused || side < 1 || side > Grid::kMaxSide;
  }
  if (!has_width || !has_height) {
    in.fail_at_line(in.line() - 1, has_width ? "the height is missing" : "the width is missing",
                    kHeaderRemedy);
  }
  return header;
}

void read_row(ByteReader& in, std::string& text, int width, int y, int height,
              std::vector<std::uint64_t>& words) {
  const std::int64_t line = in.line();
  if (!in.get_line(text, static_cast<std::size_t>(width))) {
    in.fail_at_line(
        line, "the map ends after " + std::to_string(y) + " of " + std::to_string(height) + " rows",
        "get the whole file, or correct the height");
  }
  const int length = static_cast<int>(text.size());
  std::ranges::fill(words, 0);
  for (int x = 0; x < std::min(length, width); ++x) {
    const std::uint64_t cell = kCells[static_cast<unsigned char>(text[x])];
    if (cell == kUnknown) {
      in.fail_at_line(line, "character " + shown(text[x]) + " in column " + std::to_string(x),
                      "cells are '.', 'G', 'S' (free) and '@', 'O', 'T', 'W' (blocked)");
    }
    words[x >> 6] |= cell << (x & 63);
  }
  if (length != width) {
    in.fail_at_line(line,
                    length > width ? "the row goes on after the width"
                                   : "the row ends after " + std::to_string(length) + " of " +
                                         std::to_string(width) + " characters",
                    "every row must have the width, " + std::to_string(width));
  }
}

}  // namespace

bool is_movingai(std::string_view head) noexcept {
  return head.size() > 4 && head.substr(0, 4) == "type" && is_blank(head[4]);
}

Grid read_movingai(ByteReader& in) {
  const Header header = read_header(in);
  check_map_size(in, header.place, header.width, header.height);
  // The last row may lack its line end.
  const std::int64_t needed = (std::int64_t{header.width} + 1) * header.height - 1;
  check_bytes_left(in, header.place, header.width, header.height, needed);

  Grid grid(header.width, header.height);
  std::string text;
  std::vector<std::uint64_t> words(grid.words());
  for (int y = 0; y < grid.height(); ++y) {
    read_row(in, text, grid.width(), y, grid.height(), words);
    grid.set_row(y, words.data());
  }
  for (std::int64_t line = in.line(); in.get_line(text, kLongestHeaderLine); line = in.line()) {
    if (trimmed(text, kBlanks).empty()) continue;
    in.fail_at_line(line, "more rows than the height, " + std::to_string(header.height),
                    "correct the height, or remove what follows the map");
  }
  return grid;
}

void write_movingai(const Grid& grid, std::ostream& out) {
  out << "type octile\nheight " << grid.height() << "\nwidth " << grid.width() << "\nmap\n";
  std::string row(static_cast<std::size_t>(grid.width()) + 1, '\n');
  for (int y = 0; y < grid.height(); ++y) {
    const std::uint64_t* words = grid.row(y);
    for (int x = 0; x < grid.width(); ++x)
      row[x] = ((words[x >> 6] >> (x & 63)) & 1) != 0 ? '@' : '.';
    out.write(row.data(), static_cast<std::streamsize>(row.size()));
  }
}

}  // namespace lasius
