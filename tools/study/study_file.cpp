#include "tools/study/study_file.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/io/json_values.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

using json::Json;

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
  if (found == all.end()) throw std::invalid_argument("no contender " + name);
  const std::string like = found->value("like", "");
  Contender contender = like.empty() ? Contender{.algorithm = found->at("algorithm")}
                                     : contender_of(study, like, words);
  contender.name = std::move(name);
  if (found->value("preset", "") == "book") contender.preset = Preset::book;
  contender.label = found->value("label", contender.name);
  const Json settings = found->value("set", Json::object());
  for (const auto& [parameter, value] : settings.items()) {
    const std::string set = parameter;
    std::erase_if(contender.settings, [&](const auto& s) { return s.first == set; });
    contender.settings.emplace_back(set, filled(value.get<std::string>(), words));
  }
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

std::vector<std::pair<std::string, std::vector<std::string>>> charts_of(const Json& json) {
  std::vector<std::pair<std::string, std::vector<std::string>>> charts;
  const Json list = json.value("charts", Json::object());
  for (const auto& [name, contenders] : list.items()) charts.emplace_back(name, contenders);
  return charts;
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
          .target = json.value("target", 0.01),
          .portrait = json.value("portrait", false),
          .by_ant = json.value("by_ant", false),
          .charts = charts_of(json)};
}

Claim::Test test_of(const std::string& name) {
  constexpr std::array<const char*, 5> kNames{"less", "similar", "most", "arithmetic", "none"};
  const auto* const found = std::ranges::find(kNames, name);
  if (found == kNames.end()) throw std::invalid_argument("no test " + name);
  return static_cast<Claim::Test>(found - kNames.begin());
}

/// A claim against one control, or none.
Claim claim_of(const Json& json, std::string control) {
  Claim claim{.text = text_of(json, "text"), .place = json.value("place", "")};
  claim.test = test_of(json.at("test"));
  claim.note = text_of(json, "note");
  if (claim.test == Claim::Test::none) return claim;
  claim.in = json.at("in");
  claim.a = json.at("a");
  claim.b = std::move(control);
  claim.value = {.name = json.value("value", "length"),
                 .at = json.value("at", "end"),
                 .budget = json.value("budget", kUnknown),
                 .target = json.value("target", 0.0),
                 .best_of = json.value("best_of", 1),
                 .own_limit = json.value("own_limit", false)};
  if (claim.test != Claim::Test::arithmetic) (void)value_text(claim.value);
  claim.factor = json.value("factor", claim.factor);
  claim.within = json.value("within", claim.within);
  claim.share = json.value("share", claim.share);
  claim.from = json.value("from", claim.from);
  claim.to = json.value("to", claim.to);
  return claim;
}

/// One for each control, and each experiment of `in_each`.
std::vector<Claim> claims_of(const Json& json) {
  std::vector<std::string> controls{""};
  if (json.contains("b"))
    controls = json.at("b").is_string() ? std::vector<std::string>{json.at("b")}
                                        : json.at("b").get<std::vector<std::string>>();
  std::vector<Claim> claims;
  if (json.contains("in_each")) {
    Json one = json;
    one.erase("in_each");
    for (const Json& experiment : json.at("in_each")) {
      one["in"] = Json::array({experiment});
      std::ranges::move(claims_of(one), std::back_inserter(claims));
    }
    return claims;
  }
  for (const std::string& control : controls) {
    claims.push_back(claim_of(json, control));
    if (!json.contains("baseline")) continue;
    Json baseline = json.at("baseline");
    baseline["in"] = json.at("in");
    baseline["test"] = "most";
    claims.back().baseline.push_back(claim_of(baseline, ""));
  }
  return claims;
}

World world_of(const std::string& name) {
  if (name == "bitmap") return World::bitmap;
  if (name == "polygon") return World::polygon;
  if (name == "arm") return World::arm;
  if (name == "online") return World::online;
  throw std::invalid_argument("no world " + name);
}

}  // namespace

Study parse_study(std::string_view text) {
  const Json json = json::read(text, "a study");
  Study study{.name = json.at("name"),
              .summary = json.at("summary"),
              .source = text_of(json, "source"),
              .text = text_of(json, "text"),
              .world = world_of(json.value("world", "bitmap")),
              .unit = json.value("unit", "cells"),
              .seeds = json.value("seeds", 30),
              .experiments = {},
              .claims = {}};
  for (const Json& experiment : json.at("experiments"))
    study.experiments.push_back(experiment_of(json, experiment));
  for (const Json& claim : json.value("claims", Json::array()))
    for (Claim& one : claims_of(claim)) study.claims.push_back(std::move(one));
  return study;
}

}  // namespace lasius::study
