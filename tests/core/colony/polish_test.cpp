#include "core/colony/polish.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <stop_token>
#include <vector>

#include "core/grid/move_rule.h"

namespace lasius {
namespace {

class Polishing : public testing::Test {
 protected:
  Polishing() {
    request_.stop.token = source_.get_token();
    polisher_.reset(grid_, request_, moves_, params_, 2, nullptr, TourMeasure(moves_, nullptr));
  }

  /// An ant that arrived by these moves.
  Ant ant(std::initializer_list<kernels::Offset> tour) const {
    Ant ant;
    ant.arrived = true;
    ant.moves.grow(tour.size());
    for (const kernels::Offset to : tour) {
      const auto is_it = [&](int k) {
        return moves_[k].to.dx == to.dx && moves_[k].to.dy == to.dy;
      };
      int k = 0;
      while (!is_it(k)) ++k;
      ant.moves.data()[ant.move_count++] = static_cast<std::uint8_t>(k);
    }
    return ant;
  }

  const Grid grid_{20, 20};
  const kernels::Moves moves_ = moves_of(Neighbours::four);
  const Params params_{"fan2004"};
  Request request_{.start = {2, 3}, .goal = {4, 4}};
  std::stop_source source_;
  Polisher polisher_;
};

TEST_F(Polishing, APathMadeAheadStaysThoughTimeIsUp) {
  std::vector<Ant> ants;
  for (int a = 0; a < 2; ++a) ants.push_back(ant({{1, 0}, {0, 1}, {1, 0}}));
  polisher_.polish_ahead(ants, 0, 0);
  source_.request_stop();
  polisher_.polish_ahead(ants, 0, 1);
  polisher_.polish(ants, request_.stop, {});
  EXPECT_EQ(polisher_.paths()[0].length, std::sqrt(5.0));
  EXPECT_EQ(polisher_.paths()[0].points.size(), 2u);
  EXPECT_TRUE(std::isnan(polisher_.paths()[1].length));
}

TEST_F(Polishing, APathMadeAheadIsOfOneIterationOnly) {
  std::vector<Ant> ants;
  ants.push_back(ant({{1, 0}, {0, 1}, {1, 0}}));
  polisher_.polish_ahead(ants, 0, 0);
  polisher_.polish(ants, request_.stop, {});
  ants[0] = ant({{1, 0}, {1, 0}, {0, 1}, {0, 1}, {0, 1}});
  polisher_.polish_ahead(ants, 0, 0);
  polisher_.polish(ants, request_.stop, {});
  EXPECT_EQ(polisher_.paths()[0].length, std::sqrt(13.0));
}

// Round the corner of a dear cell.
TEST_F(Polishing, OverCostsTheWayIsMadeCheaper) {
  std::vector<double> weights(400, 1.0);
  weights[3 * 20 + 3] = 2;
  const cost::Terrain terrain(grid_, weights);
  polisher_.reset(grid_, request_, moves_, params_, 1, nullptr, TourMeasure(moves_, &terrain));
  std::vector<Ant> ants;
  ants.push_back(ant({{1, 0}, {0, 1}, {1, 0}}));
  polisher_.polish(ants, request_.stop, {});
  EXPECT_NEAR(polisher_.paths()[0].length, std::sqrt(0.5) + std::sqrt(2.5), 1e-6);
}

}  // namespace
}  // namespace lasius
