// Ways by small motions off the lattice.
#include "core/vehicle/escape.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/core/vehicle/dense_check.h"

namespace lasius::vehicle {
namespace {

TEST(Crossings, TellThePoseThatTheyBeginAt) {
  const Grid grid(60, 40);
  const Vehicle vehicle = car(rectangle(3, 5, 2), 5);
  const Space space(grid, vehicle);
  const Lattice lattice(vehicle, space.impl().outline());
  // The second is in the box of the first, which is looked at alone.
  const std::vector<Pose> from{{10.5, 20.5, 0}, {10.5 + 1e-6, 20.5, 0}, {30.5, 20.5, 0}};
  const auto left = [](int x, int) { return 60.0 - x; };
  const auto wanted = [](const Connector& c) { return c.x > 31; };
  std::int64_t checked = 0;
  Poller poller(kGoesOn);
  const std::vector<Crossing> found =
      crossings(space.impl(), lattice, from, left, wanted, {.cells = 8}, checked, poller);
  ASSERT_FALSE(found.empty());
  for (const Crossing& c : found) {
    EXPECT_EQ(c.from, 2);
    EXPECT_EQ(c.connector.motions.front().begin, from[2]);
  }
}

}  // namespace
}  // namespace lasius::vehicle
