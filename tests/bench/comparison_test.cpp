#include "bench/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/base/error.h"
#include "lasius/grid/map_io.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"

namespace lasius::bench {
namespace {

using peers::Optimality;

using Queries = Files;
using Sources = Files;

TEST_F(Queries, AreReadFromTablesByTheirHeader) {
  const auto queries = read_queries(
      file("map\tgy\tgx\tsx\tsy\teuclid\nm\t4\t3\t1\t2\t2.5\n\nm\t0\t0\t9\t8\t1\n", "a.tsv"));
  ASSERT_EQ(queries.size(), 2u);
  EXPECT_EQ(queries[0].start, (Cell{1, 2}));
  EXPECT_EQ(queries[0].goal, (Cell{3, 4}));
  EXPECT_EQ(queries[0].optimum, 2.5);
  EXPECT_EQ(queries[1].start, (Cell{9, 8}));
}

TEST_F(Queries, AreReadFromScenarios) {
  const auto queries =
      read_queries(file("version 1.0\n0 m.map 49 49 1 11 2 12 1.41421356\n", "a.scen"));
  ASSERT_EQ(queries.size(), 1u);
  EXPECT_EQ(queries[0].start, (Cell{1, 11}));
  EXPECT_EQ(queries[0].goal, (Cell{2, 12}));
  EXPECT_TRUE(std::isnan(queries[0].optimum));  // the octile length is not the optimum
}

TEST_F(Queries, NameTheLineThatIsBroken) {
  for (const char* bad : {"1 2 3", "1 2 x 4", "1 2 3 99999999999999"}) {
    const auto table = file(std::string("sx sy gx gy\n1 2 3 4\n") + bad + "\n", "b.tsv");
    const Error error = error_of([&] { return read_queries(table); }, bad);
    EXPECT_EQ(error.code(), ErrorCode::file_broken);
    EXPECT_EQ(error.place().line, 3);
  }
  EXPECT_THROW(read_queries(file("sx sy gx\n", "c.tsv")), Error);
  EXPECT_THROW(read_queries(path("none.tsv")), Error);
}

TEST_F(Sources, AreFoundInFoldersAndByName) {
  write_map(Grid(8, 8), path("one.map"));
  write_map(Grid(8, 8), path("two.map"));
  file("sx sy gx gy\n0 0 1 1\n", "one.tsv");
  file("version 1\n0 two.map 8 8 0 0 2 2 2.8\n", "two.map.scen");
  const auto all = find_sources({folder()});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "one");
  EXPECT_EQ(all[1].table, path("two.map.scen"));
  EXPECT_EQ(load(all[1], 0).queries.at(0).goal, (Cell{2, 2}));
  EXPECT_EQ(find_sources({path("two.map.scen")}).at(0).map, path("two.map"));
  EXPECT_THROW(find_sources({path("three.map")}), Error);
}

TEST_F(Sources, GeneratedQueriesAreJoinedAndRepeatable) {
  const auto sources = generated_sources({64}, 3);
  EXPECT_EQ(sources.size(), map_kind_names().size() + 3);
  for (const QuerySource& source : sources) {
    const QuerySet a = load(source, 5), b = load(source, 5);
    ASSERT_EQ(a.queries.size(), 5u) << source.name;
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(a.queries[i].start, b.queries[i].start);
      std::vector<Point> path;
      const auto planner = peers::all_peers()[0].make(a.grid);
      EXPECT_LT(planner->plan(a.queries[i].start, a.queries[i].goal, path), peers::kNoPath)
          << source.name;
    }
  }
}

// Answers with the straight line, whatever lies between, times a factor.
template <int kPercent>
class Straight final : public peers::QueryPlanner {
 public:
  explicit Straight(const Grid&) {}
  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    path = {centre(start), centre(goal)};
    return kPercent / 100.0 * std::hypot(goal.x - start.x, goal.y - start.y);
  }
};
template <int kPercent>
std::unique_ptr<peers::QueryPlanner> straight(const Grid& grid) {
  return std::make_unique<Straight<kPercent>>(grid);
}

TEST(Comparison, FindsEveryKindOfFault) {
  QuerySet set{"wall", Grid(9, 9), {{{0, 0}, {8, 0}}, {{0, 8}, {8, 8}}}};
  for (int y = 0; y < 8; ++y) set.grid.set_blocked({4, y});
  const std::vector<peers::Peer> planners = {
      *std::find_if(peers::all_peers().begin(), peers::all_peers().end(),
                    [](const auto& p) { return p.optimality == Optimality::any_angle; }),
      peers::all_peers()[0],
      {"through", Optimality::none, straight<100>},
      {"liar", Optimality::none, straight<90>}};
  const MapComparison result = compare(set, planners, {.rounds = 2});
  for (std::size_t q = 0; q < 2; ++q) {
    EXPECT_EQ(result.planners[0].queries[q].fault, "");
    EXPECT_EQ(result.planners[1].queries[q].fault, "");
    EXPECT_EQ(result.planners[0].queries[q].rounds, 2);
    EXPECT_EQ(result.optima[q], result.planners[0].queries[q].length);
    EXPECT_EQ(result.planners[3].queries[q].fault, "the length is not the path's");
  }
  EXPECT_NE(result.planners[2].queries[0].fault, "");  // through the wall
  EXPECT_EQ(result.planners[2].queries[1].fault, "");  // nothing in the way
  EXPECT_EQ(result.mean_gap(0), 0);
  EXPECT_GT(result.mean_gap(1), 0);
  const std::vector<MapComparison> maps = {result};
  EXPECT_EQ(count_faults(maps), 3u);
}

TEST(Comparison, HoldsLengthsAgainstTheTable) {
  QuerySet set{"open", Grid(9, 9), {{{0, 0}, {3, 4}, 4.0}, {{0, 0}, {3, 4}, 6.0}}};
  const std::vector<peers::Peer> planners = {{"a", Optimality::any_angle, straight<100>}};
  const auto result = compare(set, planners, {.rounds = 1});
  EXPECT_EQ(result.planners[0].queries[0].fault, "longer than the optimum");
  EXPECT_EQ(result.planners[0].queries[1].fault, "shorter than the optimum");
}

TEST(Report, ShowsMeansRatiosAndFaults) {
  MapComparison map{"m", {1.0, 2.0}, {}};
  map.planners = {{1.5, 3e6, {{10, 1.0, 3, ""}, {30, 2.0, 3, ""}}},
                  {2.5, kUnknown, {{40, 1.1, 3, ""}, {80, 2.0, 3, "bad"}}}};
  const std::vector<peers::Peer> planners = {{"ours", Optimality::any_angle, straight<100>},
                                             {"theirs", Optimality::none, straight<100>}};
  EXPECT_EQ(map.planners[0].mean_microseconds(), 20);
  EXPECT_NEAR(map.mean_gap(1), 0.05, 1e-12);
  std::ostringstream out;
  write_markdown(out, std::vector{map}, planners, 0, {}, "seed 1");
  expect_says(out.str(), "| m | 20.0 | 60.0 |");
  expect_says(out.str(), "| m | 1.00 | 3.00 |");
  expect_says(out.str(), "| m | 0 | 5.00 |");
  expect_says(out.str(), "| m | 1.50 | 2.50 |");
  expect_says(out.str(), "| m | 3.00 | - |");
  expect_says(out.str(), "1 faults.");
  expect_says(out.str(), "query 1, theirs: bad");
}

TEST(Statistics, QuantilesAreMembersOfTheSample) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(quantile({5, 4, 3, 2, 1}, 0), 1);
  EXPECT_EQ(quantile({5, 4, 3, 2, 1}, 1), 5);
  EXPECT_EQ(largest({1, 7, 3}), 7);
}

TEST(Report, NumbersKeepThreeDigits) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(0.012345), "0.0123");
  EXPECT_EQ(short_number(1.5), "1.50");
  EXPECT_EQ(short_number(123456), "123456");
  EXPECT_EQ(short_number(std::nan("")), "-");
}

}  // namespace
}  // namespace lasius::bench
