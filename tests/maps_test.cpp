// The maps of maps/: what its README says of them.
#include <gtest/gtest.h>

#include <string>

#include "lasius/generate.h"
#include "lasius/map_io.h"
#include "lasius/path.h"

namespace lasius {
namespace {

const std::string kFolder = LASIUS_MAPS_DIR;

TEST(Fan400x200, IsMadeByItsCommand) {
  const Grid grid = read_map(kFolder + "/fan400x200.map").grid;
  EXPECT_EQ(grid, generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  EXPECT_FALSE(visible(grid, {14, 14}, {380, 179}));
}

}  // namespace
}  // namespace lasius
