#include "tools/study/tune/tune_file.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"
#include "tests/tools/yaml/fault_line.h"

namespace lasius::study {
namespace {

class TuningFiles : public Files {};

TEST_F(TuningFiles, TuneOnSomeMapsAndJudgeOnOthers) {
  const std::string begin =
      "algorithm: mmas\nset: {ants: 5}\nparameters: {persistence: {from: 0.5, to: 0.9}}\n"
      "candidates: 4\nmaps: {b: {kind: blobs, size: 40x30, seeds: 1..2}, g: grid20a.map}\n";
  const auto refused = [&](const std::string& rest) {
    const std::string name = file(begin + rest, "t.yaml");
    return fault_line([&] { return read_tuning(name); }, name);
  };
  const Tuning tuning = read_tuning(file(begin + "training: [{map: b, draw: 1}]\n", "t.yaml"));
  ASSERT_EQ(tuning.candidates.size(), 4U);
  EXPECT_EQ(tuning.candidates[0].name, "default");
  EXPECT_TRUE(tuning.candidates[0].factors.empty());
  EXPECT_EQ(tuning.candidates[0].settings, (Settings{{"ants", "5"}}));
  EXPECT_EQ(tuning.candidates[3].factors.size(), 1U);
  EXPECT_EQ(tuning.judging.experiments[0].questions[1].map, "blobs 40x30 default 1000002");
  EXPECT_EQ(tuning.judging.seeds.count, 10);

  EXPECT_EQ(refused("training: [{map: b, draw: 1}]\njudging: [{map: g, draw: 1}]\n"), "");
  expect_says(refused("training: [{map: g, draw: 1}]\n"),
              "6: 'training' has \"g\", which there is not elsewhere");
  expect_says(refused("training: [{map: b, draw: 1}]\njudging: [{draw: 1}]\n"),
              "7: 'judging' has \"blobs 40x30 default 1\", which is trained on");
  expect_says(refused(""), "1: 'training' is missing");
  expect_says(refused("training: [{map: b, draw: 1}]\nrace: {first: 3}\n"),
              "7: 'first' is unknown here");
  expect_says(refused("training: [{map: b, draw: 1}]\nvalue: beauty\n"),
              "7: 'value' is \"beauty\"");
}

TEST(TuningFile, TheOneOfTheDocumentsIsRead) {
  const fs::path docs = fs::path(LASIUS_MAPS_DIR).parent_path() / "docs";
  EXPECT_EQ(read_tuning((docs / "examples/tune_mmas.yaml").string()).candidates.size(), 40U);
}

}  // namespace
}  // namespace lasius::study
