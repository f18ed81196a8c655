#include "tools/study/study_file.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/io/json_values.h"
#include "tools/study/claims.h"

namespace lasius::study {
namespace {

using json::Json;

constexpr std::string_view kTenfold = "-x10";

/// A text, or the lines of one; empty where there is none.
std::string text_of(const Json& object, const char* name) {
  if (!object.contains(name)) return {};
  const Json& json = object.at(name);
  if (json.is_string()) return json.get<std::string>();
  std::string text;
  for (const auto& line : json) {
    if (!text.empty()) text += ' ';
    text += line.get<std::string>();
  }
  return text;
}

/// Puts in what each $WORD stands for.
std::string filled(std::string text, const Json& words) {
  for (const auto& [word, value] : words.items()) {
    const std::string name = '$' + word;
    for (std::size_t at; (at = text.find(name)) != std::string::npos;)
      text.replace(at, name.size(), value.get<std::string>());
  }
  return text;
}

Contender contender_of(const Json& study, std::string name, const Json& words) {
  const Json& all = study.at("contenders");
  const auto found = std::ranges::find_if(all, [&](const Json& c) { return c.at("name") == name; });
  if (found == all.end() && name.ends_with(kTenfold))
    return tenfold(contender_of(study, name.substr(0, name.size() - kTenfold.size()), words));
  if (found == all.end()) throw std::invalid_argument("no contender " + name);
  Contender contender{std::move(name), found->at("label"), found->at("algorithm")};
  const Json settings = found->value("set", Json::object());
  for (const auto& [parameter, value] : settings.items())
    contender.settings.emplace_back(parameter, filled(value.get<std::string>(), words));
  return contender;
}

std::vector<Contender> contenders_of(const Json& study, const Json& experiment, const Json& words) {
  Json names = experiment.value("compare", study.value("compare", Json::array()));
  if (names.empty())
    for (const Json& contender : study.at("contenders")) names.push_back(contender.at("name"));
  std::vector<Contender> contenders;
  for (const Json& name : names) contenders.push_back(contender_of(study, name, words));
  return contenders;
}

Cell cell_of(const Json& question, const char* name) {
  const auto [x, y] = question.value(name, std::array{0, 0});
  return {x, y};
}

std::vector<Question> questions_of(const Json& list) {
  std::vector<Question> questions;
  for (const Json& json : list) {
    Question& q = questions.emplace_back(Question{.name = json.at("name"),
                                                  .map = json.at("map"),
                                                  .start = cell_of(json, "start"),
                                                  .goal = cell_of(json, "goal")});
    const Json published = json.value("published", Json::object());
    for (const auto& [contender, figures] : published.items())
      q.published.push_back({contender, figures.value("length", kUnknown),
                             figures.value("iterations", kUnknown),
                             figures.value("seconds", kUnknown)});
  }
  return questions;
}

Truth truth_of(const std::string& optimum) {
  if (optimum == "4 moves") return {Truth::Kind::moves, Neighbours::four};
  if (optimum == "8 moves") return {Truth::Kind::moves, Neighbours::eight};
  if (optimum == "any-angle") return {};
  throw std::invalid_argument("no optimum " + optimum);
}

Experiment experiment_of(const Json& study, const Json& json) {
  const Json words = json.value("where", Json::object());
  return {.name = json.at("name"),
          .title = json.at("title"),
          .text = filled(text_of(json, "text"), words),
          .truth = truth_of(json.value("optimum", "any-angle")),
          .contenders = contenders_of(study, json, words),
          .questions = questions_of(json.contains("questions") ? json.at("questions")
                                                               : study.at("questions")),
          .portrait = json.value("portrait", false),
          .by_ant = json.value("by_ant", false)};
}

Check check_of(const Json& claim) {
  const std::string kind = claim.at("check");
  const Experiments in = claim.at("in");
  const std::string a = claim.at("a"), b = claim.value("b", "");
  const auto number = [&](const char* name) { return claim.at(name).get<int>(); };
  if (kind == "shorter_everywhere") return shorter_everywhere(in, a, b);
  if (kind == "sooner_everywhere") return sooner_everywhere(in, a, b);
  if (kind == "faster_everywhere") return faster_everywhere(in, a, b, claim.at("factor"));
  if (kind == "best_never_longer") return best_never_longer(in, a, b, number("runs"));
  if (kind == "best_is_optimal") return best_is_optimal(in, a, number("runs"), number("questions"));
  if (kind == "optimum_by") return optimum_by(in, a, number("median"), number("worst"));
  if (kind == "converged_by") return converged_by(in, a, number("iteration"));
  if (kind == "never_rises") return never_rises(in, a);
  throw std::invalid_argument("no check " + kind);
}

}  // namespace

Study parse_study(std::string_view text) {
  const Json json = json::read(text, "a study");
  Study study{.name = json.at("name"),
              .summary = json.at("summary"),
              .source = text_of(json, "source"),
              .text = text_of(json, "text"),
              .experiments = {},
              .claims = {}};
  for (const Json& experiment : json.at("experiments"))
    study.experiments.push_back(experiment_of(json, experiment));
  for (const Json& claim : json.value("claims", Json::array()))
    study.claims.push_back({text_of(claim, "text"), check_of(claim), text_of(claim, "reason")});
  return study;
}

Contender tenfold(const Contender& contender) {
  Contender more = contender;
  more.name += kTenfold;
  more.label += " x10";
  more.budget = 10;
  return more;
}

}  // namespace lasius::study
