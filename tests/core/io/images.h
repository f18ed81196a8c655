// Images made by tests, and files in a folder of the test's own that are read again.
#pragma once

#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

#include "lasius/io.h"
#include "tests/core/base/made_files.h"

namespace lasius {

using Bytes = std::vector<std::uint8_t>;

struct TestImage {
  int width, height;
  int depth, colour;
  std::vector<Bytes> rows;  // as PNG stores them
  bool interlaced = false;
  std::vector<png_color> palette = {};
  Bytes palette_alpha = {};
  int transparent_grey = -1;
};

inline void on_bytes(png_structp png, png_bytep bytes, size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

/// Made by libpng itself; a mistake in a test image aborts the test program.
inline std::string png_of(const TestImage& image) {
  std::string content;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &content, on_bytes, nullptr);
  png_set_check_for_invalid_index(png, -1);  // tests have some
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), image.depth, image.colour,
               image.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!image.palette.empty()) {
    png_set_PLTE(png, info, image.palette.data(), static_cast<int>(image.palette.size()));
  }
  if (!image.palette_alpha.empty()) {
    png_set_tRNS(png, info, image.palette_alpha.data(),
                 static_cast<int>(image.palette_alpha.size()), nullptr);
  }
  if (image.transparent_grey >= 0) {
    png_color_16 grey{};
    grey.gray = static_cast<png_uint_16>(image.transparent_grey);
    png_set_tRNS(png, info, nullptr, 0, &grey);
  }
  std::vector<png_bytep> rows;
  for (const Bytes& row : image.rows) rows.push_back(const_cast<png_bytep>(row.data()));
  png_set_rows(png, info, rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return content;
}

class Io : public Files {
 protected:
  Grid read_image(const TestImage& image, const ReadOptions& options = {}) const {
    return read_any_map(file(png_of(image), "image.png"), options).grid;
  }
};

}  // namespace lasius
