#include "core/io/png_reader.h"

#include <png.h>

#include <exception>
#include <new>
#include <string>
#include <vector>

#include "core/io/png_errors.h"
#include "core/map_files/map_size.h"

namespace lasius {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::int64_t kMostDeflate = 1032;  // bytes that one byte of deflate data can stand for

class PngReader {
 public:
  PngReader(ByteReader& in, const PixelRule& rule) : in_(in), rule_(rule) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &errors_, PngErrors::on_error,
                                  PngErrors::on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  Map read() {
    if (info_ == nullptr) throw std::bad_alloc();
    read_header();
    Map map = rule_.map(width_, height_);
    if (!interlaced_) {
      read_pass({width_, height_, 0, 0, 1, 1}, map);
    } else {
      // Adam7 without libpng's help: a pass is a small image whose pixels lie apart.
      for (int k = 0; k < PNG_INTERLACE_ADAM7_PASSES; ++k) {
        const Pass pass{PNG_PASS_COLS(width_, k), PNG_PASS_ROWS(height_, k),
                        PNG_PASS_START_COL(k),    PNG_PASS_START_ROW(k),
                        PNG_PASS_COL_OFFSET(k),   PNG_PASS_ROW_OFFSET(k)};
        if (pass.columns > 0) read_pass(pass, map);
      }
    }
    guarded([this] { png_read_end(png_, nullptr); });
    return map;
  }

 private:
  struct Pass {
    int columns, rows, x, y, step_x, step_y;
  };

  static void on_read(png_structp png, png_bytep target, size_t count) {
    auto* self = static_cast<PngReader*>(png_get_io_ptr(png));
    std::size_t done = 0;
    try {
      done = self->in_.read(reinterpret_cast<char*>(target), count);
    } catch (...) {
      self->failure_ = std::current_exception();
    }
    if (done < count) png_error(png, "the file ends too early");
  }

  template <typename Call>
  void guarded(Call call) {
    if (!errors_.succeeds(png_, call)) fail();
  }
  [[noreturn]] void fail() const {
    if (failure_) std::rethrow_exception(failure_);
    in_.fail_at_offset(in_.offset(), std::string("broken PNG: ") + errors_.message(),
                       "get the whole file, or save the image again");
  }

  void read_header() {
    guarded([this] {
      png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
      // All chunks that pixels do not need are skipped: the shortest text may claim 2 GB.
      png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
      png_set_read_fn(png_, this, on_read);
      png_read_info(png_, info_);
    });
    constexpr std::int64_t kSizeOffset = 16;  // of IHDR, always the first chunk
    const SizePlace place{-1, kSizeOffset};
    const std::int64_t width = png_get_image_width(png_, info_);
    const std::int64_t height = png_get_image_height(png_, info_);
    check_map_size(in_, place, width, height);
    const auto stored_row = static_cast<std::int64_t>(png_get_rowbytes(png_, info_));
    check_bytes_left(in_, place, width, height, stored_row * height / kMostDeflate);

    indexed_ = png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE;
    guarded([this] {
      if (indexed_)
        png_set_packing(png_);
      else
        png_set_expand(png_);
      png_read_update_info(png_, info_);
    });
    if (indexed_) read_palette();
    width_ = static_cast<int>(width);
    height_ = static_cast<int>(height);
    interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
    depth_ = png_get_bit_depth(png_, info_) / 8;
    channels_ = indexed_ ? 4 : png_get_channels(png_, info_);
    white_ = depth_ == 1 ? 255 : 65535;
    kinds_ = rule_.table(white_);
    row_.resize(png_get_rowbytes(png_, info_));
  }

  // libpng's own expansion takes an index beyond the palette for black.
  void read_palette() {
    png_colorp colours = nullptr;
    png_bytep alphas = nullptr;
    int count = 0;
    int alpha_count = 0;
    png_get_PLTE(png_, info_, &colours, &count);
    png_get_tRNS(png_, info_, &alphas, &alpha_count, nullptr);
    for (int i = 0; i < count; ++i) {
      const png_byte alpha = i < alpha_count ? alphas[i] : 255;
      palette_.insert(palette_.end(), {colours[i].red, colours[i].green, colours[i].blue, alpha});
    }
  }

  void read_pass(const Pass& pass, Map& map) {
    for (int j = 0; j < pass.rows; ++j) {
      guarded([this] { png_read_row(png_, row_.data(), nullptr); });
      const int y = pass.y + j * pass.step_y;
      for (int i = 0; i < pass.columns; ++i) {
        const int kind = kind_of(pixel(i));
        const Cell cell{pass.x + i * pass.step_x, y};
        if (rule_.numbers != nullptr) {
          (*rule_.numbers)[static_cast<std::size_t>(y) * width_ + cell.x] =
              static_cast<std::uint16_t>(kind);
          continue;
        }
        if ((kind & PixelRule::kBlocked) != 0) map.grid.set_blocked(cell);
        if ((kind & PixelRule::kUnknown) != 0) map.unknown->set_blocked(cell);
      }
    }
  }

  const png_byte* pixel(int column) const {
    if (!indexed_) return row_.data() + std::ptrdiff_t{column} * channels_ * depth_;
    const std::size_t index = row_[column];
    if (4 * index >= palette_.size()) {
      in_.fail_at_offset(in_.offset(),
                         "broken PNG: a pixel has colour " + std::to_string(index) +
                             " of a palette that has " + std::to_string(palette_.size() / 4),
                         "save the image again");
    }
    return palette_.data() + 4 * index;
  }

  int kind_of(const png_byte* pixel) const noexcept {
    const auto sample = [&](std::ptrdiff_t i) noexcept -> std::int64_t {
      return depth_ == 1 ? pixel[i] : pixel[2 * i] << 8 | pixel[2 * i + 1];
    };
    const std::int64_t level = channels_ >= 3 ? luma(sample(0), sample(1), sample(2)) : sample(0);
    return rule_.kind_of(kinds_, level, channels_ % 2 == 0 ? sample(channels_ - 1) : white_);
  }

  ByteReader& in_;
  const PixelRule& rule_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  PngErrors errors_;
  std::exception_ptr failure_;

  int width_ = 0;
  int height_ = 0;
  bool interlaced_ = false;
  bool indexed_ = false;
  int depth_ = 0;     // bytes a sample
  int channels_ = 0;  // grey, grey + alpha, RGB, RGB + alpha
  int white_ = 255;
  std::vector<std::uint16_t> kinds_;  // by level
  std::vector<png_byte> palette_;     // RGBA, where pixels are its indices
  std::vector<png_byte> row_;
};

}  // namespace

bool is_png(std::string_view head) noexcept { return head.starts_with(kSignature); }

Map read_png(ByteReader& in, const PixelRule& rule) { return PngReader(in, rule).read(); }

}  // namespace lasius
