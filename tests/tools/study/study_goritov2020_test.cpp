#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tools/study/sources/goritov2020.h"
#include "tools/study/sources/goritov2020_measures.h"
#include "tools/study/study_file.h"

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
  ASSERT_EQ(study.experiments.size(), kReadings.size());
  for (std::size_t r = 0; r < kReadings.size(); ++r) {
    const Experiment& reading = study.experiments[r];
    EXPECT_EQ(reading.name, kReadings[r]);
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

/// All settings with the same runs: one question, `seeds` runs of 100 iterations.
Findings level(const Study& study, int seeds) {
  Findings findings;
  for (const Experiment& reading : study.experiments) {
    for (const Contender& setting : reading.contenders) {
      findings.samples.push_back({&reading, &reading.questions.front(), &setting});
      for (int s = 0; s < seeds; ++s) {
        study::Run& run = findings.samples.back().runs.emplace_back();
        run.steps = 1000;
        for (int i = 0; i < 100; ++i) {
          run.best.push_back(i < 50 ? 1.5 : 1.2);
          run.mean.push_back(10 + std::sin(i + s));
        }
      }
    }
  }
  return findings;
}

std::vector<study::Run>& of(Findings& findings, const std::string& name) {
  for (Sample& sample : findings.samples) {
    if (sample.experiment->name == kReadings[0] && sample.contender->name == name)
      return sample.runs;
  }
  throw std::logic_error("no such setting");
}

Verdict verdict(const Findings& findings, const std::string& begins) {
  for (const ArmTrend& trend : arm_trends(findings)) {
    if (trend.text.starts_with(begins)) return trend.found[0].verdict;
  }
  throw std::logic_error("no such trend");
}

TEST(Goritov2020, VerdictsFollowTheRuns) {
  const Study study = make_study("goritov2020");
  Findings findings = level(study, 8);
  EXPECT_EQ(verdict(findings, "beta"), Verdict::confirmed);
  EXPECT_EQ(verdict(findings, "alpha = 1"), Verdict::open);
  EXPECT_EQ(verdict(findings, "alpha > 1"), Verdict::refuted);
  EXPECT_EQ(verdict(findings, "rho"), Verdict::confirmed);
  EXPECT_EQ(verdict(findings, "gamma = 0"), Verdict::refuted);

  for (const char* name : {"alpha-0", "alpha-2", "alpha-3", "alpha-4"}) {
    for (study::Run& run : of(findings, name)) run.best.assign(100, 1.4);
  }
  EXPECT_EQ(verdict(findings, "alpha = 1"), Verdict::confirmed);
  for (study::Run& run : of(findings, "alpha-3")) run.best.assign(100, 1.0);
  EXPECT_EQ(verdict(findings, "alpha = 1"), Verdict::refuted);

  int frozen = 77;
  for (const char* name : {"alpha-2", "alpha-3", "alpha-4"}) {
    for (study::Run& run : of(findings, name)) {
      std::fill(run.mean.begin() + frozen, run.mean.end(), 3.0);
    }
    frozen -= 30;
  }
  EXPECT_EQ(verdict(findings, "alpha > 1"), Verdict::confirmed);

  for (study::Run& run : of(findings, "rho-1")) run.best.assign(100, 1.3);
  EXPECT_EQ(verdict(findings, "rho"), Verdict::refuted);
  for (study::Run& run : of(findings, "beta-0")) run.mean[3] += 1;
  EXPECT_EQ(verdict(findings, "beta"), Verdict::refuted);
  for (study::Run& run : of(findings, "gamma-0")) {
    run.best.assign(100, 2);
    run.steps = 5000;
  }
  EXPECT_EQ(verdict(findings, "gamma = 0"), Verdict::confirmed);
  EXPECT_NE(arm_report(study, findings, {}, {"a.svg"}).find("![a.svg](a.svg)"), std::string::npos);
}

TEST(Goritov2020, CurvesAreMeansOverWhatThereIs) {
  Sample sample;
  sample.runs = {{.best = {kUnknown, 3, 2}}, {.best = {5, 1}}};
  EXPECT_EQ(mean_curve({&sample}, &study::Run::best), (std::vector<double>{5, 2, 2}));
}

}  // namespace
}  // namespace lasius::study
