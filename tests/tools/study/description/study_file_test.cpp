#include "tools/study/description/study_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lasius/base/error.h"
#include "lasius/grid/map_io.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"
#include "tests/tools/yaml/fault_line.h"
#include "tools/study/description/draws.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

const std::string kQuestions = "questions: [{map: grid20a.map, start: [0, 19], goal: [19, 0]}]\n";
const std::string kAs = "contenders: [{name: as, algorithm: as}]\n";

std::string fault(const std::string& text) {
  return fault_line([&] { return parse_study(text, "s.yaml"); }, "s.yaml");
}

std::vector<std::string> names_of(const std::vector<Contender>& contenders) {
  std::vector<std::string> names;
  for (const Contender& c : contenders) names.push_back(c.name);
  return names;
}

TEST(StudyFile, NeedsNoMoreThanContendersAndQuestions) {
  const Study study = parse_study(kAs + kQuestions, "folder/first.yaml");
  EXPECT_EQ(study.name, "first");
  EXPECT_EQ(study.seeds.first, 1U);
  EXPECT_EQ(study.seeds.count, 30);
  ASSERT_EQ(study.experiments.size(), 1U);
  const Experiment& e = study.experiments[0];
  EXPECT_EQ(e.name, "runs");
  EXPECT_EQ(names_of(e.contenders), std::vector<std::string>{"as"});
  ASSERT_EQ(e.questions.size(), 1U);
  EXPECT_EQ(e.questions[0].name, "grid20a");
  EXPECT_EQ(e.questions[0].goal, (Cell{19, 0}));
  EXPECT_EQ(e.targets, std::vector<double>{0.01});
}

TEST(StudyFile, ASweepMakesAContenderOfEachPoint) {
  const Study study = parse_study(
      "contenders:\n"
      "  - {name: plain, algorithm: as, sweep: no}\n"
      "  - {name: as, algorithm: as, label: ant system, set: {ants: 7, beta: 2}}\n"
      "  - {name: exact, algorithm: exact}\n"
      "sweep: {factors: {persistence: [0.5, 0.9], beta: {from: 1, to: 3, levels: 2}}}\n" +
      kQuestions);
  const auto& all = study.experiments[0].contenders;
  EXPECT_EQ(names_of(all),
            (std::vector<std::string>{"plain", "as-1", "as-2", "as-3", "as-4", "exact"}));
  EXPECT_TRUE(all[0].factors.empty());
  EXPECT_EQ(all[2].label, "ant system, persistence 0.5, beta 3");
  EXPECT_EQ(all[2].factors, (Settings{{"persistence", "0.5"}, {"beta", "3"}}));
  EXPECT_EQ(all[2].settings, (Settings{{"ants", "7"}, {"persistence", "0.5"}, {"beta", "3"}}));
  EXPECT_TRUE(all[5].settings.empty());  // it has none of the parameters
  const Study latin = parse_study(
      kAs + "sweep: {design: latin, points: 9, factors: {beta: {from: 2, to: 20, scale: log}}}\n" +
      kQuestions);
  EXPECT_EQ(latin.experiments[0].contenders.size(), 9U);
}

TEST(StudyFile, ABudgetEndsRunsInPlaceOfIterations) {
  const auto contender = [](const std::string& budget) {
    return parse_study("contenders: [{name: as, algorithm: as}]\nbudget: " + budget + "\n" +
                       kQuestions)
        .experiments[0]
        .contenders[0];
  };
  EXPECT_EQ(contender("{steps: 1e5}").settings, (Settings{{"iterations", "1000000000"}}));
  EXPECT_EQ(contender("{steps: 1e5}").budget.steps, 1e5);
  EXPECT_EQ(contender("{iterations: 40, seconds: 2}").settings, (Settings{{"iterations", "40"}}));
  EXPECT_EQ(contender("{iterations: 40, seconds: 2}").budget.seconds, 2);
  EXPECT_TRUE(std::isinf(contender("{iterations: 40}").budget.steps));
  // What a contender says of itself stands.
  const Study own = parse_study(
      "contenders: [{name: as, algorithm: as, set: {iterations: 9}, budget: {steps: 5}}]\n"
      "budget: {steps: 7}\n" +
      kQuestions);
  EXPECT_EQ(own.experiments[0].contenders[0].settings, (Settings{{"iterations", "9"}}));
  EXPECT_EQ(own.experiments[0].contenders[0].budget.steps, 5);
}

TEST(StudyFile, ANameStandsForAFamilyOfMaps) {
  const Study study =
      parse_study(kAs +
                  "maps:\n"
                  "  blobs: {kind: blobs, size: [60x40, 80x60], density: [0.2, 0.3], seeds: 5..6}\n"
                  "  maze: maze 41x41 default 3\n"
                  "questions:\n"
                  "  - {map: blobs, draw: 2}\n"
                  "  - {name: m, map: maze, draw: {count: 1, seed: 9, apart: 0.2}}\n");
  const auto& questions = study.experiments[0].questions;
  ASSERT_EQ(questions.size(), 9U);
  EXPECT_EQ(questions[0].map, "blobs 60x40 0.2 5");
  EXPECT_EQ(questions[3].map, "blobs 60x40 0.3 6");
  EXPECT_EQ(questions[7].map, "blobs 80x60 0.3 6");
  EXPECT_EQ(questions[7].name, "blobs-8");
  EXPECT_EQ(questions[7].draw->count, 2);
  EXPECT_EQ(questions[8].name, "m");
  EXPECT_EQ(questions[8].draw->seed, 9U);
  // A question without a map is asked on all of them.
  EXPECT_EQ(parse_study(
                kAs + "maps: {a: blobs 60x40 0.2 5, b: open 60x40 0.1 5}\nquestions: [{draw: 1}]\n")
                .experiments[0]
                .questions.size(),
            2U);
}

TEST(StudyFile, DrawnEndsAreJoinedApartAndTheSameAgain) {
  const std::string text = kAs +
                           "maps: {r: {kind: rooms, size: 70x60, seeds: 1..3}}\n"
                           "questions: [{map: r, draw: {count: 5, seed: 4, apart: 0.4}}]\n";
  Study study = parse_study(text), again = parse_study(text);
  draw_questions(study, {});
  draw_questions(again, {});
  const auto& questions = study.experiments[0].questions;
  ASSERT_EQ(questions.size(), 15U);
  EXPECT_EQ(questions[6].name, "r-2-2");
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const Question& q = questions[i];
    EXPECT_EQ(q.start, again.experiments[0].questions[i].start);
    EXPECT_EQ(q.goal, again.experiments[0].questions[i].goal);
    EXPECT_GE(std::hypot(q.start.x - q.goal.x, q.start.y - q.goal.y), 0.4 * std::hypot(70, 60));
    EXPECT_TRUE(Planner(load_map(q.map, {})).connected(q.start, q.goal)) << q.name;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(questions[k].map == q.map && questions[k].start == q.start) << q.name;
  }
}

TEST(StudyFile, EndsThatNoRobotCanHoldAreRefusedWithTheirLine) {
  const auto refused = [](const std::string& questions) {
    Study study = parse_study(kAs + "questions:\n" + questions, "s.yaml");
    return fault_line([&] { draw_questions(study, LASIUS_MAPS_DIR); }, study.file);
  };
  EXPECT_EQ(
      refused("  - {name: a, map: grid20a.map, start: [0, 19], goal: [19, 0]}\n"
              "  - {name: b, map: grid20a.map, start: [0, 19], goal: [20, 0]}\n"),
      "4: question \"b\" on grid20a.map: goal 20,0 is outside; the nearest free cell is 19,0");
  EXPECT_EQ(refused("  - {map: random 9x9 0.95 1, draw: {count: 1, apart: 1}}\n"),
            "3: question \"random-9x9-0.95-1\" on random 9x9 0.95 1: no two joined cells that far "
            "apart were found; say a smaller `apart`");
}

class StudyFiles : public Files {};

TEST_F(StudyFiles, LieBesideTheirMapsAndPresets) {
  write_map(Grid(9, 9), path("own.map"));
  file("algorithm: mmas\nset: {ants: 3, beta: 1}\n", "p.yaml");
  file(
      "contenders: [{name: m, algorithm: mmas, preset: p.yaml, set: {beta: 2}}]\n"
      "questions: [{map: own.map, draw: 1}, {map: grid20a.map, draw: 1}]\n",
      "s.yaml");
  const Study study = read_study(path("s.yaml"));
  EXPECT_EQ(study.file, path("s.yaml"));
  const Experiment& e = study.experiments[0];
  EXPECT_EQ(e.questions[0].map, path("own.map"));
  EXPECT_EQ(e.questions[1].map, "grid20a.map");  // the program's
  EXPECT_EQ(e.contenders[0].settings, (Settings{{"ants", "3"}, {"beta", "2"}}));
  EXPECT_THROW((void)read_study(path("none.yaml")), Error);
}

TEST(StudyFile, TheProgramsOwnAreFilesOfTheSameFormat) {
  for (const auto name : study_names()) {
    const Study study = make_study(name);
    EXPECT_EQ(study.name, name);
    EXPECT_FALSE(study.experiments.empty());
    EXPECT_TRUE(study.file.empty());
  }
}

TEST(StudyFile, TheDocumentsQuoteFilesThatAreRead) {
  const fs::path docs = fs::path(LASIUS_MAPS_DIR).parent_path() / "docs";
  const std::string page = bytes_of(docs / "studies.md");
  for (const char* name : {"study_persistence.yaml", "tune_mmas.yaml"}) {
    const std::string quoted = "```yaml\n" + bytes_of(docs / "examples" / name) + "```\n";
    EXPECT_NE(page.find(quoted), std::string::npos) << name << " is another one in docs/studies.md";
  }
  const Study study = read_study((docs / "examples/study_persistence.yaml").string());
  EXPECT_EQ(study.experiments[0].contenders.size(), 8U);
}

struct Refused {
  std::string text, fault;
};

TEST(StudyFile, RefusesMistakesWithLineAndKey) {
  const Refused studies[] = {
      {kQuestions, "1: 'contenders' is missing"},
      {kAs, "1: 'questions' is missing"},
      {"contenders: []\n" + kQuestions, "1: 'contenders' is empty"},
      {"contenders: [as]\n" + kQuestions, "1: 'contenders' is no map of keys and values"},
      {"contenders: [{algorithm: as}]\n" + kQuestions,
       "1: 'contenders' is incomplete: 'name' is missing"},
      {"contenders: [{name: as}]\n" + kQuestions,
       "1: 'contenders' is incomplete: 'algorithm' is missing"},
      {"contenders:\n- {name: as, algorithm: as}\n- {name: as, algorithm: acs}\n" + kQuestions,
       "1: 'contenders' has \"as\" twice"},
      {"contenders: [{name: a/b, algorithm: as}]\n" + kQuestions,
       "1: 'contenders' has \"a/b\", no name"},
      {"contenders:\n- name: a\n  algorithm: mmass\n" + kQuestions, "3: 'algorithm' is refused: "},
      {"contenders:\n- name: a\n  algorithm: as\n  set:\n    persistance: 0.4\n" + kQuestions,
       "5: 'persistance' is refused: "},
      {"contenders:\n- name: a\n  algorithm: as\n  set:\n    ants: 0\n" + kQuestions,
       "5: 'ants' is refused: "},
      {"contenders:\n- name: a\n  algorithm: as\n  set:\n    index_spread: 0\n    ants: x\n" +
           kQuestions,
       "6: 'ants' is refused: "},
      {"contenders:\n- name: a\n  algorithm: as\n  preset: bok\n" + kQuestions,
       "4: 'preset' is \"bok\"; did you mean \"book\"?"},
      {"contenders:\n- name: a\n  like: a\n" + kQuestions, "2: 'contenders' is like itself"},
      {"contenders:\n- {name: a, like: b}\n- {name: b, like: a}\n" + kQuestions,
       "'contenders' is like itself"},
      {kAs + "questions: []\n", "2: 'questions' has no question"},
      {kAs + "questions: [{start: [0, 0], goal: [1, 1]}]\n",
       "2: 'questions' is incomplete: 'map' is missing"},
      {kAs + "questions: [{map: a.map, start: [0, 0]}]\n",
       "2: 'questions' is incomplete: 'goal' is missing"},
      {kAs + "questions:\n- map: a.map\n  start: [0]\n  goal: [1, 1]\n", "4: 'start' is no cell"},
      {kAs + "questions:\n- map: a.map\n  start: [0, y]\n  goal: [1, 1]\n", "4: 'start' is \"y\""},
      {kAs + "questions:\n- map: a.map\n  draw: 3\n  goal: [1, 1]\n",
       "5: 'goal' is given, and drawn"},
      {kAs + "questions:\n- map: a.map\n  draw: 0\n", "4: 'draw' is \"0\""},
      {kAs + "questions:\n- map: a.map\n  draw: {apart: 2}\n", "4: 'apart' is \"2\""},
      {kAs + "questions:\n- {map: a.map, draw: 1}\n- {map: b/a.map, draw: 1}\n",
       "4: 'questions' has two questions called \"a\""},
      {kAs + "maps: {blobs: blobs 9x9 0.2 1}\nquestions: [{map: blob, draw: 1}]\n",
       "3: 'map' is \"blob\", no name of a map and no file; did you mean \"blobs\"?"},
      {kAs + "maps: {b: {kind: blob, size: 9x9}}\n" + kQuestions,
       "2: 'kind' is \"blob\"; did you mean \"blobs\"?"},
      {kAs + "maps: {b: {kind: blobs}}\n" + kQuestions, "2: 'b' is incomplete: 'size' is missing"},
      {kAs + "maps: {b: {kind: blobs, size: 9}}\n" + kQuestions, "2: 'size' no map is made by"},
      {kAs + "maps: {b: {kind: rooms, size: 9x9, density: 0.9}}\n" + kQuestions,
       "2: 'size' is too dense"},
      {kAs + "maps: {b: blobs 9x0 0.2 1}\n" + kQuestions, "2: 'b' has a size out of range"},
      {kAs + "experiments: []\n", "2: 'experiments' is empty"},
      {kAs + "experiments: [{name: a}]\n" + kQuestions,
       "2: 'experiments' is incomplete: 'title' is missing"},
      {kAs + "experiments: [{name: a, title: A}, {name: a, title: B}]\n" + kQuestions,
       "2: 'experiments' has two called \"a\""},
  };
  for (const Refused& c : studies) expect_says(fault(c.text), c.fault);
}

TEST(StudyFile, RefusesMistakesInWhatMayBeLeftOut) {
  const Refused additions[] = {
      {"seed: 3\n", "3: 'seed' is unknown here; did you mean \"seeds\"?"},
      {"seeds: 0\n", "3: 'seeds' is \"0\"; say N, or A..B"},
      {"seeds: 9..3\n", "3: 'seeds' is \"9..3\""},
      {"optimum: 6 moves\n", "3: 'optimum' is \"6 moves\"; did you mean \"4 moves\"?"},
      {"target: near\n", "3: 'target' is \"near\"; it is a number"},
      {"budget: {step: 5}\n", "3: 'step' is unknown here; did you mean \"steps\"?"},
      {"budget: {steps: -5}\n", "3: 'steps' is \"-5\""},
      {"world: flat\n", "3: 'world' is \"flat\""},
      {"compare: [az]\n", "3: 'compare' names no contender \"az\"; did you mean \"as\"?"},
      {"sweep: {points: 3}\n", "3: 'sweep' is incomplete: 'factors' is missing"},
      {"sweep: {factors: {}}\n", "3: 'factors' is empty"},
      {"sweep:\n  factors:\n    persistance: [1]\n",
       "5: 'persistance' is no parameter of them; did you mean \"persistence\"?"},
      {"sweep:\n  factors:\n    ants: []\n", "5: 'ants' has no values"},
      {"sweep:\n  factors:\n    ants: {from: 1, to: 9}\n", "5: 'ants' is a range, and a grid"},
      {"sweep:\n  factors:\n    ants: {from: 9, to: 1, levels: 2}\n", "5: 'to' is \"1\""},
      {"sweep:\n  factors:\n    polish: {from: 9, to: 10, levels: 2}\n",
       "5: 'polish' has no range"},
      {"sweep:\n  factors:\n    ants: [3, many]\n", "4: 'factors' is refused: "},
      {"sweep: {design: latin, factors: {ants: [1]}}\n",
       "3: 'sweep' is incomplete: 'points' is missing"},
      {"sweep: {design: cube, factors: {ants: [1]}}\n", "3: 'design' is \"cube\""},
      {"sweep: {factors: {ants: {from: 1, to: 999, levels: 999}, beta: {from: 0, to: 9, "
       "levels: 99}}}\n",
       "3: 'factors' makes 98901 points"},
      {"claims:\n- {test: les}\n", "4: 'test' is \"les\"; did you mean \"less\"?"},
      {"claims:\n- {test: less, a: as}\n", "4: 'claims' is incomplete: 'b' is missing"},
      {"claims:\n- {test: most, a: az}\n",
       "4: 'a' names no contender \"az\"; did you mean \"as\"?"},
      {"claims:\n- {test: less, a: as, b: [as, az]}\n", "4: 'b' names no contender \"az\""},
      {"claims:\n- {test: most, a: as, in: [run]}\n",
       "4: 'in' names no experiment \"run\"; did you mean \"runs\"?"},
      {"claims:\n- {test: most, a: as, value: beauty}\n", "4: 'value' is \"beauty\""},
      {"claims:\n- {test: most, a: as, at: noon}\n", "4: 'at' is \"noon\""},
      {"claims:\n- {test: most, a: as, share: 2}\n", "4: 'share' is \"2\""},
  };
  for (const Refused& c : additions) expect_says(fault(kAs + kQuestions + c.text), c.fault);
}

}  // namespace
}  // namespace lasius::study
