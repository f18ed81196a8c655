#include "core/map_files/bmp.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/map_files/map_size.h"

namespace lasius {
namespace {

constexpr std::size_t kFileHeader = 14;
constexpr std::int64_t kCoreHeader = 12, kInfoHeader = 40, kWithAlpha = 56;
constexpr std::array<std::int64_t, 7> kHeaders{kCoreHeader, kInfoHeader, 52, kWithAlpha,
                                               64,          108,         124};
constexpr std::int64_t kSizeOffset = 18;
constexpr std::int64_t kPlain = 0, kBitFields = 3;  // compressions
constexpr int kWhite = 255;

class BmpReader {
 public:
  BmpReader(ByteReader& in, const PixelRule& rule)
      : in_(in), rule_(rule), kinds_(rule.table(kWhite)) {}

  Map read() {
    read_header();
    if (bits_ <= 8) read_palette();
    skip_to_pixels();
    Map map = rule_.map(width_, height_);
    PixelRow row(map.grid, rule_);
    row_.resize(static_cast<std::size_t>((std::int64_t{width_} * bits_ + 31) / 32 * 4));
    for (int i = 0; i < height_; ++i) {
      const std::size_t used = (static_cast<std::size_t>(width_) * bits_ + 7) / 8;
      if (in_.read(row_.data(), row_.size()) < used)  // the last row's padding may be missing
        fail("the file ends in row " + std::to_string(i) + " of " + std::to_string(height_),
             "get the whole file");
      for (int x = 0; x < width_; ++x) row.add(x, kind_at(x));
      row.end(top_down_ ? i : height_ - 1 - i, map);
    }
    return map;
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy,
                         ErrorCode code = ErrorCode::file_broken) const {
    in_.fail_at_offset(in_.offset(), "broken BMP: " + problem, remedy, code);
  }
  [[noreturn]] void refuse(std::int64_t offset, const std::string& problem) const {
    in_.fail_at_offset(offset, problem, "save it without compression, with 1, 4, 8, 24 or 32 bits",
                       ErrorCode::file_unsupported);
  }

  /// More bytes of the header, of which `header_` holds all.
  void read_more(std::size_t count) {
    const std::size_t before = header_.size();
    header_.resize(before + count);
    if (in_.read(header_.data() + before, count) < count)
      fail("the file ends in its header", "get the whole file");
  }
  /// The number of some bytes of the header, the least first.
  std::int64_t number(std::size_t at, int bytes) const {
    std::int64_t value = 0;
    for (int i = bytes - 1; i >= 0; --i)
      value = value << 8 | static_cast<unsigned char>(header_[at + static_cast<std::size_t>(i)]);
    return value;
  }
  std::int64_t signed_number(std::size_t at) const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(number(at, 4)));
  }

  void read_header() {
    read_more(kFileHeader + 4);
    const std::int64_t size = number(kFileHeader, 4);
    if (std::ranges::find(kHeaders, size) == kHeaders.end())
      refuse(kFileHeader, "this BMP's header of " + std::to_string(size) + " bytes is not known");
    read_more(static_cast<std::size_t>(size) - 4);
    const bool core = size == kCoreHeader;
    entry_ = core ? 3 : 4;
    const std::int64_t width = core ? number(18, 2) : signed_number(18);
    const std::int64_t height = core ? number(20, 2) : signed_number(22);
    const std::int64_t bits = number(core ? 24 : 28, 2);
    const std::int64_t compression = core ? kPlain : number(30, 4);
    top_down_ = height < 0;
    check_map_size(in_, {-1, kSizeOffset}, width, std::abs(height));
    width_ = static_cast<int>(width);
    height_ = static_cast<int>(std::abs(height));
    const bool known = bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32;
    if (!known || (compression != kPlain && (compression != kBitFields || bits != 32)))
      refuse(kSizeOffset, "this BMP has " + std::to_string(bits) + " bits a pixel, compression " +
                              std::to_string(compression));
    bits_ = static_cast<int>(bits);
    if (compression == kBitFields) read_masks(size);
    colours_ = core ? 0 : number(46, 4);
  }

  void read_masks(std::int64_t size) {
    constexpr std::size_t kMasks = 54;
    if (size == kInfoHeader) read_more(12);
    if (number(kMasks, 4) != 0xff0000 || number(kMasks + 4, 4) != 0xff00 ||
        number(kMasks + 8, 4) != 0xff)
      refuse(kMasks, "this BMP's colours do not lie as blue, green, red, a byte each");
    alpha_ = size >= kWithAlpha && number(kMasks + 12, 4) == 0xff000000;
  }

  void read_palette() {
    const std::int64_t most = std::int64_t{1} << bits_;
    if (colours_ > most)
      fail("a palette of " + std::to_string(colours_) + " colours for pixels of " +
               std::to_string(bits_) + " bits",
           "save the image again");
    const std::size_t from = header_.size();
    const auto count = static_cast<std::size_t>(colours_ == 0 ? most : colours_);
    read_more(count * entry_);
    for (std::size_t at = from; at < header_.size(); at += entry_)
      palette_.push_back(kinds_[grey(header_.data() + at)]);
  }

  void skip_to_pixels() {
    const std::int64_t skipped = number(10, 4) - static_cast<std::int64_t>(header_.size());
    if (skipped < 0) fail("its pixels begin before its header ends", "save the image again");
    const std::int64_t row = (std::int64_t{width_} * bits_ + 31) / 32 * 4;
    check_bytes_left(in_, {-1, kSizeOffset}, width_, height_, skipped + row * height_ - 3);
    for (std::int64_t i = 0; i < skipped; ++i)
      if (in_.get() == ByteReader::kEnd)
        fail("the file ends before its pixels", "get the whole file");
  }

  static std::size_t grey(const char* pixel) noexcept {
    const auto part = [pixel](int i) { return static_cast<unsigned char>(pixel[i]); };
    return static_cast<std::size_t>(luma(part(2), part(1), part(0)));
  }
  int kind_at(int x) const {
    if (bits_ > 8) {
      const char* pixel = row_.data() + std::ptrdiff_t{x} * (bits_ / 8);
      const int alpha = alpha_ ? static_cast<unsigned char>(pixel[3]) : kWhite;
      return rule_.kind_of(kinds_, static_cast<std::int64_t>(grey(pixel)), alpha);
    }
    const int bit = x * bits_;
    const int byte = static_cast<unsigned char>(row_[static_cast<std::size_t>(bit / 8)]);
    const int colour = byte >> (8 - bits_ - bit % 8) & ((1 << bits_) - 1);
    if (static_cast<std::size_t>(colour) >= palette_.size())
      fail("a pixel has colour " + std::to_string(colour) + " of a palette that has " +
               std::to_string(palette_.size()),
           "save the image again");
    return palette_[static_cast<std::size_t>(colour)];
  }

  ByteReader& in_;
  const PixelRule& rule_;
  std::vector<std::uint16_t> kinds_;  // by grey level
  std::string header_;                // file header, header, masks, palette
  std::size_t entry_ = 4;             // bytes of a colour of the palette
  std::int64_t colours_ = 0;          // of the palette; 0: as many as pixels can tell
  std::vector<std::uint16_t> palette_;
  std::vector<char> row_;
  int width_ = 0;
  int height_ = 0;
  int bits_ = 0;  // a pixel
  bool top_down_ = false;
  bool alpha_ = false;
};

}  // namespace

bool is_bmp(std::string_view head) noexcept { return head.starts_with("BM"); }

Map read_bmp(ByteReader& in, const PixelRule& rule) { return BmpReader(in, rule).read(); }

}  // namespace lasius
