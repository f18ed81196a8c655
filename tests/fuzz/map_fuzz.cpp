// MovingAI maps, PBM, PGM and BMP. What is read stays the same when the size is unknown, and when
// it is written and read again.
#include "core/map_files/bmp.h"
#include "core/map_files/movingai.h"
#include "core/map_files/pnm.h"
#include "tests/fuzz/reading.h"

namespace lasius::fuzz {
namespace {

std::optional<Grid> read(const std::string& bytes, bool size_known) {
  const PixelRule rule = plain_rule(0.5);
  return read_bytes(bytes, size_known, [&](ByteReader& in) {
    if (is_movingai(in.ahead(8))) return read_movingai(in);
    return is_bmp(in.ahead(8)) ? read_bmp(in, rule).grid : read_pnm(in, rule).grid;
  });
}

template <typename Write>
std::string written(const Grid& grid, Write write) {
  std::ostringstream out;
  write(grid, out);
  return out.str();
}

}  // namespace

void check(const std::string& bytes) {
  if (!is_movingai(bytes) && !is_pnm(bytes) && !is_bmp(bytes)) return;
  const std::optional<Grid> grid = read(bytes, true);
  if (!grid) return;
  // Without the size, CR LF before a binary raster counts as white space and a pixel.
  if (bytes.find('\r') == std::string::npos) require(read(bytes, false) == grid);
  require(read(written(*grid, write_movingai), true) == grid);
  require(read(written(*grid, write_pbm), true) == grid);
}

}  // namespace lasius::fuzz
