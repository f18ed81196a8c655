// Each verdict is given data that must turn it.
#include "tools/study/claims.h"

#include <gtest/gtest.h>

#include "tests/core/base/refusal.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

/// Two contenders, a and b, on some questions of the experiment e, with made-up runs: a is shorter
/// until a test says other.
class Claims : public testing::Test {
 protected:
  explicit Claims(int questions = 2) {
    Experiment e{.name = "e", .title = {}, .text = {}};
    e.contenders = {{.name = "a"}, {.name = "b"}};
    for (int q = 0; q < questions; ++q)
      e.questions.push_back({.name = "q" + std::to_string(q), .map = {}, .start = {}, .goal = {}});
    study_.experiments = {e};
    const Experiment& kept = study_.experiments[0];
    for (const Question& question : kept.questions) {
      findings_.optima.emplace(std::pair(&kept, &question), 10);
      for (const Contender& contender : kept.contenders)
        findings_.samples.push_back({&kept, &question, &contender});
    }
    both("a", low_);
    both("b", high_);
  }
  /// Runs of a contender: each ends with a length of `lengths`, reached in its last iteration.
  void runs(const std::string& contender, int question, const std::vector<double>& lengths,
            int iterations = 10) {
    for (Sample& s : findings_.samples) {
      if (s.contender->name != contender || s.question->name != "q" + std::to_string(question))
        continue;
      s.runs.clear();
      for (const double length : lengths) {
        study::Run& run = s.runs.emplace_back();
        run.seed = s.runs.size();
        run.iterations = iterations;
        run.seconds = iterations;
        run.length = length;
        run.best.assign(static_cast<std::size_t>(iterations), 100);
        run.best.back() = length;
        run.steps_by.assign(static_cast<std::size_t>(iterations), 5);
        run.steps = 5 * iterations;
      }
    }
  }
  void both(const std::string& contender, const std::vector<double>& lengths) {
    for (int q = 0; q < 2; ++q) runs(contender, q, lengths);
  }
  static Claim less() {
    Claim claim{.text = "a is shorter", .place = {}, .test = Claim::Test::less};
    claim.in = {"e"};
    claim.a = "a";
    claim.b = "b";
    return claim;
  }
  /// What becomes of a claim when a has these lengths.
  Verdict verdict(const Claim& claim, const std::vector<double>& a) {
    both("a", a);
    return judge(claim).verdict;
  }
  Evidence judge(const Claim& claim, int others = 0) {
    study_.claims = {claim};
    std::vector<Evidence> evidence(static_cast<std::size_t>(others) + 1,
                                   weigh(study_, findings_).front());
    decide(evidence);
    return evidence.front();
  }

  static constexpr double kFailed = kUnknown;
  const std::vector<double> low_{11, 12, 13, 14, 15, 16, 17, 18},
      high_{21, 22, 23, 24, 25, 26, 27, 28};
  const std::vector<double> between_{11, 21, 13, 23, 15, 25, 17, 27},
      among_{12, 22, 14, 24, 16, 26, 18, 28};
  Study study_{.name = "s", .summary = {}, .source = {}, .text = {}};
  Findings findings_;
};

TEST_F(Claims, AreConfirmedAndRefutedByTheRuns) {
  const Evidence e = judge(less());
  EXPECT_EQ(e.verdict, Verdict::confirmed);
  EXPECT_EQ(e.effect, 1);
  EXPECT_GT(e.interval.low, 0.5);
  both("a", high_);
  both("b", low_);
  EXPECT_EQ(judge(less()).verdict, Verdict::refuted);
}

TEST_F(Claims, AreNotDecidedByASign) {
  both("a", between_);
  both("b", among_);  // longer in the mean, on every question
  EXPECT_EQ(judge(less()).verdict, Verdict::undecided);
}

TEST_F(Claims, OneTieDoesNotUndoWhatOthersShow) {
  runs("a", 1, {10, 10, 10, 10, 10, 10, 10, 10});
  runs("b", 1, {10, 10, 10, 10, 10, 10, 10, 10});
  const Evidence e = judge(less());
  EXPECT_EQ(e.verdict, Verdict::confirmed);
  EXPECT_EQ(e.questions, 1);
}

TEST_F(Claims, WhereAllReachTheCeilingNothingIsDecided) {
  both("a", {10, 10, 10, 10, 10, 10, 10, 10});
  both("b", {10, 10, 10, 10, 10, 10, 10, 10});
  const Evidence e = judge(less());
  EXPECT_EQ(e.verdict, Verdict::undecided);
  expect_says(e.figures, "nothing to tell apart");
}

TEST_F(Claims, DependOnTheMapWhereAQuestionSaysTheOpposite) {
  runs("a", 1, high_);
  runs("b", 1, low_);
  // One-sided 1 / C(16, 8) either way, by 4 for two sides and questions: times 160 below 0.05.
  EXPECT_EQ(judge(less(), 159).verdict, Verdict::depends);
  const Evidence e = judge(less(), 160);  // p of both together is 1
  EXPECT_EQ(e.verdict, Verdict::undecided);
  expect_says(e.figures, "some question says the opposite");
}

TEST_F(Claims, AQuestionThatSaysTheOppositeLeavesThemOpen) {
  runs("a", 0, std::vector<double>(24, 11));
  runs("b", 0, std::vector<double>(24, 21));
  runs("a", 1, high_);
  runs("b", 1, low_);
  const Evidence e = judge(less(), 160);
  EXPECT_EQ(e.verdict, Verdict::undecided);
  EXPECT_LT(e.adjusted, 0.05);
  expect_says(
      e.figures,
      "some question says the opposite; holds clearly on 1 of 2 questions, clearly fails on 1");
}

TEST_F(Claims, WhereTheIntervalCrossesItsEdgeItIsSaidHowManySeedsWouldDecide) {
  Claim claim = less();
  claim.test = Claim::Test::similar;
  both("b", std::vector<double>(24, 10));
  const auto expect_seeds = [&](int longer, double within, const std::string& seeds) {
    std::vector<double> lengths(24, 10);
    std::fill_n(lengths.begin(), longer, 10.4);
    both("a", lengths);
    claim.within = within;
    const Evidence e = judge(claim);
    EXPECT_EQ(e.verdict, Verdict::undecided);
    EXPECT_LT(e.adjusted, 0.05);
    expect_says(e.figures, "at this effect about " + seeds + " seeds would decide");
  };
  // The median of one question may be the other one: sqrt(1.04) = 1.0198.
  expect_seeds(9, 0.015, "42");  // 1 within 1.015: 24 (0.0198 / 0.015)^2 = 41.8
  expect_seeds(16, 0.03, "98");  // 1.04 not within 1.03: 24 (0.0202 / 0.01)^2 = 97.9
}

TEST_F(Claims, EqualRunsDecideWhatAFactorOrAMarginAllows) {
  const std::vector<double> equal(8, 10);
  both("a", equal);
  both("b", equal);
  Claim claim = less();
  claim.factor = 1.3;
  EXPECT_EQ(judge(claim).verdict, Verdict::refuted);
  claim.test = Claim::Test::similar;
  claim.within = 0.05;
  EXPECT_EQ(judge(claim).verdict, Verdict::confirmed);
  runs("a", 1, {13, 13, 13, 13, 13, 13, 13, 13});
  EXPECT_EQ(judge(claim).verdict, Verdict::depends);
}

TEST_F(Claims, TooFewSeedsCannotDecideAndItIsSaidHowManyWould) {
  for (const char* name : {"a", "b"}) runs(name, 1, {10, 10, 10});
  runs("a", 0, {11, 12, 13});
  runs("b", 0, {21, 22, 23});  // 2 / C(6, 3) = 0.1; C(8, 4): 0.029
  const Evidence e = judge(less());
  EXPECT_EQ(e.verdict, Verdict::undecided);
  expect_says(e.figures, "cannot decide with 3 seeds; 4 could");
}

TEST_F(Claims, WhereTheEffectIsSmallItIsSaidHowManySeedsWouldDecideAtIt) {
  Claim claim = less();
  claim.test = Claim::Test::most;
  claim.b.clear();
  claim.share = 0.5;
  claim.to = 20;
  both("a", {10, 10, 10, 10, 10, 10, 30, 30});
  // 12 of 16: one-sided 2517 / 65536, z = 1.7696; 0.025: 1.9600; 8 (1.9600 / 1.7696)^2 = 9.81.
  expect_says(judge(claim).figures, "at this effect about 10 seeds would decide; ");
  expect_says(judge(claim).figures, "; 12 of 16 runs");
  // Of two tests 0.0125: 2.2414, 12.84.
  expect_says(judge(claim, 1).figures, "about 13 seeds would decide");
  both("a", {10, 10, 10, 10, 30, 30, 30, 30});
  expect_says(judge(claim).figures, "at this effect no number of seeds decides");
}

TEST_F(Claims, WhatNoNumberOfSeedsDecidesIsSaid) {
  Claim claim = less();
  claim.test = Claim::Test::most;
  claim.b.clear();
  for (const double share : {0.0, 1e-300, 1.0, 1 - 1e-12}) {
    claim.share = share;
    claim.to = share < 0.5 ? 1 : 20;  // no run, or all of them
    expect_says(judge(claim).figures, "nor with the 100000 that a study may have");
  }
  claim.share = 0.9;  // 0.9^36 is 0.0225
  both("a", {10, 10});
  expect_says(judge(claim).figures, "cannot decide with 2 seeds; 18 could");
}

TEST_F(Claims, TheCorrectionIsOverTheWholeReport) {
  for (const char* name : {"a", "b"}) runs(name, 1, {10, 10, 10, 10});
  runs("a", 0, {11, 12, 13, 14});
  runs("b", 0, {21, 22, 23, 24});
  EXPECT_EQ(judge(less()).verdict, Verdict::confirmed);  // p = 0.029
  EXPECT_EQ(judge(less(), 1).verdict, Verdict::undecided);
}

TEST_F(Claims, FailedRunsCount) {  // the one that arrives is shorter
  both("a", {11, kFailed, kFailed, kFailed, kFailed, kFailed, kFailed, kFailed});
  const Evidence e = judge(less());
  EXPECT_EQ(e.verdict, Verdict::refuted);
  expect_says(e.figures, "a: success in 2 of 16");
}

TEST_F(Claims, SoonerIsToTheSameTarget) {
  Claim claim = less();
  claim.value = {.name = "effort", .at = "steps", .target = 0.01};
  for (int q = 0; q < 2; ++q) {
    runs("a", q, {10, 10, 10, 10, 10, 10, 10, 10}, 8);
    runs("b", q, {10, 10, 10, 10, 10, 10, 10, 10}, 10);
  }
  // Both end at 40 steps, where b has not arrived.
  const Evidence e = judge(claim);
  EXPECT_EQ(e.verdict, Verdict::confirmed);
  expect_says(e.figures, "a: success in 16 of 16 [0.79, 1.00], expected running time 40.000");
  expect_says(e.figures, "b: success in 0 of 16");
  // A quick end without success is not sooner.
  for (int q = 0; q < 2; ++q) runs("a", q, {50, 50, 50, 50, 50, 50, 50, 50}, 20);
  EXPECT_EQ(judge(claim).verdict, Verdict::refuted);
}

TEST_F(Claims, AFactorHasToBeReached) {
  Claim claim = less();
  claim.factor = 1.1;
  EXPECT_EQ(judge(claim).verdict, Verdict::confirmed);
  claim.factor = 3;
  EXPECT_EQ(judge(claim).verdict, Verdict::refuted);
}

TEST_F(Claims, SimilarNeedsEvidenceOfItsOwn) {
  Claim claim = less();
  claim.test = Claim::Test::similar;
  claim.within = 0.05;
  both("b", {20.15, 20.25, 20.35, 20.45, 20.55, 20.65, 20.75, 20.85});
  EXPECT_EQ(verdict(claim, {20.1, 20.2, 20.3, 20.4, 20.5, 20.6, 20.7, 20.8}), Verdict::confirmed);
  both("b", high_);
  EXPECT_EQ(verdict(claim, between_), Verdict::undecided);
  EXPECT_EQ(verdict(claim, low_), Verdict::refuted);
}

TEST_F(Claims, MostCountsRuns) {
  Claim claim = less();
  claim.test = Claim::Test::most;
  claim.b.clear();
  claim.to = 20;
  EXPECT_EQ(verdict(claim, low_), Verdict::confirmed);
  EXPECT_EQ(verdict(claim, between_), Verdict::undecided);
  EXPECT_EQ(verdict(claim, high_), Verdict::refuted);
  both("a", low_);
  runs("a", 1, high_);                                   // 8 of 8 and 0 of 8: 2^-8 either way, by 4
  EXPECT_EQ(judge(claim, 2).verdict, Verdict::depends);  // 3 x 0.0156
  EXPECT_EQ(judge(claim, 3).verdict, Verdict::undecided);
}

TEST_F(Claims, NothingIsSaidWhereTheBaselineIsNotReproduced) {
  Claim claim = less();
  Claim baseline = less();
  baseline.a = "b";
  baseline.b.clear();
  baseline.from = 20;
  baseline.to = 30;
  claim.baseline = {baseline};
  EXPECT_EQ(judge(claim).verdict, Verdict::confirmed);
  claim.baseline[0].from = 40;
  claim.baseline[0].to = 80;
  EXPECT_EQ(judge(claim).verdict, Verdict::no_baseline);
}

TEST_F(Claims, ArithmeticIsListedWithItsExceptions) {
  Claim claim = less();
  claim.test = Claim::Test::arithmetic;
  claim.b.clear();
  claim.note = "the least so far";
  EXPECT_EQ(verdict(claim, low_), Verdict::arithmetic);
  EXPECT_EQ(judge(claim).figures, "the least so far; exceptions: 0");
  findings_.samples[0].runs[0].best = {5, 6};
  EXPECT_EQ(judge(claim).figures, "the least so far; exceptions: 1");
}

TEST_F(Claims, APartialReportHasNoVerdicts) {
  findings_.whole = false;
  const Evidence e = judge(less());
  EXPECT_EQ(e.verdict, Verdict::undecided);
  expect_says(e.figures, "interrupted");
}

TEST_F(Claims, WhatWasNotRecordedIsNotJudged) {
  Claim claim = less();
  claim.value.name = "cut-best";
  expect_says(judge(claim).figures, "not recorded");
}

TEST_F(Claims, AnAnswerWithoutIterationsIsAtItsTargetOrNever) {
  study::Run run{.length = 10.05};
  const Value within{.name = "effort", .at = "paths", .target = 0.01};
  EXPECT_EQ(value_of(findings_.samples[0], run, within, kUnknown, 10.0), 0);
  run.length = 10.2;
  EXPECT_EQ(value_of(findings_.samples[0], run, within, kUnknown, 10.0), kInfinity);
}

TEST_F(Claims, WithoutToursNothingOscillates) {
  study::Run run{.iterations = 4};
  const auto rises = [&] {
    return value_of(findings_.samples[0], run, {.name = "rises"}, kUnknown, {});
  };
  run.raw_best = {kUnknown, kUnknown, kUnknown, kUnknown};
  EXPECT_EQ(rises(), std::numeric_limits<double>::infinity());
  run.raw_best = {9, 8, kUnknown, 7};
  EXPECT_EQ(rises(), 0);
  run.raw_best = {9, 8, 9, 7};
  EXPECT_DOUBLE_EQ(rises(), 1.0 / 3);
  run.iteration_best = {9, 8, 8, 7};
  EXPECT_EQ(value_of(findings_.samples[0], run, {.name = "answer-rises"}, kUnknown, {}), 0);
}

}  // namespace
}  // namespace lasius::study
