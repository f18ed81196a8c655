#include <gtest/gtest.h>

#include <utility>

#include "lasius/generate.h"
#include "lasius/tour/cover.h"
#include "tests/core/base/counting_time.h"

namespace lasius {
namespace {

// The longer it has, the better: of the same swaths never longer, and from the first on in an order
// that keeps to corridors, where ends of swaths that are near through a wall are not joined.
TEST(Cover, IsNotLongerTheLaterItIsCut) {
  const Planner planner(generate(MapKind::maze, {.width = 36, .height = 36, .seed = 3}), Disc{0.5});
  CoverRequest request;
  request.width = 1;
  request.threads = 1;
  request.generations = 0;
  const auto cost_of = [](const CoverResult& cover) { return cover.tour.length / cover.covered; };
  const CoverResult whole = plan_cover(planner, request);
  ASSERT_EQ(whole.tour.status, Status::solved);
  ASSERT_GT(whole.swaths(), 60);
  int cut = 0;
  CoverResult before;
  for (int polls = 0; polls < 1 << 16; polls += 1 + polls) {
    SCOPED_TRACE(polls);
    const CountingTime time(polls);
    request.stop = time.is_up();
    CoverResult cover = plan_cover(planner, request);
    if (cover.tour.status == Status::solved) break;
    ++cut;
    ASSERT_FALSE(cover.tour.order.empty());
    EXPECT_GT(cover.covered, 0.9 * whole.covered);
    EXPECT_LT(cost_of(cover), 1.3 * cost_of(whole));
    if (cover.stops == before.stops) {
      // Orders are compared in grains of 1/1000 cell a leg.
      EXPECT_LE(cover.tour.length,
                before.tour.length + 1e-3 * static_cast<double>(cover.tour.order.size()));
    }
    before = std::move(cover);
  }
  EXPECT_GT(cut, 10);
}

}  // namespace
}  // namespace lasius
