#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stop_token>

#include "lasius/error.h"
#include "tests/core/map_files/map_files.h"
#include "tools/study/bitmaps.h"
#include "tools/study/claims.h"
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
    const Contender slow{"as", "as", "as", {{"iterations", "6"}, {"ants", "5"}}};
    const Contender ga{"ga", "grid-ga", "grid-ga", {{"iterations", "6"}, {"population", "5"}}};
    const Contender none{"none", "none such", "no-such-algorithm"};
    Experiment e{.name = "walls",
                 .title = "Walls",
                 .text = "One wall.",
                 .truth = {Truth::Kind::moves, Neighbours::eight, Corners::forbid},
                 .contenders = {slow, ga, tenfold(ga), none},
                 .questions = {{"wall", "wall.map", {2, 10}, {17, 10}, {{"as", 23.5, 4, 2}}}}};
    return {"test", "a test", "Nobody", "", {e}, {}};
  }
  RunnerOptions options() const { return {.seeds = 4, .threads = 2, .folder = path("out")}; }
  std::optional<Findings> run(const Study& study, const RunnerOptions& options) const {
    return run_study(study, Bitmaps(study, path("")), options);
  }
  /// All tables but times.
  static std::string tables(const Findings& findings, const Study& study) {
    Table runs = run_table(findings);
    for (auto& row : runs.rows) row.pop_back();
    return runs.csv() + test_table(findings, study.experiments[0]).csv();
  }
};

TEST_F(StudyRunner, RunsEveryContenderForEverySeed) {
  const Study s = study();
  const auto findings = run(s, options());
  ASSERT_TRUE(findings);
  ASSERT_EQ(findings->samples.size(), 3u);
  ASSERT_EQ(findings->absent.size(), 1u);
  EXPECT_EQ(findings->absent[0].contender, "none such");
  const Sample* as = findings->find("walls", "wall", "as");
  const Sample* more = findings->find("walls", "wall", "ga-x10");
  ASSERT_TRUE(as && more);
  EXPECT_EQ(as->paths_an_iteration, 5);
  EXPECT_EQ(more->runs[0].iterations, 60);
  EXPECT_EQ(more->runs[3].seed, 4u);
  EXPECT_EQ(as->solved(), 4);
  // Round the lower end of the wall: 7 diagonal steps, 2 straight ones, 6 diagonal and 1 straight.
  EXPECT_NEAR(findings->optimum(s.experiments[0], s.experiments[0].questions[0]).value(),
              13 * std::sqrt(2.0) + 3, 1e-9);
  for (const study::Run& run : more->runs) EXPECT_EQ(run.best.back(), run.length);
}

TEST_F(StudyRunner, GoesOnWhereItStoppedAndEndsWithTheSameTables) {
  const Study s = study();
  const auto whole = run(s, options());
  const std::string expected = tables(*whole, s);

  RunnerOptions stopped = options();
  stopped.folder = path("stopped");
  std::stop_source source;
  stopped.stop = source.get_token();
  int runs = 0;
  stopped.progress = [&](std::int64_t, std::int64_t, const std::string&) {
    if (++runs == 5) source.request_stop();
  };
  EXPECT_FALSE(run(s, stopped));
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
  ASSERT_TRUE(resumed);
  EXPECT_GE(again, 12 - runs);
  EXPECT_LE(again, 12 - runs + 1);
  EXPECT_EQ(tables(*resumed, s), expected);

  again = 0;
  ASSERT_TRUE(run(s, stopped));
  EXPECT_EQ(again, 0);
}

TEST_F(StudyRunner, OtherSettingsAreRunAgain) {
  Study s = study();
  ASSERT_TRUE(run(s, options()));
  s.experiments[0].contenders[0].settings[1].second = "6";
  RunnerOptions o = options();
  int again = 0;
  o.progress = [&](std::int64_t, std::int64_t, const std::string&) { ++again; };
  ASSERT_TRUE(run(s, o));
  EXPECT_EQ(again, 4);
}

TEST_F(StudyRunner, NamesAMissingMap) {
  Study s = study();
  s.experiments[0].questions[0].map = "none.map";
  EXPECT_THROW((void)run(s, options()), Error);
}

TEST_F(StudyRunner, ReportsPaperAndOurs) {
  Study s = study();
  s.claims = {{"As wins.", shorter_everywhere({"walls"}, "as", "ga"), "a guess"},
              {"Never rises.", never_rises({"walls"}, "as"), ""},
              {"Not there.", never_rises({"walls"}, "none"), ""}};
  const auto findings = run(s, options());
  const Table results = result_table(*findings, s.experiments[0]);
  ASSERT_EQ(results.rows.size(), 4u);  // the optimum, and three that ran
  EXPECT_EQ(results.rows[0][1], "true optimum");
  EXPECT_EQ(results.rows[1][2], "23.500");
  const Table tests = test_table(*findings, s.experiments[0]);
  ASSERT_EQ(tests.rows.size(), 1u);
  EXPECT_EQ(tests.rows[0].size(), tests.header.size());
  const std::string page = report_page(s, *findings, 4, {});
  EXPECT_NE(page.find("Not run: none such"), std::string::npos);
  EXPECT_NE(page.find("| Never rises. | confirmed | rises in 0 of 4 runs |"), std::string::npos);
  EXPECT_NE(page.find("| Not there. | open | not run |"), std::string::npos);
}

TEST(Compare, FailuresCountAsInfinitelyLong) {
  const auto sample = [](std::vector<double> lengths) {
    Sample s;
    for (const double l : lengths) {
      study::Run run;
      run.length = l;
      if (l > 0) run.path = {{0.5, 0.5}};
      s.runs.push_back(run);
    }
    return s;
  };
  const Sample a = sample({10, 0, 10, 0}), b = sample({11, 12, 0, 0});
  const auto d = differences(a, b);
  EXPECT_EQ(d[0], 1);
  EXPECT_EQ(d[1], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(d[2], std::numeric_limits<double>::infinity());
  EXPECT_EQ(d[3], 0);
  EXPECT_EQ(compare(a, b).pairs, 3);
}

TEST(Run, ConvergesAtItsLastImprovement) {
  study::Run run;
  run.best = {kUnknown, 9, 8, 8, 8};
  EXPECT_EQ(run.converged(), 3);
  run.best = {5, 5};
  EXPECT_EQ(run.converged(), 1);
  run.best = {};
  EXPECT_EQ(run.converged(), 0);
}

}  // namespace
}  // namespace lasius::study
