#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tools/study/sources/goritov2020.h"
#include "tools/study/sources/goritov2020_measures.h"

namespace lasius::study {
namespace {

TEST(Goritov2020, TheQuestionsAreOfTheKindsThatTheReportSays) {
  const auto grounds = arm_grounds(LASIUS_MAPS_DIR "/arms/industrial6.json");
  ASSERT_EQ(grounds.size(), 10u);
  int closed = 0, detours = 0;
  for (const ArmGround& ground : grounds) {
    EXPECT_GT(ground.optimum, 0);
    EXPECT_GE(ground.detour, 1 - 1e-9);
    closed += !ground.straight;
    detours += ground.detour >= 1.5;
  }
  EXPECT_EQ(closed, 5);
  EXPECT_EQ(detours, 2);
}

TEST(Goritov2020, EverySweepOfTheSource) {
  const auto settings = arm_settings();
  EXPECT_EQ(settings.front().name(), "base");
  const auto count = [&](const std::string& sweep) {
    return std::count_if(settings.begin(), settings.end(),
                         [&](const ArmSetting& s) { return s.sweep == sweep; });
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

/// All settings with the same runs: one question, `seeds` runs of 100 iterations.
ArmFindings level(int seeds) {
  ArmFindings findings{.seeds = seeds,
                       .questions = {{1, 0}},
                       .grounds = {ArmGround{}},
                       .settings = arm_settings(),
                       .runs = {}};
  for (auto& reading : findings.runs) {
    reading.resize(findings.settings.size());
    for (auto& setting : reading) {
      setting.resize(1);
      for (int s = 0; s < seeds; ++s) {
        ArmRun run;
        run.steps = 1000;
        for (int i = 0; i < 100; ++i) {
          run.best.push_back(i < 50 ? 1.5 : 1.2);
          run.mean.push_back(10 + std::sin(i + s));
        }
        setting[0].push_back(run);
      }
    }
  }
  return findings;
}

std::vector<ArmRun>& of(ArmFindings& findings, const std::string& name) {
  for (std::size_t i = 0; i < findings.settings.size(); ++i) {
    if (findings.settings[i].name() == name) return findings.runs[0][i][0];
  }
  throw std::logic_error("no such setting");
}

Verdict verdict(const ArmFindings& findings, const std::string& begins) {
  for (const ArmTrend& trend : arm_trends(findings)) {
    if (trend.text.starts_with(begins)) return trend.found[0].verdict;
  }
  throw std::logic_error("no such trend");
}

TEST(Goritov2020, VerdictsFollowTheRuns) {
  ArmFindings findings = level(8);
  EXPECT_EQ(verdict(findings, "beta"), Verdict::confirmed);
  EXPECT_EQ(verdict(findings, "alpha = 1"), Verdict::open);
  EXPECT_EQ(verdict(findings, "alpha > 1"), Verdict::refuted);
  EXPECT_EQ(verdict(findings, "rho"), Verdict::confirmed);
  EXPECT_EQ(verdict(findings, "gamma = 0"), Verdict::refuted);

  for (const char* name : {"alpha-0", "alpha-2", "alpha-3", "alpha-4"}) {
    for (ArmRun& run : of(findings, name)) run.best.assign(100, 1.4);
  }
  EXPECT_EQ(verdict(findings, "alpha = 1"), Verdict::confirmed);
  for (ArmRun& run : of(findings, "alpha-3")) run.best.assign(100, 1.0);
  EXPECT_EQ(verdict(findings, "alpha = 1"), Verdict::refuted);

  int frozen = 77;
  for (const char* name : {"alpha-2", "alpha-3", "alpha-4"}) {
    for (ArmRun& run : of(findings, name)) {
      std::fill(run.mean.begin() + frozen, run.mean.end(), 3.0);
    }
    frozen -= 30;
  }
  EXPECT_EQ(verdict(findings, "alpha > 1"), Verdict::confirmed);

  for (ArmRun& run : of(findings, "rho-1")) run.best.assign(100, 1.3);
  EXPECT_EQ(verdict(findings, "rho"), Verdict::refuted);
  for (ArmRun& run : of(findings, "beta-0")) run.mean[3] += 1;
  EXPECT_EQ(verdict(findings, "beta"), Verdict::refuted);
  for (ArmRun& run : of(findings, "gamma-0")) {
    run.best.assign(100, 2);
    run.steps = 5000;
  }
  EXPECT_EQ(verdict(findings, "gamma = 0"), Verdict::confirmed);
  EXPECT_NE(arm_report(findings, {"a.svg"}).find("![a.svg](a.svg)"), std::string::npos);
}

TEST(Goritov2020, CurvesAreMeansOverWhatThereIs) {
  std::vector<std::vector<ArmRun>> runs(1);
  runs[0].push_back({{kUnknown, 3, 2}, {}, 0, 0});
  runs[0].push_back({{5, 1}, {}, 0, 0});
  EXPECT_EQ(mean_curve(runs, &ArmRun::best), (std::vector<double>{5, 2, 2}));
}

}  // namespace
}  // namespace lasius::study
