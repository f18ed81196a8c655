#include "lasius/tsplib.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/tour/order/search.h"
#include "lasius/error.h"

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
  const std::pair<const char*, int> broken[] = {
      {"DIMENSION: 0\n", 1},
      {"DIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 x\n", 4},
      {"DIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 1\n", 4},
      {"DIMENSION: 2\nNODE_COORD_SECTION\n1 0 1\n2 0 1e30\nEDGE_WEIGHT_TYPE: EUC_2D\n", 5},
      {"NODE_COORD_SECTION\n1 0 1\n", 1},
      {"TYPE: CVRP\n", 1},
      {"DIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\n"
       "EDGE_WEIGHT_SECTION\n0 1\n2 0\n",
       6}};
  for (const auto& [text, line] : broken) try {
      read(text);
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.place().line, line) << text;
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
