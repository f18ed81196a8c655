#include "tools/study/tune/tune_file.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "tools/console/values.h"
#include "tools/study/description/study_parts.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

/// Between the seeds of training and of judging maps.
constexpr std::uint64_t kOtherSeeds = 1'000'000;

std::vector<Contender> candidates_of(const Node& root, const fs::path& folder) {
  constexpr int kMostCandidates = 1000;
  std::vector<Contender> all{described_contender(root, "default", {}, nullptr, folder)};
  const Node& parameters = root.at("parameters");
  const auto factors = factors_of(parameters, {all.front().algorithm});
  const auto drawn = static_cast<int>(root.integer_or("candidates", 24, 2, kMostCandidates)) - 1;
  const auto seed =
      static_cast<std::uint64_t>(root.integer_or("seed", 1, 0, tool::kMaxExactInteger));
  for (const Settings& point : design_points(Design::latin, factors, drawn, seed))
    all.push_back(
        described_contender(root, "c" + std::to_string(all.size()), point, &parameters, folder));
  return all;
}

/// The question on a map of another seed.
Question on_another_map(Question question, const Node& training) {
  if (!question.draw || !is_generated(question.map))
    training.fail("has \"" + question.name + "\", which there is not elsewhere",
                  "name `judging` maps, or train on generated ones with ends that are drawn");
  std::istringstream words(question.map);
  std::string kind, size, density;
  std::uint64_t seed = 0;
  words >> kind >> size >> density >> seed;
  question.map = kind + ' ' + size + ' ' + density + ' ' + std::to_string(seed + kOtherSeeds);
  return question;
}

Study study_of(const Tuning& tuning, const char* name, std::vector<Question> questions) {
  Study study{.name = tuning.name, .summary = {}, .source = {}, .text = {}};
  study.file = tuning.file;
  Experiment& e = study.experiments.emplace_back();
  e.name = name;
  e.optimum = tuning.optimum;
  e.questions = std::move(questions);
  return study;
}

/// @throws where a judging map is among those of the training.
void check_apart(const std::vector<Question>& training, const std::vector<Question>& judging,
                 const Node& place) {
  for (const Question& q : judging)
    if (std::ranges::find(training, q.map, &Question::map) != training.end())
      place.fail("has \"" + q.map + "\", which is trained on", "judge on other maps");
}

}  // namespace

Tuning read_tuning(const std::string& file) {
  const Node root = tool::read_document(file, FileKind::tuning);
  root.allow({"name", "algorithm", "preset", "set", "parameters", "candidates", "seed", "budget",
              "value", "at", "target", "optimum", "maps", "training", "judging", "seeds", "race"});
  const fs::path path(file);
  Tuning tuning{.name = root.text_or("name", path.stem().string()), .file = file};
  tuning.candidates = candidates_of(root, path.parent_path());
  // All but the iterations that a budget adds.
  const Node* const set = root.find("set");
  for (const auto& setting : tuning.candidates.front().settings)
    if (setting.first != "iterations" || root.find("budget") == nullptr ||
        (set != nullptr && set->find(setting.first)))
      tuning.fixed.push_back(setting);
  tuning.value = value_of_claim(root);
  tuning.optimum = optimum_of(root.find("optimum"));
  if (const Node* const race = root.find("race")) {
    race->allow({"first_test", "blocks", "level"});
    tuning.rules.first_test = static_cast<int>(race->integer_or("first_test", 6, 2, 1000));
    tuning.rules.level = race->number_or("level", 0.05, 1e-6, 0.5);
    tuning.blocks = static_cast<int>(race->integer_or("blocks", 40, 2, 100000));
  }
  const MapNames maps(root.find("maps"), path.parent_path());
  const auto training = questions_of(root.at("training"), &maps);
  std::vector<Question> judging;
  if (const Node* const node = root.find("judging")) {
    judging = questions_of(*node, &maps);
    check_apart(training, judging, *node);
  } else {
    for (const Question& q : training) judging.push_back(on_another_map(q, root.at("training")));
  }
  tuning.training = study_of(tuning, "race", training);
  tuning.training.experiments.front().contenders = tuning.candidates;
  tuning.judging = study_of(tuning, "judge", std::move(judging));
  tuning.judging.seeds = seeds_of(root.find("seeds"), {.first = 1, .count = 10});
  return tuning;
}

}  // namespace lasius::study
