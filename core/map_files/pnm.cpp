#include "core/map_files/pnm.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/number_text.h"
#include "core/map_files/map_size.h"

namespace lasius {
namespace {

constexpr int kMaxLevel = 65535;

bool is_space(int c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(int c) noexcept { return c >= '0' && c <= '9'; }

// The eight pixels of a byte, leftmost in the lowest bit.
constexpr auto kReversed = [] {
  std::array<std::uint8_t, 256> reversed{};
  for (int byte = 0; byte < 256; ++byte) {
    for (int bit = 0; bit < 8; ++bit)
      if ((byte >> bit & 1) != 0) reversed[byte] |= static_cast<std::uint8_t>(128 >> bit);
  }
  return reversed;
}();

// One file being read: its kind, its header and its raster.
class PnmReader {
 public:
  PnmReader(ByteReader& in, const PixelRule& rule) : in_(in), rule_(rule) {}

  Map read() {
    read_header();
    kinds_ = rule_.table(white_);
    Map map = rule_.map(width_, height_);
    PixelRow row(map.grid, rule_);
    for (int y = 0; y < height_; ++y) {
      if (plain_)
        read_plain_row(y, row);
      else if (bitmap_)
        read_bit_row(y, row);
      else
        read_level_row(y, row);
      row.end(y, map);
    }
    check_end();
    return map;
  }

 private:
  struct Mark {
    std::int64_t line;
    std::int64_t offset;
  };
  Mark mark() const noexcept { return {in_.line(), in_.offset()}; }
  // ASCII files are read by their lines, binary ones by their bytes.
  SizePlace place(Mark at) const noexcept {
    return plain_ ? SizePlace{at.line, -1} : SizePlace{-1, at.offset};
  }
  [[noreturn]] void fail(Mark at, std::string problem, std::string remedy) const {
    if (plain_) in_.fail_at_line(at.line, std::move(problem), std::move(remedy));
    in_.fail_at_offset(at.offset, std::move(problem), std::move(remedy));
  }

  // The least a row takes in the file.
  std::int64_t row_bytes() const noexcept {
    if (bitmap_) return plain_ ? width_ : (width_ + 7) / 8;
    return std::int64_t{width_} * (plain_ || white_ > 255 ? 2 : 1);
  }

  void skip_comment() {
    for (int c = in_.peek(); c != '\n' && c != '\r' && c != ByteReader::kEnd; c = in_.peek())
      in_.get();
  }

  void skip_space() {
    for (int c = in_.peek();; c = in_.peek()) {
      if (c == '#')
        skip_comment();
      else if (is_space(c))
        in_.get();
      else
        return;
    }
  }

  std::int64_t read_number(const char* what) {
    skip_space();
    const Mark at = mark();
    const int first = in_.peek();
    if (first == ByteReader::kEnd)
      fail(at, std::string("the file ends before its ") + what, "get the whole file");
    if (!is_digit(first)) fail(at, std::string(what) + " is not a number", "write it in digits");
    constexpr std::int64_t kMost = 100'000'000'000'000'000;  // more is told as this
    std::int64_t number = 0;
    while (is_digit(in_.peek())) number = std::min(number * 10 + (in_.get() - '0'), kMost);
    const int next = in_.peek();
    if (next != ByteReader::kEnd && next != '#' && !is_space(next))
      fail(mark(), std::string(what) + " is not a number", "write it in digits");
    return number;
  }

  void read_header() {
    in_.get();
    const int kind = in_.get();
    plain_ = kind == '1' || kind == '2';
    bitmap_ = kind == '1' || kind == '4';
    skip_space();
    const Mark at = mark();
    const std::int64_t width = read_number("width");
    const std::int64_t height = read_number("height");
    check_map_size(in_, place(at), width, height);
    width_ = static_cast<int>(width);
    height_ = static_cast<int>(height);
    if (!bitmap_) {
      skip_space();
      const Mark at_level = mark();
      const std::int64_t white = read_number("maxval");
      if (white < 1 || white > kMaxLevel)
        fail(at_level, "maxval is " + std::to_string(white), "it must be 1 to 65535");
      white_ = static_cast<int>(white);
    }
    if (!plain_) start_binary_raster();
    // The last ASCII level needs no blank after it.
    const std::int64_t needed = row_bytes() * height_ - (plain_ && !bitmap_ ? 1 : 0);
    check_bytes_left(in_, place(at), width_, height_, needed);
    if (!plain_) bytes_.resize(static_cast<std::size_t>(row_bytes()));
  }

  // One white-space byte stands between the header and the raster. A comment may come before it;
  // and CR LF is taken for one line end where the file's size leaves no doubt.
  void start_binary_raster() {
    if (in_.peek() == '#') skip_comment();
    const bool carriage_return = in_.peek() == '\r';
    const Mark at = mark();
    if (in_.get() == ByteReader::kEnd)
      fail(at, "the file ends before its pixels", "get the whole file");
    if (carriage_return && in_.peek() == '\n' && in_.left() > row_bytes() * height_) in_.get();
  }

  [[noreturn]] void fail_at_end(int y) {
    fail(mark(), "the file ends in row " + std::to_string(y) + " of " + std::to_string(height_),
         "get the whole file, or correct the size");
  }

  void read_plain_row(int y, PixelRow& row) {
    for (int x = 0; x < width_; ++x) {
      skip_space();
      const Mark at = mark();
      std::int64_t level = 0;
      if (in_.peek() == ByteReader::kEnd) fail_at_end(y);
      if (bitmap_) {
        const int c = in_.get();
        if (c != '0' && c != '1') fail(at, "a pixel that is neither 0 nor 1", "correct it");
        level = c == '1' ? 0 : 1;
      } else {
        level = read_number("a grey level");
        if (level > white_)
          fail(at,
               "grey level " + std::to_string(level) + " lies above maxval, " +
                   std::to_string(white_),
               "correct either");
      }
      row.add(x, kinds_[level]);
    }
  }

  void read_bit_row(int y, PixelRow& row) {
    if (in_.read(bytes_.data(), bytes_.size()) < bytes_.size()) fail_at_end(y);
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      row.blocked[i >> 3] |= std::uint64_t{kReversed[static_cast<unsigned char>(bytes_[i])]}
                             << (i & 7) * 8;
    }
    if (rule_.numbers != nullptr) {
      for (int x = 0; x < width_; ++x)
        row.add(x, kinds_[1 - (row.blocked[x >> 6] >> (x & 63) & 1)]);
      std::ranges::fill(row.blocked, 0);
      return;
    }
    const auto chosen = [this](std::uint64_t black, int bit) {
      return ((kinds_[0] & bit) != 0 ? black : 0) | ((kinds_[1] & bit) != 0 ? ~black : 0);
    };
    for (std::size_t i = 0; i < row.blocked.size(); ++i) {
      const std::uint64_t black = row.blocked[i];
      row.blocked[i] = chosen(black, PixelRule::kBlocked);
      row.unknown[i] = chosen(black, PixelRule::kUnknown);
    }
  }

  void read_level_row(int y, PixelRow& row) {
    const std::int64_t start = in_.offset();
    if (in_.read(bytes_.data(), bytes_.size()) < bytes_.size()) fail_at_end(y);
    const int depth = white_ > 255 ? 2 : 1;
    const auto byte = [&](int i) noexcept {
      return static_cast<int>(static_cast<unsigned char>(bytes_[i]));
    };
    for (int x = 0; x < width_; ++x) {
      const int level = depth == 1 ? byte(x) : byte(2 * x) << 8 | byte(2 * x + 1);
      if (level > white_)
        fail(
            {in_.line(), start + std::int64_t{x} * depth},
            "grey level " + std::to_string(level) + " lies above maxval, " + std::to_string(white_),
            "correct either");
      row.add(x, kinds_[level]);
    }
  }

  void check_end() {
    if (plain_) skip_space();
    while (is_space(in_.peek())) in_.get();
    if (in_.peek() == ByteReader::kEnd) return;
    fail(mark(), "the file goes on after the last of " + size_text(width_, height_) + " pixels",
         "correct the size, or keep one image a file");
  }

  ByteReader& in_;
  const PixelRule& rule_;
  bool plain_ = false;   // ASCII
  bool bitmap_ = false;  // PBM
  int width_ = 0;
  int height_ = 0;
  int white_ = 1;
  std::vector<std::uint16_t> kinds_;  // by level
  std::vector<char> bytes_;           // of one binary row
};

}  // namespace

bool is_pnm(std::string_view head) noexcept {
  return head.size() > 2 && head[0] == 'P' &&
         (head[1] == '1' || head[1] == '2' || head[1] == '4' || head[1] == '5') &&
         (is_space(head[2]) || head[2] == '#');
}

Map read_pnm(ByteReader& in, const PixelRule& rule) { return PnmReader(in, rule).read(); }

void write_pbm(const Grid& grid, std::ostream& out) {
  out << "P4\n" << grid.width() << ' ' << grid.height() << '\n';
  std::vector<char> bytes((static_cast<std::size_t>(grid.width()) + 7) / 8);
  const unsigned padding = static_cast<unsigned>(bytes.size() * 8 - grid.width());
  for (int y = 0; y < grid.height(); ++y) {
    const std::uint64_t* words = grid.row(y);
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bytes[i] = static_cast<char>(kReversed[words[i >> 3] >> (i & 7) * 8 & 255]);
    // The grid's bits past the width are blocked; in a file they are 0.
    bytes.back() = static_cast<char>(static_cast<unsigned char>(bytes.back()) & (255U << padding));
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

}  // namespace lasius
