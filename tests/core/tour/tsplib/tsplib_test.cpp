#include "lasius/tour/tsplib.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/tour/order/search.h"
#include "lasius/base/error.h"
#include "lasius/tour/tour.h"
#include "tests/core/base/refusal.h"
#include "tests/oracle/least_tour.h"

namespace lasius::tour {
namespace {

Tsplib read(const std::string& text) {
  std::istringstream in(text);
  return read_tsplib(in, "stops.tsp");
}

TEST(Tsplib, RoundsAsItsRulesSay) {
  const auto cost = [](const std::string& rule, const std::string& places) {
    return read("TYPE: TSP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: " + rule + "\nNODE_COORD_SECTION\n" +
                places + "EOF\n")
        .matrix[1];
  };
  EXPECT_EQ(cost("EUC_2D", "1 0 0\n2 1 1\n"), 1);
  EXPECT_EQ(cost("CEIL_2D", "1 0 0\n2 1 1\n"), 2);
  EXPECT_EQ(cost("MAN_2D", "1 0 0\n2 3 4\n"), 7);
  EXPECT_EQ(cost("MAX_2D", "1 0 0\n2 3 4\n"), 4);
  EXPECT_EQ(cost("ATT", "1 0 0\n2 3 4\n"), 2);                    // sqrt(2.5) up
  EXPECT_EQ(cost("GEO", "1 38.24 20.42\n2 39.57 26.15\n"), 509);  // ulysses16, stops 1 and 2
  EXPECT_EQ(cost("GEO", "1 38.24 20.42\n2 38.24 20.42\n"), 1);    // one place
  EXPECT_EQ(cost("GEO", "1 10.30 20\n2 -10.30 -160\n"), 20039);   // half a turn about the earth
  EXPECT_THROW(cost("GEO", "1 0 0\n2 1e9 0\n"), Error);
}

TEST(Tsplib, DisplayDataAreForPicturesAlone) {
  const std::string display = "DISPLAY_DATA_SECTION\n1 0 0\n2 90 0\n";
  const std::string nodes = "NODE_COORD_SECTION\n1 0 0\n2 7 0\n";
  const std::string head = "DIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\n";
  for (const std::string& text : {head + nodes + display, head + display + nodes}) {
    const Tsplib both = read(text);
    EXPECT_EQ(both.matrix[1], 7) << text;
    EXPECT_EQ(both.places[1], (Point{7, 0})) << text;
  }
  EXPECT_THROW(read(head + display), Error);
  const Tsplib given = read(
      "DIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: UPPER_ROW\n"
      "EDGE_WEIGHT_SECTION\n5\n" +
      display);
  EXPECT_EQ(given.matrix[1], 5);
  EXPECT_EQ(given.places[1], (Point{90, 0}));
}

TEST(Tsplib, ReadsHalvesOfAMatrixAlike) {
  const std::string head =
      "TYPE : TSP\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_FORMAT : ";
  const std::vector<Cost> full = {0, 1, 2, 1, 0, 3, 2, 3, 0};
  for (const char* rest :
       {"FULL_MATRIX\nEDGE_WEIGHT_SECTION\n0 1 2 1 0\n3 2 3 0\n",
        "UPPER_ROW\nEDGE_WEIGHT_SECTION\n1 2 3\n", "LOWER_ROW\nEDGE_WEIGHT_SECTION\n1\n2 3\n",
        "UPPER_DIAG_ROW\nEDGE_WEIGHT_SECTION\n0 1 2 0 3 0\n",
        "LOWER_DIAG_ROW\nEDGE_WEIGHT_SECTION\n0 1 0 2 3 0\nEOF"})
    EXPECT_EQ(read(head + rest).matrix, full) << rest;
  const Tsplib sop = read(
      "NAME: x\nTYPE: SOP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: "
      "FULL_MATRIX\n"
      "EDGE_WEIGHT_SECTION\n2\n0 5\n-1 0\nEOF\n");
  EXPECT_TRUE(sop.ordered);
  EXPECT_EQ(sop.matrix, (std::vector<Cost>{0, 5, -1, 0}));
}

TEST(Tsplib, NamesTheLineOfWhatIsBroken) {
  const std::string two = "DIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n";
  const std::string full =
      "DIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\n"
      "EDGE_WEIGHT_SECTION\n";
  const std::string sop = "TYPE: SOP\n" + full + "2\n";
  const std::tuple<std::string, int, const char*> broken[] = {
      {"", 1, "no DIMENSION"},
      {"NAME: x\n\n", 2, "no DIMENSION"},
      {"DIMENSION: 0\n", 1, "1 to 20000"},
      {"DIMENSION: 2\nDIMENSION: 3\n", 2, "given again"},
      {two + "1 0 x\n", 4, "'x' is not a number"},
      {two + "1 0 1\n", 4, "node 2 is missing of DIMENSION, 2"},
      {two + "2 0 1\nEOF\n", 5, "node 1 is missing"},
      {two + "1 0 1\n\n1 0 2\n", 6, "node 1 is given again, first on line 4"},
      {two + "1 0 1\n3 0 2\n", 5, "node 3 is none of 1 to DIMENSION, 2"},
      {two + "0 0 1\n1 0 2\n", 4, "node 0 is none"},
      {two + "1.5 0 1\n", 4, "node 1.5 is none"},
      {two + "1 0 1 0\n", 4, "4 numbers in place of 3"},
      {two + "1 0 1\n2 0 2\n3 0 3\nEOF\n", 6, "more data than DIMENSION, 2"},
      {two + "2 0 1e30\n1 0 1\n", 4, "from node 1 to node 2 it is 1e+30"},
      {"DIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC2D\nNODE_COORD_SECTION\n1 0 0\n2 1 1\n", 2, "'EUC2D'"},
      {"DIMENSION: 2\nNODE_COORD_SECTION\n1 0 0\n2 1 1\n", 4, "no EDGE_WEIGHT_TYPE"},
      {"DIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\nEOF\n", 3, "no EDGE_WEIGHT_SECTION"},
      {"NODE_COORD_SECTION\n1 0 1\n", 1, "no DIMENSION"},
      {"TYPE: CVRP\n", 1, "CVRP"},
      {full + "0 1\n2 0\n", 6, "not symmetric"},
      {full + "0 1\n1\nEOF\n", 7, "DIMENSION, 2"},
      {full + "0 1\n1 0 3\nEOF\n", 6, "more data"},
      {"DIMENSION: 2\nEDGE_WEIGHT_FORMAT: HALF\nEDGE_WEIGHT_SECTION\n0 1\n", 2, "'HALF'"},
      {sop + "0 -1\n-1 0\n", 8, "circle: node 1 before node 2 before node 1"},
      {"TYPE: SOP\n" + two + "1 0 0\n2 1 1\n", 6, "no EDGE_WEIGHT_SECTION"}};
  for (const auto& [text, line, words] : broken) expect_refused_at(read, text, line, words);
  EXPECT_EQ(read(two + "2 3 4\n1 0 0\n").places, (std::vector<Point>{{0, 0}, {3, 4}}));
}

// By subsets up to twelve nodes, by the search above: three rows of nodes to be taken in order.
TEST(Tsplib, SequentialOrderingIsAsGoodAsTheBestOfAllOrders) {
  for (const int inner : {6, 9, 12})
    for (unsigned word = 1; word <= 4; ++word) {
      const int n = inner + 2;
      std::vector<std::vector<int>> costs(n, std::vector<int>(n));
      unsigned next = word;
      for (auto& row : costs)
        for (int& cost : row) cost = static_cast<int>((next = next * 1664525u + 1013904223u) >> 25);
      for (int a = 1; a < n; ++a) costs[a][0] = -1;
      for (int b = 1; b < n - 1; ++b) costs[n - 1][b] = -1;
      for (int b = 4; b < n - 1; ++b)
        for (int a = b - 3; a > 0; a -= 3) costs[b][a] = -1;
      std::string text =
          "TYPE: SOP\nDIMENSION: " + std::to_string(n) +
          "\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\nEDGE_WEIGHT_SECTION\n" +
          std::to_string(n) + "\n";
      TourRequest request, asked;
      asked.open = true;
      asked.after.resize(n);
      std::vector<double> legs;
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          text += std::to_string(a == b ? 0 : costs[a][b]) + " ";
          legs.push_back(costs[a][b]);
          if (costs[a][b] < 0) asked.after[a].push_back(b);
        }
      request.generations = 5;
      const TourResult tour = plan_tour(read(text + "\nEOF\n"), request);
      EXPECT_EQ(tour.length, oracle::LeastTour(asked, legs).length()) << n << " " << word;
      EXPECT_EQ(tour.optimal, n <= 12);
      for (std::size_t i = 0; i < tour.order.size(); ++i)
        for (std::size_t j = i + 1; j < tour.order.size(); ++j)
          EXPECT_GE(costs[tour.order[i]][tour.order[j]], 0);
    }
}

TEST(Tsplib, ProblemsUpTo280StopsAreSolved) {
  const std::filesystem::path folder = std::filesystem::path(LASIUS_SHARED_DIR) / "data/tsplib";
  std::ifstream optima(folder / "optima.txt");
  if (!optima) GTEST_SKIP() << "no TSPLIB at " << folder;
  std::string name, colon;
  std::int64_t optimum = 0;
  int solved = 0;
  while (optima >> name >> colon >> optimum) {
    std::ifstream in(folder / (name + ".tsp"));
    const Tsplib problem = read_tsplib(in, name);
    if (problem.size > 280) continue;
    OrderOptions options;
    options.generations = 200;
    options.target = optimum;
    EXPECT_EQ(find_order({problem.size, problem.matrix.data()}, {}, problem.places, options).cost,
              optimum)
        << name;
    ++solved;
  }
  EXPECT_GE(solved, 6);
}

}  // namespace
}  // namespace lasius::tour
