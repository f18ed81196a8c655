#include "tools/study/sources/goritov2020.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tools/study/description/study_file.h"

namespace lasius::study {
namespace {

TEST(Goritov2020, TheQuestionsAreOfTheKindsThatTheReportSays) {
  const Study study = make_study("goritov2020");
  const ArmScenes scenes(study, LASIUS_MAPS_DIR);
  ASSERT_EQ(study.experiments.front().questions.size(), 10u);
  int closed = 0, detours = 0;
  for (const Question& question : study.experiments.front().questions) {
    const ArmGround& ground = scenes.ground(question);
    EXPECT_GT(ground.optimum, 0);
    EXPECT_GE(ground.detour, 1 - 1e-9);
    closed += !ground.straight;
    detours += ground.detour >= 1.5;
  }
  EXPECT_EQ(closed, 5);
  EXPECT_EQ(detours, 2);
}

TEST(Goritov2020, EverySweepOfTheSource) {
  const Study study = make_study("goritov2020");
  ASSERT_GE(study.experiments.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {  // pheromone on arcs and on edges
    const Experiment& reading = study.experiments[r];
    EXPECT_EQ(reading.contenders.front().name, "base");
    const auto count = [&](const std::string& sweep) {
      return std::ranges::count_if(
          reading.contenders, [&](const Contender& c) { return c.name.starts_with(sweep + "-"); });
    };
    // Without the base set's own value; gamma = 0, which the source gave up, is in.
    EXPECT_EQ(count("alpha"), 4);
    EXPECT_EQ(count("beta"), 1);
    EXPECT_EQ(count("gamma"), 4);
    EXPECT_EQ(count("rho"), 3);
    EXPECT_EQ(count("m"), 3);
    EXPECT_EQ(count("T"), 5);
    EXPECT_EQ(count("e"), 3);
  }
}

}  // namespace
}  // namespace lasius::study
