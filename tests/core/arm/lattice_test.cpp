#include "core/arm/lattice.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/arm/lattice_ants.h"
#include "core/arm/lattice_trail.h"
#include "core/loop/trail_rules.h"
#include "tests/core/arm/questions.h"

namespace lasius::arm {
namespace {

constexpr Box kBox{{-2, -2, 0}, {2, 2, 0}};

/// A lattice of the planar arm of 5 x 5 points about a bent position, nothing in the way.
struct Plane {
  Robot robot = two_links();
  Nothing sensor;
  Kinematics arm{robot};
  JointVector start = joints({0.6, 1.2});
  Params parameters{"goritov2020"};
  std::array<int, 3> goal{2, 0, 0};

  Lattice lattice(std::array<int, 3> to) {
    const Vec3 from = tip_position(robot, start);
    const Vec3 at{from.x + 0.02 * to[0], from.y + 0.02 * to[1], from.z + 0.02 * to[2]};
    return {robot, arm, sensor, start, 0.02, kBox, {{{to, at, 0}}, {}}, parameters};
  }
};

TEST(Lattice, GuidanceByHand) {
  // u = 1 / (1 + theta): towards the goal 1, across 1 / (1 + pi/2), away 1 / (1 + pi); to the power
  // of gamma (eq. 9).
  Plane plane;
  plane.parameters.gamma = 2;
  Lattice lattice = plane.lattice({2, 0, 0});
  ASSERT_NE(lattice.configuration(lattice.start()), nullptr);
  const float* u = lattice.guidance(lattice.start());
  const auto squared = [](double theta) { return 1 / ((1 + theta) * (1 + theta)); };
  EXPECT_NEAR(u[0], 1, 1e-6);
  EXPECT_NEAR(u[1], squared(std::numbers::pi), 1e-6);
  for (const int k : {2, 3, 4, 5}) EXPECT_NEAR(u[k], squared(std::numbers::pi / 2), 1e-6);

  // Seen from (0, 1, 0), the goal (1, 2, 0) lies half way between +x and +y.
  Lattice slanted = plane.lattice({1, 2, 0});
  const Node v = slanted.node({0, 1, 0});
  ASSERT_NE(slanted.configuration(v), nullptr);
  const double eighth = std::numbers::pi / 4;
  EXPECT_NEAR(slanted.guidance(v)[0], squared(eighth), 1e-6);
  EXPECT_NEAR(slanted.guidance(v)[1], squared(3 * eighth), 1e-6);
  EXPECT_NEAR(slanted.guidance(v)[2], squared(eighth), 1e-6);
}

TEST(Lattice, JointValuesAreAFunctionOfThePointAlone) {
  Plane plane;
  Lattice one = plane.lattice({2, 0, 0}), other = plane.lattice({2, 0, 0});
  // Asked in opposite orders.
  std::vector<Node> nodes;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) nodes.push_back(one.node({x, y, 0}));
  }
  for (const Node v : nodes) one.configuration(v);
  for (auto v = nodes.rbegin(); v != nodes.rend(); ++v) other.configuration(*v);
  for (const Node v : nodes) {
    const double *a = one.configuration(v), *b = other.configuration(v);
    ASSERT_EQ(a == nullptr, b == nullptr);
    if (a == nullptr) continue;
    EXPECT_EQ(a[0], b[0]);
    EXPECT_EQ(a[1], b[1]);
  }
  EXPECT_EQ(one.configuration(one.node({3, 0, 0})), nullptr) << "outside of the box";
}

/// Notes where the values that it is asked about are.
class Addresses final : public Nothing {
 public:
  bool position_free(const JointRef& q) const override {
    position = q.data();
    return true;
  }
  bool motion_free(const JointRef& a, const JointRef& b) const override {
    from = a.data();
    to = b.data();
    return true;
  }

  mutable const double *position = nullptr, *from = nullptr, *to = nullptr;
};

TEST(Lattice, SensorsReadItsOwnValuesNotCopies) {
  const Plane plane;
  const Addresses sensor;
  const Vec3 tip = tip_position(plane.robot, plane.start);
  Lattice lattice(plane.robot, plane.arm, sensor, plane.start, 0.02, kBox,
                  {{{plane.goal, tip, 0}}, {}}, plane.parameters);
  const Node at = lattice.start(), next = lattice.to(at, 0);
  ASSERT_TRUE(lattice.open(at, 0));
  EXPECT_EQ(sensor.position, lattice.configuration(next));
  EXPECT_EQ(sensor.from, lattice.configuration(at));
  EXPECT_EQ(sensor.to, lattice.configuration(next));
}

TEST(LatticeAnts, FirstMovesFollowTheRandomProportionalRule) {
  // Weights tau^alpha u^gamma of the six moves out of the start; +-z has no joint values. Seven
  // tenths of sigma-free counts: 40000 draws, 5 standard deviations.
  Plane plane;
  plane.parameters.ants = 40000;
  plane.parameters.gamma = 1;
  plane.parameters.alpha = 2;
  Lattice lattice = plane.lattice({2, 0, 0});
  LatticeTrail trail(lattice, Pheromone::arcs, 1, plane.parameters.alpha);
  trail.deposit(trail.place(lattice.start(), 2), 0.5);  // +y
  trail.refresh();
  LatticeAnts walkers(lattice, trail, plane.parameters);
  std::vector<LatticeAnt> ants(plane.parameters.ants);
  walkers.walk(0, ants, {});
  std::array<int, kTipMoves> count{};
  for (const LatticeAnt& ant : ants) {
    ASSERT_TRUE(ant.arrived);
    ++count[ant.moves.front()];
  }
  const double across = 1 / (1 + std::numbers::pi / 2), away = 1 / (1 + std::numbers::pi);
  const std::array<double, kTipMoves> weight{1, away, 2.25 * across, across, 0, 0};
  // Steps taken back change a first move now and then: an ant that went -x may find itself walled
  // in by its own visits. On 5 x 5 points that is rare: 2% of room.
  double total = 0;
  for (const double w : weight) total += w;
  for (int k = 0; k < kTipMoves; ++k) {
    const double share = weight[k] / total;
    EXPECT_NEAR(count[k] / 40000.0, share, 0.02 + 5 * std::sqrt(share / 40000)) << k;
  }
  EXPECT_EQ(count[4] + count[5], 0);
}

struct HandTour {
  std::vector<int> places;
  double length;
};
struct HandTours {
  std::vector<HandTour> ants;
  template <class Visit>
  void along(const HandTour& tour, const Visit& visit) const {
    for (const int place : tour.places) visit(place);
  }
};

TEST(LatticeTrail, UpdatesByHand) {
  // Two ants over places 1, 2 and 2, 3 of lengths 4 and 2; rho = 0.25, tau0 = 8 (eq. 10), then
  // e = 3 on the second (eq. 11, 12).
  Plane plane;
  const Lattice lattice = plane.lattice({2, 0, 0});
  const HandTours tours{{{{1, 2}, 4}, {{2, 3}, 2}}};
  lasius::Params params;
  params.persistence = 0.75;
  params.deposit = 1;
  params.elite_weight = 3;
  LatticeTrail plain(lattice, Pheromone::arcs, 8, 1), elite(lattice, Pheromone::arcs, 8, 1);
  trail_rules::ant_system(plain, params, tours);
  EXPECT_DOUBLE_EQ(plain.tau(0), 6);
  EXPECT_DOUBLE_EQ(plain.tau(1), 6.25);
  EXPECT_DOUBLE_EQ(plain.tau(2), 6.75);
  EXPECT_DOUBLE_EQ(plain.tau(3), 6.5);
  trail_rules::elitist(elite, params, tours, tours.ants[1]);
  EXPECT_DOUBLE_EQ(elite.tau(1), 6.25);
  EXPECT_DOUBLE_EQ(elite.tau(2), 8.25);
  EXPECT_DOUBLE_EQ(elite.tau(3), 8);

  // What ants read: ratios of tau^alpha.
  LatticeTrail cubed(lattice, Pheromone::arcs, 8, 3);
  trail_rules::ant_system(cubed, params, tours);
  cubed.refresh();
  EXPECT_NEAR(cubed.attraction(2) / cubed.attraction(0), std::pow(6.75 / 6, 3), 1e-9);
}

TEST(LatticeTrail, LongEvaporationKeepsRatiosAndForgetsEverythingAtRhoOne) {
  Plane plane;
  const Lattice lattice = plane.lattice({2, 0, 0});
  LatticeTrail trail(lattice, Pheromone::arcs, 1, 1);
  trail.deposit(5, 3);
  for (int i = 0; i < 120; ++i) trail.evaporate(0.75);  // 2^-50: stored values are rescaled
  trail.refresh();
  EXPECT_DOUBLE_EQ(trail.attraction(5) / trail.attraction(6), 4);
  trail.evaporate(0);
  trail.deposit(7, 1);
  trail.refresh();
  EXPECT_GT(trail.attraction(7), 1e9 * trail.attraction(5));
  EXPECT_GT(trail.attraction(5), 0);
}

TEST(LatticeTrail, EdgesShareTheirPheromoneArcsDoNot) {
  Plane plane;
  const Lattice lattice = plane.lattice({2, 0, 0});
  const LatticeTrail arcs(lattice, Pheromone::arcs, 1, 1), edges(lattice, Pheromone::edges, 1, 1);
  const Node a = lattice.start();
  for (int k = 0; k < kTipMoves; ++k) {
    const Node b = lattice.to(a, k);
    EXPECT_EQ(edges.place(a, k), edges.place(b, k ^ 1));
    EXPECT_NE(arcs.place(a, k), arcs.place(b, k ^ 1));
  }
}

}  // namespace
}  // namespace lasius::arm
