#include "tools/study/tune/tuning.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "lasius/base/error.h"
#include "tools/console/signals.h"
#include "tools/console/values.h"
#include "tools/study/bitmaps.h"
#include "tools/study/description/draws.h"
#include "tools/study/map_source.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

/// What ranks compare: lengths that differ by a rounding are equal.
double value_of_run(const Findings& findings, const Sample& sample, const Run& run,
                    const Value& value) {
  const double taken = value_of(sample, run, value, value.budget,
                                findings.optimum(*sample.experiment, *sample.question));
  return std::isfinite(taken) ? std::round(taken * 1e7) / 1e7 : kInfinity;
}

/// Some candidates on one question, or the judges on all.
Study part_of(const Study& study, std::vector<Contender> contenders,
              std::span<const Question> questions) {
  Study part = study;
  Experiment& e = part.experiments.front();
  e.contenders = std::move(contenders);
  e.questions.assign(questions.begin(), questions.end());
  return part;
}

class TuningRun {
 public:
  TuningRun(Tuning& tuning, const TuneOptions& options)
      : tuning_(tuning), options_(options), training_(tuning.training, options.maps) {}

  Tuned run() {
    Tuned tuned{.race = Race(tuning_.candidates.size(), tuning_.rules)};
    for (int block = 0; block < tuning_.blocks && tuned.race.left().size() > 1; ++block) {
      if (!run_block(block, tuned)) return tuned;
      if (options_.progress)
        options_.progress(block + 1, tuning_.blocks,
                          tool::counted(tuned.race.left().size(), "candidate") + " left");
    }
    const std::size_t winner = tuned.race.best();
    tuned.judged = winner != 0 ? winner : tuned.race.rival();
    tuned.whole = run_judges(tuning_.candidates[tuned.judged], tuned);
    return tuned;
  }

 private:
  RunnerOptions runner(std::uint64_t first_seed, int seeds) const {
    return {.seeds = seeds,
            .threads = options_.threads,
            .folder = options_.folder,
            .stop = options_.stop,
            .first_seed = first_seed,
            .tell_all = true};
  }

  static void check_all_ran(const Findings& findings) {
    if (findings.skipped.empty()) return;
    const SkippedContender& skipped = findings.skipped.front();
    throw Error(ErrorCode::invalid_parameter, skipped.contender + " cannot run: " + skipped.reason,
                "change the parameters or their ranges");
  }

  /// False where it was interrupted.
  bool run_block(int block, Tuned& tuned) {
    const auto& questions = tuning_.training.experiments.front().questions;
    const auto number = static_cast<std::size_t>(block);
    const Question& question = questions[number % questions.size()];
    std::vector<Contender> left;
    for (const std::size_t c : tuned.race.left()) left.push_back(tuning_.candidates[c]);
    const Study part = part_of(tuning_.training, left, {&question, 1});
    RunnerOptions runner = this->runner(1 + number / questions.size(), 1);
    if (block == 0 && options_.estimate)
      runner.estimate = [&](std::size_t, double seconds) { estimate(seconds); };
    const Findings findings = run_study(part, training_, runner);
    if (!findings.whole) return false;
    check_all_ran(findings);
    std::vector<double> values;
    for (const Sample& sample : findings.samples) {
      const Run& run = sample.runs.front();
      values.push_back(value_of_run(findings, sample, run, tuning_.value));
      tuned.rows.push_back({std::to_string(block + 1), question.name, question.map,
                            std::to_string(run.seed), sample.contender->name,
                            tool::finite_text(values.back())});
    }
    tuned.race.add(values);
    return true;
  }

  /// From what the first block takes.
  void estimate(double block) const {
    const double judges = 2.0 * tuning_.judging.seeds.count *
                          static_cast<double>(tuning_.judging.experiments.front().questions.size());
    options_.estimate(block *
                      (tuning_.blocks + judges / static_cast<double>(tuning_.candidates.size())));
  }

  bool run_judges(const Contender& judged, Tuned& tuned) {
    const Bitmaps domain(tuning_.judging, options_.maps);
    const Study part = part_of(tuning_.judging, {judged, tuning_.candidates.front()},
                               tuning_.judging.experiments.front().questions);
    RunnerOptions runner = this->runner(tuning_.judging.seeds.first, tuning_.judging.seeds.count);
    runner.progress = options_.progress;
    const Findings findings = run_study(part, domain, runner);
    check_all_ran(findings);
    const tool::EndAtOnce runs_are_kept;
    if (findings.whole) tuned.families = judge(findings, tuning_, judged.name);
    return findings.whole;
  }

  Tuning& tuning_;
  const TuneOptions& options_;
  Bitmaps training_;
};

std::string family_name(const Question& question) {
  return is_generated(question.map) ? question.map.substr(0, question.map.find(' ')) : question.map;
}

void weigh(Family& family) {
  family.test = rank_test(family.pairs);
  family.p = std::min(1.0, 2 * std::min(family.test.less, family.test.greater));
  family.effect = resampled_interval(family.pairs, share_less);
  family.ratio = median_ratio(family.pairs);
  family.ratios = resampled_interval(family.pairs, median_ratio);
}

/// Maps of other names, and generated ones of other seeds, may have the same cells.
/// @throws Error(file_broken)
void check_maps_apart(const Tuning& tuning, const std::filesystem::path& maps) {
  std::map<std::string, std::uint64_t> known;
  const auto hash_of = [&](const Question& q) {
    const auto [at, is_new] = known.try_emplace(q.map);
    if (is_new) at->second = load_map(q, maps).hash();
    return at->second;
  };
  for (const Question& judge : tuning.judging.experiments.front().questions)
    for (const Question& trained : tuning.training.experiments.front().questions)
      if (hash_of(judge) == hash_of(trained))
        throw Error(ErrorCode::file_broken, {.file = tuning.file},
                    "\"" + judge.map + "\", which is judged on, has the cells of \"" + trained.map +
                        "\", which is trained on",
                    "name `judging` maps of other cells");
}

}  // namespace

Tuned tune(Tuning& tuning, const TuneOptions& options) {
  {
    const tool::EndAtOnce nothing_is_polled;
    draw_questions(tuning.training, options.maps);
    draw_questions(tuning.judging, options.maps);
    check_maps_apart(tuning, options.maps);
  }
  return TuningRun(tuning, options).run();
}

std::vector<Family> judge(const Findings& findings, const Tuning& tuning,
                          const std::string& candidate) {
  std::vector<Family> families{{.name = ""}};
  const auto values = [&](const Sample& sample) {
    return sample.each(
        [&](const Run& run) { return value_of_run(findings, sample, run, tuning.value); });
  };
  for (const Sample& a : findings.samples) {
    if (a.contender->name != candidate) continue;
    const Sample* const b = findings.find(a.experiment->name, a.question->name, "default");
    const std::string name = family_name(*a.question);
    auto family = std::ranges::find(families, name, &Family::name);
    if (family == families.end()) family = families.insert(family, {.name = name});
    for (Family* const to : {families.data(), &*family})
      to->pairs.push_back({values(a), values(*b)});
  }
  std::vector<double> p;
  for (Family& family : families) {
    weigh(family);
    if (!family.name.empty()) p.push_back(family.p);
  }
  p = holm(p);
  for (std::size_t i = 0; i < p.size(); ++i) families[i + 1].p = p[i];
  return families;
}

}  // namespace lasius::study
