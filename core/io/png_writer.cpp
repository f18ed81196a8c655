#include <png.h>

#include <new>
#include <ostream>
#include <string>
#include <vector>

#include "core/base/output.h"
#include "core/io/png_errors.h"
#include "lasius/base/error.h"
#include "lasius/io.h"

namespace lasius {
namespace {

class PngWriter {
 public:
  PngWriter(std::ostream& out, const std::string& path) : out_(out), path_(path) {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &errors_, PngErrors::on_error,
                                   PngErrors::on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, this, on_write, on_flush);
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

  /// 1 bit a pixel, grey.
  void start(int width, int height) {
    guarded([&] {
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                   1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                   PNG_FILTER_TYPE_DEFAULT);
      png_write_info(png_, info_);
    });
  }
  void row(const png_byte* bytes) {
    guarded([&] { png_write_row(png_, bytes); });
  }
  void finish() {
    guarded([&] { png_write_end(png_, nullptr); });
  }

 private:
  static void on_write(png_structp png, png_bytep bytes, size_t count) {
    auto* self = static_cast<PngWriter*>(png_get_io_ptr(png));
    self->out_.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    if (!self->out_) png_error(png, "the stream does not take more");
  }
  static void on_flush(png_structp) {}

  template <typename Call>
  void guarded(Call call) {
    if (!errors_.succeeds(png_, call)) fail();
  }
  [[noreturn]] void fail() const {
    throw Error(ErrorCode::output_failed, Error::Place{path_},
                std::string("could not be written (") + errors_.message() + ")",
                "check the free space");
  }

  std::ostream& out_;
  const std::string& path_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  PngErrors errors_;
};

// The eight cells from x on, leftmost in the highest bit, free = 1 = white.
png_byte eight_cells(const std::uint64_t* words, int x) noexcept {
  const std::uint64_t cells = ~words[x >> 6] >> (x & 63);
  unsigned byte = 0;
  for (int i = 0; i < 8; ++i) byte = byte << 1 | static_cast<unsigned>(cells >> i & 1);
  return static_cast<png_byte>(byte);
}

}  // namespace

void write_png(const Grid& grid, const std::string& path) {
  write_file(path, [&](std::ostream& out) {
    PngWriter png(out, path);
    png.start(grid.width(), grid.height());
    std::vector<png_byte> bytes((static_cast<std::size_t>(grid.width()) + 7) / 8);
    for (int y = 0; y < grid.height(); ++y) {
      for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = eight_cells(grid.row(y), static_cast<int>(8 * i));
      png.row(bytes.data());
    }
    png.finish();
  });
}

}  // namespace lasius
