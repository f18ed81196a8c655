// Stands in for gif.cpp where giflib is missing.
#include "tools/console/exit_code.h"
#include "tools/drive/gif.h"

namespace lasius::tool {

void check_films() {
  throw UsageError(
      "-o: films (.gif) are not in this program; install libgif-dev and build with "
      "-DLASIUS_BUILD_FILM=ON");
}

void write_gif(std::ostream&, std::span<const Colour>, const std::vector<Raster<std::uint8_t>>&,
               int) {
  check_films();
}

}  // namespace lasius::tool
