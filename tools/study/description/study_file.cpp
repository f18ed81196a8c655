#include "tools/study/description/study_file.h"

#include <algorithm>
#include <filesystem>

#include "tools/study/description/study_parts.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

std::vector<std::pair<std::string, std::vector<std::string>>> charts_of(const Node* charts) {
  std::vector<std::pair<std::string, std::vector<std::string>>> all;
  if (charts == nullptr) return all;
  for (const auto& [name, contenders] : charts->entries())
    all.emplace_back(name, contenders.texts());
  return all;
}

/// The study's file as its parts see it.
class StudyReader {
 public:
  StudyReader(const Node& root, fs::path folder)
      : root_(root),
        folder_(std::move(folder)),
        bitmap_(kind_of(root.find("world")) == ProblemKind::bitmap),
        maps_(bitmap_ ? root.find("maps") : nullptr, folder_) {}

  Study read(const std::string& name) const {
    root_.allow({"name",    "summary",     "source",   "text",      "world",   "unit",
                 "seeds",   "contenders",  "compare",  "questions", "maps",    "sweep",
                 "budget",  "experiments", "claims",   "title",     "optimum", "target",
                 "targets", "charts",      "portrait", "by_ant"});
    Study study{.name = root_.text_or("name", name),
                .summary = root_.text_or("summary", ""),
                .source = root_.joined_or_empty("source"),
                .text = root_.joined_or_empty("text"),
                .kind = kind_of(root_.find("world")),
                .unit = root_.text_or("unit", "cells"),
                .seeds = seeds_of(root_.find("seeds"), {})};
    if (const Node* const experiments = root_.find("experiments"))
      for (const Node& experiment : experiments->items())
        study.experiments.push_back(experiment_of(experiment));
    else
      study.experiments.push_back(only_experiment());
    check_names(study);
    if (const Node* const claims = root_.find("claims"))
      for (const Node& claim : claims->items())
        std::ranges::move(claims_of(claim, study.experiments), std::back_inserter(study.claims));
    return study;
  }

 private:
  static ProblemKind kind_of(const Node* world) {
    static constexpr std::string_view kNames[] = {"bitmap", "polygon", "arm", "online", "tours"};
    return world == nullptr ? ProblemKind::bitmap : static_cast<ProblemKind>(world->choice(kNames));
  }

  Experiment experiment_of(const Node& node) const {
    node.allow({"name", "title", "text", "optimum", "where", "compare", "questions", "target",
                "targets", "charts", "portrait", "by_ant"});
    Experiment e = filled_in(node, words_of(node.find("where")));
    e.name = node.at("name").text();
    e.title = node.at("title").text();
    return e;
  }

  /// Of a file without a list of them.
  Experiment only_experiment() const {
    Experiment e = filled_in(root_, {});
    e.name = "runs";
    e.title = root_.text_or("title", "Runs");
    e.text.clear();  // the study's, told before
    return e;
  }

  /// What a node says, or else the study.
  const Node* own_or_root(const Node& node, const char* name) const {
    const Node* const own = node.find(name);
    return own != nullptr ? own : root_.find(name);
  }

  Experiment filled_in(const Node& node, const Words& words) const {
    const Node* const questions = own_or_root(node, "questions");
    if (questions == nullptr) (void)node.at("questions");
    Experiment e{.name = {}, .title = {}, .text = filled(node.joined_or_empty("text"), words)};
    e.optimum = optimum_of(own_or_root(node, "optimum"));
    e.contenders = contenders_of(root_, node.find("compare"), words, folder_, bitmap_);
    e.questions = questions_of(*questions, bitmap_ ? &maps_ : nullptr);
    e.portrait = node.flag_or("portrait", false);
    e.by_ant = node.flag_or("by_ant", false);
    e.charts = charts_of(node.find("charts"));
    for (const char* name : {"target", "targets"}) {
      const Node* const targets = own_or_root(node, name);
      if (targets == nullptr) continue;
      e.targets.clear();
      for (const Node& target : targets->items()) e.targets.push_back(target.number(0, 1000));
      if (e.targets.empty()) targets->fail("is empty", "list fractions, as in [0.01]");
    }
    return e;
  }

  void check_names(const Study& study) const {
    for (const Experiment& e : study.experiments)
      if (std::ranges::count(study.experiments, e.name, &Experiment::name) > 1)
        root_.at("experiments").fail("has two called \"" + e.name + "\"", "give one another name");
    if (study.experiments.empty())
      root_.at("experiments").fail("is empty", "leave it out, or add {name, title}");
  }

  const Node& root_;
  fs::path folder_;
  bool bitmap_;
  MapNames maps_;
};

}  // namespace

Optimum optimum_of(const Node* optimum) {
  static constexpr std::string_view kNames[] = {"any-angle", "4 moves", "8 moves"};
  switch (optimum == nullptr ? 0 : optimum->choice(kNames)) {
    case 1:
      return {Optimum::Kind::moves, Neighbours::four};
    case 2:
      return {Optimum::Kind::moves, Neighbours::eight};
    default:
      return {};
  }
}

Words words_of(const Node* where) {
  Words words;
  if (where == nullptr) return words;
  for (const auto& [word, value] : where->entries()) words.emplace_back(word, value.text());
  return words;
}

std::string filled(std::string text, const Words& words) {
  for (const auto& [word, value] : words) {
    const std::string name = '$' + word;
    for (auto at = text.find(name); at != std::string::npos;
         at = text.find(name, at + value.size()))
      text.replace(at, name.size(), value);
  }
  return text;
}

Study parse_study(std::string_view text, const std::string& file) {
  const Node root = tool::parse_document(std::string(text), file);
  return StudyReader(root, fs::path(file).parent_path()).read(fs::path(file).stem().string());
}

Study read_study(const std::string& file) {
  const Node root = tool::read_document(file, FileKind::study);
  Study study =
      StudyReader(root, fs::path(file).parent_path()).read(fs::path(file).stem().string());
  study.file = file;
  return study;
}

}  // namespace lasius::study
