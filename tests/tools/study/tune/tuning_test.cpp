#include "tools/study/tune/tuning.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"
#include "tools/study/tune/tune_report.h"
#include "tools/yaml/preset_file.h"

namespace lasius::study {
namespace {

/// What may not depend on threads or on interruptions.
std::string all_of(const Tuning& tuning, const Tuned& tuned) {
  return race_table(tuned).csv() + candidate_table(tuning, tuned).csv() + tune_page(tuning, tuned) +
         preset_text(tuning, tuned);
}

/// The default does one iteration of one ant; candidates do more of both.
class ATuning : public Files {
 protected:
  ATuning() {
    file(
        "algorithm: mmas\nset: {ants: 1, iterations: 1, walk_cut: none}\n"
        "parameters: {ants: [1, 10], iterations: [2, 60]}\ncandidates: 8\n"
        "maps: {b: {kind: blobs, size: 40x30, density: 0.3, seeds: 1..4}}\noptimum: 8 moves\n"
        "training: [{map: b, draw: 2}]\nrace: {first_test: 4, blocks: 40}\nseeds: 1..5\n",
        "t.yaml");
  }
  Tuning tuning() const { return read_tuning(path("t.yaml")); }
  TuneOptions options(int threads, const std::string& folder) const {
    return {.threads = threads, .folder = path(folder), .maps = {}};
  }
};

TEST_F(ATuning, JudgesOnNoMapThatItTrainedOnByAnotherName) {
  file(
      "algorithm: mmas\nparameters: {ants: [1, 10]}\n"
      "training: [{map: blobs 40x30 0.3 5, draw: 2}]\njudging: [{map: blobs 40x30 0.30 5, draw: "
      "2}]\n",
      "same.yaml");
  Tuning t = read_tuning(path("same.yaml"));
  expect_says(error_of([&] { return tune(t, options(1, "out")); }),
              "\"blobs 40x30 0.30 5\", which is judged on, has the cells of \"blobs 40x30 0.3 5\"");
}

TEST_F(ATuning, FindsThePlantedValueAndJudgesItBetter) {
  Tuning t = tuning();
  double estimated = 0;
  TuneOptions o = options(2, "out");
  o.estimate = [&](double seconds) { estimated = seconds; };
  const Tuned tuned = tune(t, o);
  ASSERT_TRUE(tuned.whole);
  EXPECT_GT(estimated, 0);
  EXPECT_EQ(t.candidates[tuned.race.best()].factors,
            (Settings{{"ants", "10"}, {"iterations", "60"}}));
  EXPECT_GT(tuned.race.runners()[0].left_after, 0);
  ASSERT_EQ(tuned.families.size(), 2U);  // all, blobs
  EXPECT_EQ(tuned.families[0].pairs.size(), 8U);
  EXPECT_EQ(tuned.families[0].pairs[0].a.size(), 5U);
  EXPECT_LT(tuned.families[0].p, 0.001);
  EXPECT_GT(tuned.families[0].effect.low, 0.9);
  EXPECT_LT(tuned.families[0].ratios.high, 1);
  expect_says(verdict_text(t, tuned), "better");

  file(preset_text(t, tuned), "preset.yaml");
  const auto preset = tool::read_preset_file(path("preset.yaml"));
  EXPECT_EQ(preset.algorithm, "mmas");
  EXPECT_EQ(preset.settings,
            (Settings{{"walk_cut", "none"}, {"ants", "10"}, {"iterations", "60"}}));
}

TEST_F(ATuning, IsTheSameForAnyThreadsAndWhereverItWasStopped) {
  Tuning first = tuning();
  const std::string expected = all_of(first, tune(first, options(1, "one")));
  for (const int threads : {2, 5}) {
    Tuning t = tuning();
    EXPECT_EQ(all_of(t, tune(t, options(threads, "n" + std::to_string(threads)))), expected);
  }
  for (int blocks = 1, interrupted = 1; interrupted > 0; ++blocks) {
    std::stop_source source;
    TuneOptions o = options(2, "stopped");
    o.stop = source.get_token();
    int calls = 0;
    o.progress = [&](std::int64_t, std::int64_t, const std::string&) {
      if (++calls == blocks) source.request_stop();
    };
    Tuning t = tuning();
    const Tuned tuned = tune(t, o);
    interrupted = tuned.whole ? 0 : 1;
    if (tuned.whole) {
      EXPECT_EQ(all_of(t, tuned), expected);
    } else {
      EXPECT_TRUE(tuned.families.empty());
      expect_says(preset_text(t, tuned), "interrupted");
    }
    ASSERT_LT(blocks, 200);
  }
}

TEST_F(ATuning, TheDefaultMayWin) {
  file(
      "algorithm: mmas\nset: {iterations: 30}\nparameters: {iterations: [1, 2]}\ncandidates: 3\n"
      "maps: {b: {kind: blobs, size: 40x30, seeds: 1..4}}\n"
      "training: [{map: b, draw: 2}]\nrace: {first_test: 4, blocks: 24}\n",
      "t.yaml");
  Tuning t = tuning();
  const Tuned tuned = tune(t, options(2, "out"));
  EXPECT_TRUE(tuned.whole);
  EXPECT_EQ(tuned.race.best(), 0U);
  EXPECT_EQ(t.candidates[tuned.judged].factors, (Settings{{"iterations", "2"}}));
  ASSERT_FALSE(tuned.families.empty());
  EXPECT_LT(tuned.families[0].effect.high, 0.5);
  expect_says(verdict_text(t, tuned), "the default won; its strongest rival, ");
  expect_says(verdict_text(t, tuned), ": worse");
  expect_says(preset_text(t, tuned), "iterations: \"30\"");
}

}  // namespace
}  // namespace lasius::study
