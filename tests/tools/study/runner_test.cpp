#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/grid/map_io.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"
#include "tools/console/crew.h"
#include "tools/study/bitmaps.h"
#include "tools/study/markdown.h"
#include "tools/study/table.h"

namespace lasius::study {
namespace {

/// A folder of its own with one small map, gone at the end.
class StudyRunner : public Files {
 protected:
  StudyRunner() {
    Grid grid(20, 20);
    for (int y = 3; y < 17; ++y) grid.set_blocked({10, y});
    write_map(grid, path("wall.map"));
  }

  static Study study() {
    const Contender slow{"as", "as", "as", Preset::book, {{"iterations", "6"}, {"ants", "5"}}};
    const Contender ga{
        "ga", "grid-ga", "grid-ga", Preset::usual, {{"iterations", "6"}, {"population", "5"}}};
    Contender more = ga;
    more.name = "ga-x10";
    more.settings[0].second = "60";
    const Contender none{"none", "none such", "no-such-algorithm"};
    Experiment e{.name = "walls",
                 .title = "Walls",
                 .text = "One wall.",
                 .optimum = {Optimum::Kind::moves, Neighbours::eight, Corners::forbid},
                 .contenders = {slow, ga, more, none},
                 .questions = {{"wall", "wall.map", {2, 10}, {17, 10}, {{"as", 23.5, 4, 2}}}}};
    Study study{.name = "test", .summary = "a test", .source = "Nobody", .text = {}};
    study.experiments = {e};
    return study;
  }
  RunnerOptions options() const { return {.seeds = 4, .threads = 2, .folder = path("out")}; }
  Findings run(const Study& study, const RunnerOptions& options) const {
    return run_study(study, Bitmaps(study, path("")), options);
  }
  /// All tables but times.
  static std::string tables(const Findings& findings, const Study& study) {
    Table runs = run_table(findings);
    for (auto& row : runs.rows) row.pop_back();
    Table results = result_table(findings, study.experiments[0]);
    for (auto& row : results.rows) row.pop_back();
    return runs.csv() + results.csv();
  }
};

TEST_F(StudyRunner, RunsEveryContenderForEverySeed) {
  const Study s = study();
  const auto findings = run(s, options());
  EXPECT_TRUE(findings.whole);
  ASSERT_EQ(findings.samples.size(), 3u);
  ASSERT_EQ(findings.skipped.size(), 1u);
  EXPECT_EQ(findings.skipped[0].contender, "none such");
  const Sample* as = findings.find("walls", "wall", "as");
  const Sample* more = findings.find("walls", "wall", "ga-x10");
  ASSERT_TRUE(as && more);
  EXPECT_EQ(as->paths_an_iteration, 5);
  EXPECT_EQ(more->runs[0].iterations, 60);
  EXPECT_EQ(more->runs[3].seed, 4u);
  for (const study::Run& run : as->runs) {
    EXPECT_TRUE(run.solved());
    EXPECT_EQ(run.cut_best.size(), 6u);
    EXPECT_GT(run.steps, 0);
    EXPECT_NEAR(run.limit, 13 * std::sqrt(2.0) + 3, 1e-6);  // the shortest walk
  }
  // Round the lower end of the wall: 7 diagonal steps, 2 straight ones, 6 diagonal and 1 straight.
  EXPECT_NEAR(findings.optimum(s.experiments[0], s.experiments[0].questions[0]).value(),
              13 * std::sqrt(2.0) + 3, 1e-9);
  for (const study::Run& run : more->runs) EXPECT_EQ(run.best.back(), run.length);
}

/// Two ranks of a crew, one after the other: the other one acts in the leader's call, the last item
/// first, and hears the summary in its own.
class TwoRanks final : public tool::Crew {
 public:
  TwoRanks() { tool::set_crew(this); }
  ~TwoRanks() override { tool::set_crew(nullptr); }
  int number() const noexcept override { return leads_ ? 0 : 1; }
  int size() const noexcept override { return 2; }
  std::vector<std::string> gather(const std::string&, const std::string& own) override {
    return {own, own};
  }
  std::vector<std::string> pass(const std::string&) override { return {}; }
  std::optional<std::string> share(const Work& work) override {
    keys_.insert(work.key);
    if (!leads_) return told_;
    given_ = work.items.size();
    std::vector<int> items(work.items.rbegin(), work.items.rend());
    if (stopped_) items.pop_back();
    auto texts = work.act(items);
    for (std::size_t i = 0; i < items.size(); ++i) work.receive(items[i], std::move(texts[i]));
    if (stopped_) return std::nullopt;
    if (work.summary) told_ = work.summary();
    return told_;
  }

  bool leads_ = true, stopped_ = false;
  std::set<std::string> keys_;
  std::size_t given_ = 0;

 private:
  std::string told_;
};

TEST_F(StudyRunner, ACrewMakesTheSameTablesAndTellsItsRanks) {
  const Study s = study();
  const std::string expected = tables(run(s, options()), s);
  TwoRanks ranks;
  RunnerOptions shared = options();
  shared.folder = path("shared");
  shared.tell_all = true;
  std::filesystem::create_directories(path("shared/runs/walls/wall/as"));
  std::filesystem::copy(path("out/runs/walls/wall/as/2.json"),
                        path("shared/runs/walls/wall/as/2.json"));
  EXPECT_EQ(tables(run(s, shared), s), expected);
  EXPECT_EQ(ranks.given_, 11u);  // one was kept
  ranks.leads_ = false;
  shared.folder = path("follower");
  const Findings told = run(s, shared);
  EXPECT_TRUE(told.whole);
  EXPECT_EQ(tables(told, s), expected);
  EXPECT_EQ(ranks.keys_.size(), 1u);  // though the follower has no folder
  EXPECT_FALSE(std::filesystem::exists(path("follower")));
  shared.tell_all = false;
  EXPECT_FALSE(run(s, shared).whole);
  shared.first_seed = 2;
  (void)run(s, shared);
  EXPECT_EQ(ranks.keys_.size(), 2u);
}

TEST_F(StudyRunner, WhatASignalToAnotherRankEndedIsInterrupted) {
  const Study s = study();
  TwoRanks ranks;
  ranks.stopped_ = true;
  EXPECT_TRUE(run(s, options()).interrupted);
  ranks.stopped_ = false;
  const Findings findings = run(s, options());
  EXPECT_TRUE(findings.whole);
  EXPECT_FALSE(findings.interrupted);
}

TEST_F(StudyRunner, GoesOnWhereItStoppedAndEndsWithTheSameTables) {
  const Study s = study();
  const auto whole = run(s, options());
  const std::string expected = tables(whole, s);

  RunnerOptions stopped = options();
  stopped.folder = path("stopped");
  std::stop_source source;
  stopped.stop = source.get_token();
  int runs = 0;
  stopped.progress = [&](std::int64_t, std::int64_t, const std::string&) {
    if (++runs == 5) source.request_stop();
  };
  std::size_t estimated = 0;
  stopped.estimate = [&](std::size_t count, double seconds) {
    estimated = count;
    EXPECT_GT(seconds, 0);
  };
  const auto part = run(s, stopped);
  EXPECT_FALSE(part.whole);
  EXPECT_EQ(estimated, 12u);
  std::size_t kept = 0;
  for (const Sample& sample : part.samples) kept += sample.runs.size();
  EXPECT_EQ(kept, static_cast<std::size_t>(runs));
  expect_says(report_page(s, part, {}, {.first = 1, .count = 4}, {}),
              "Partial: interrupted after " + std::to_string(runs) + " of 12 runs");
  EXPECT_GE(runs, 5);
  EXPECT_LT(runs, 12);

  // A torn file is done again, like one of another study.
  const fs::path as = stopped.folder / "runs/walls/wall/as";
  fs::create_directories(as);
  std::ofstream(as / "1.json") << R"({"key": "lasius", "se)";
  stopped.stop = {};
  int again = 0;
  stopped.progress = [&](std::int64_t, std::int64_t, const std::string&) { ++again; };
  const auto resumed = run(s, stopped);
  EXPECT_TRUE(resumed.whole);
  EXPECT_GE(again, 12 - runs);
  EXPECT_LE(again, 12 - runs + 1);
  EXPECT_EQ(tables(resumed, s), expected);

  again = 0;
  EXPECT_TRUE(run(s, stopped).whole);
  EXPECT_EQ(again, 0);
}

TEST_F(StudyRunner, OtherSettingsAreRunAgain) {
  Study s = study();
  (void)run(s, options());
  s.experiments[0].contenders[0].settings[1].second = "6";
  RunnerOptions o = options();
  int again = 0;
  o.progress = [&](std::int64_t, std::int64_t, const std::string&) { ++again; };
  (void)run(s, o);
  EXPECT_EQ(again, 4);
}

TEST_F(StudyRunner, ABudgetOfStepsEndsARunAfterTheIterationThatSpentIt) {
  Study s = study();
  Contender& as = s.experiments[0].contenders[0];
  const auto all = run(s, options());
  const study::Run& whole = all.find("walls", "wall", "as")->runs[2];
  ASSERT_EQ(whole.steps_by.size(), 6u);
  as.budget.steps = whole.steps_by[0] + whole.steps_by[1] + 1;
  RunnerOptions o = options();
  o.first_seed = 3;
  o.seeds = 1;
  const auto limited = run(s, o);
  ASSERT_EQ(limited.find("walls", "wall", "as")->runs.size(), 1u);
  const study::Run& third = limited.find("walls", "wall", "as")->runs[0];
  EXPECT_EQ(third.seed, 3u);
  EXPECT_EQ(third.iterations, 3);
  EXPECT_EQ(third.status, Status::limit);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(third.steps_by[i], whole.steps_by[i]);
  // One that is never spent changes nothing.
  as.budget.steps = 1e12;
  const auto free = run(s, o);
  EXPECT_EQ(free.find("walls", "wall", "as")->runs[0].best, whole.best);
  EXPECT_EQ(free.find("walls", "wall", "as")->runs[0].status, Status::solved);
}

TEST_F(StudyRunner, NamesAMissingMap) {
  Study s = study();
  s.experiments[0].questions[0].map = "none.map";
  EXPECT_THROW((void)run(s, options()), Error);
}

TEST_F(StudyRunner, ReportsPaperAndOurs) {
  Study s = study();
  Claim shorter{.text = "As wins.", .place = "page 1", .test = Claim::Test::less};
  shorter.in = {"walls"};
  shorter.a = "as";
  shorter.b = "ga";
  Claim absent = shorter;
  absent.a = "none";
  s.claims = {shorter, absent};
  const auto findings = run(s, options());
  const Table results = result_table(findings, s.experiments[0]);
  ASSERT_EQ(results.rows.size(), 4u);  // the optimum, and three that ran
  EXPECT_EQ(results.rows[0][1], "optimum of 8 moves");
  EXPECT_EQ(results.rows[1][2], "23.500");
  auto evidence = weigh(s, findings);
  decide(evidence);
  const Table claims = claim_table(evidence);
  ASSERT_EQ(claims.rows.size(), 2u);
  EXPECT_EQ(claims.rows[0].size(), claims.header.size());
  EXPECT_EQ(claims.rows[1].back(), "not run");
  const std::string page = report_page(s, findings, evidence, {.first = 1, .count = 4}, {});
  expect_says(page, "Not run: none such");
  expect_says(page, "| As wins. | page 1 |");
  expect_says(claims_page(evidence, "lasius study all"),
              "## `test`\n\nPlaces, statistics, tests and figures: [test](claims/test.md).\n\n"
              "| claim | outcome | effect [95%] | control |\n|---|---|---|---|\n| As wins. | ");
  expect_says(claim_details(evidence), "## As wins.\n\n* place: page 1\n* statistic: ");
}

}  // namespace
}  // namespace lasius::study
