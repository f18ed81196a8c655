// Maps and questions of a study's file.
#include <algorithm>
#include <cctype>
#include <set>

#include "core/base/did_you_mean.h"
#include "lasius/base/error.h"
#include "tools/console/values.h"
#include "tools/study/description/study_parts.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMaps = 10000;

/// What files and columns may be called.
std::string name_of(const std::string& text) {
  std::string name;
  for (const unsigned char c : text) {
    if (std::isalnum(c) != 0 || c == '.' || c == '_' || c >= 0x80)
      name += static_cast<char>(c);
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (name.ends_with('-') || name.ends_with('.')) name.pop_back();
  return name.empty() || name.front() == '.' ? "map" + name : name;
}

/// A map's source, refused where it can never be made.
void check_made(const std::string& source, const Node& place) {
  try {
    const GeneratedMap made = generated_map(source);
    const auto side = [](int n) { return n >= 1 && n <= Grid::kMaxSide; };
    if (!side(made.options.width) || !side(made.options.height))
      place.fail("has a size out of range", "sides are 1 to " + std::to_string(Grid::kMaxSide));
    if (made.options.density > max_density(made.kind))
      place.fail("is too dense", std::string(to_string(made.kind)) + " reaches " +
                                     tool::to_text(max_density(made.kind)));
  } catch (const Error& fault) {
    if (fault.code() == ErrorCode::file_broken) throw;
    place.fail(fault.problem(), fault.remedy());
  }
}

/// Every value of a key of a family, or the one that it has by default.
std::vector<std::string> choices(const Node& family, const char* name, const std::string& usual) {
  const Node* const node = family.find(name);
  return node == nullptr ? std::vector<std::string>{usual} : node->texts();
}

std::vector<std::string> family_of(const Node& family) {
  family.allow({"kind", "size", "density", "seeds"});
  const std::string kind(map_kind_names()[family.at("kind").choice(map_kind_names())]);
  const Seeds seeds = seeds_of(family.find("seeds"), {.first = 1, .count = 1});
  std::vector<std::string> sources;
  for (const Node& size : family.at("size").items()) {
    for (const std::string& density : choices(family, "density", "default")) {
      for (int s = 0; s < seeds.count; ++s) {
        if (sources.size() >= kMostMaps)
          family.fail("has too many maps", "at most " + std::to_string(kMostMaps) + " a name");
        const std::string seed = std::to_string(seeds.first + static_cast<std::uint64_t>(s));
        sources.push_back(kind + ' ' + size.text() + ' ' + density + ' ' + seed);
        check_made(sources.back(), size);
      }
    }
  }
  return sources;
}

/// A start or goal: a cell, or metres.
Point end_of(const Node& question, const char* name, bool needed, bool in_metres) {
  const Node* const node = needed ? &question.at(name) : question.find(name);
  if (node == nullptr) return {};
  if (!node->is_list() || node->items().size() != 2)
    node->fail(in_metres ? "is no point" : "is no cell", "write it as [X, Y]");
  const auto number = [&](std::size_t i) {
    constexpr int kFar = 1'000'000'000;  // whether it is on the map is seen there
    const Node& item = node->items()[i];
    return in_metres ? item.number(-kFar, kFar) : static_cast<double>(item.integer(-kFar, kFar));
  };
  return {number(0), number(1)};
}

/// FILE or FILE*FACTOR.
tool::CostLayers::Layer layer_of(const Node& node, const MapNames& maps) {
  const std::string& text = node.text();
  const auto star = text.rfind('*');
  const std::string file = text.substr(0, star);
  const auto factor =
      star == text.npos ? std::optional(1.0) : tool::parse_real(text.substr(star + 1));
  if (file.empty() || !factor || !(*factor >= 0 && *factor <= CostField::kMost))
    node.fail("is \"" + text + "\", no layer of costs", "say FILE or FILE*FACTOR");
  return {maps.beside(file), *factor};
}

/// What a question says of a place: cells, or metres.
void take_ends(const Node& node, const MapNames* maps, bool needed, Question& question) {
  constexpr std::string_view kFrames[] = {"cell", "world"};
  const Node* const frame = node.find("frame");
  question.in_metres = frame != nullptr && frame->choice(kFrames) == 1;
  question.radius = node.number_or("radius", 0, 0, tool::kNoLimit);
  if (const Node* const cost = node.find("cost")) {
    if (!cost->is_list()) question.layers.push_back(layer_of(*cost, *maps));
    for (std::size_t i = 0; cost->is_list() && i < cost->items().size(); ++i)
      question.layers.push_back(layer_of(cost->items()[i], *maps));
  }
  if (const Node* const inflation = node.find("inflation")) {
    const auto& numbers = inflation->items();
    if (numbers.size() < 2 || numbers.size() > 3)
      inflation->fail("has " + std::to_string(numbers.size()) + " numbers",
                      "say [RADIUS, SCALING] or [RADIUS, SCALING, WEIGHT]");
    question.inflation =
        Inflation{.radius = numbers[0].number(0, 20000), .scaling = numbers[1].number(0, 1000)};
    if (numbers.size() == 3) question.inflation->weight = numbers[2].number(0, CostField::kMost);
  }
  question.start_m = end_of(node, "start", needed, question.in_metres);
  question.goal_m = end_of(node, "goal", needed, question.in_metres);
  const auto cell = [](Point p) { return Cell{static_cast<int>(p.x), static_cast<int>(p.y)}; };
  if (question.in_metres) return;
  question.start = cell(question.start_m);
  question.goal = cell(question.goal_m);
}

std::optional<Draw> draw_of(const Node& question) {
  const Node* const node = question.find("draw");
  if (node == nullptr) return std::nullopt;
  for (const char* name : {"start", "goal"})
    if (const Node* const end = question.find(name))
      end->fail("is given, and drawn as well", "leave one of the two out");
  constexpr int kMostDrawn = 100000;
  Draw draw;
  if (!node->is_map()) {
    draw.count = static_cast<int>(node->integer(1, kMostDrawn));
    return draw;
  }
  node->allow({"count", "seed", "apart"});
  draw.count = static_cast<int>(node->integer_or("count", 1, 1, kMostDrawn));
  draw.seed = static_cast<std::uint64_t>(node->integer_or("seed", 1, 0, tool::kMaxExactInteger));
  draw.apart = node->number_or("apart", draw.apart, 0, 1);
  return draw;
}

std::vector<Published> published_of(const Node& question) {
  std::vector<Published> all;
  const Node* const node = question.find("published");
  if (node == nullptr) return all;
  for (const auto& [contender, figures] : node->entries()) {
    figures.allow({"length", "iterations", "seconds"});
    const auto figure = [&, &at = figures](const char* name) {
      return at.number_or(name, kUnknown, 0, tool::kNoLimit);
    };
    all.push_back({contender, figure("length"), figure("iterations"), figure("seconds")});
  }
  return all;
}

/// The maps of a question, with what they are called.
std::vector<std::pair<std::string, std::string>> maps_of(const Node& question,
                                                         const MapNames* maps) {
  std::vector<std::pair<std::string, std::string>> all;
  const Node* const map = question.find("map");
  const auto add = [&](const std::string& called, const std::vector<std::string>& sources) {
    for (const std::string& source : sources)
      all.emplace_back(
          sources.size() > 1 ? called + '-' + std::to_string(&source - sources.data() + 1) : called,
          source);
  };
  if (maps == nullptr) {
    add(question.at("name").text(), {question.at("map").text()});
  } else if (map != nullptr) {
    const std::string& text = map->text();
    add(name_of(
            question.text_or("name", is_generated(text) ? text : fs::path(text).stem().string())),
        maps->sources(*map));
  } else {
    for (const auto& [called, sources] : maps->all()) add(name_of(called), sources);
    if (all.empty()) (void)question.at("map");
  }
  return all;
}

}  // namespace

MapNames::MapNames(const Node* maps, fs::path folder) : folder_(std::move(folder)) {
  if (maps == nullptr) return;
  for (const auto& [name, map] : maps->entries()) named_.emplace_back(name, sources_of(map));
}

std::vector<std::string> MapNames::sources_of(const Node& map) const {
  if (map.is_map()) return family_of(map);
  std::vector<std::string> sources;
  for (const Node& item : map.items()) sources.push_back(source_of(item));
  if (sources.empty()) (void)map.text();
  return sources;
}

std::string MapNames::source_of(const Node& map) const {
  const std::string& text = map.text();
  if (is_generated(text)) {
    check_made(text, map);
    return text;
  }
  const std::string there = beside(text);
  std::error_code ignored;
  return fs::is_regular_file(there, ignored) ? there : text;
}

std::string MapNames::beside(const std::string& name) const {
  return fs::absolute((folder_ / name).lexically_normal()).string();
}

std::vector<std::string> MapNames::sources(const Node& map) const {
  const auto found = std::ranges::find(named_, map.text(), &decltype(named_)::value_type::first);
  if (found != named_.end()) return found->second;
  const std::string& text = map.text();
  if (!named_.empty() && !is_generated(text) && fs::path(text).extension().empty()) {
    std::vector<std::string_view> names;
    for (const auto& [name, sources] : named_) names.push_back(name);
    map.fail("is \"" + text + "\", no name of a map and no file", did_you_mean(text, names));
  }
  return {source_of(map)};
}

std::vector<Question> questions_of(const Node& list, const MapNames* maps) {
  std::vector<Question> questions;
  std::set<std::string> names;
  for (const Node& node : list.items()) {
    const bool bitmap = maps != nullptr;
    if (bitmap)
      node.allow({"name", "map", "start", "goal", "published", "draw", "radius", "frame", "cost",
                  "inflation"});
    else
      node.allow({"name", "map", "start", "goal", "published"});
    const auto draw = bitmap ? draw_of(node) : std::nullopt;
    const bool needed = bitmap && !draw;
    for (auto& [name, source] : maps_of(node, maps)) {
      if (!names.insert(name).second)
        node.fail("has two questions called \"" + name + "\"", "give one another name");
      questions.push_back({.name = name,
                           .map = source,
                           .start = {},
                           .goal = {},
                           .published = published_of(node),
                           .draw = draw,
                           .line = static_cast<int>(node.line())});
      take_ends(node, maps, needed, questions.back());
    }
  }
  if (questions.empty()) list.fail("has no question", "add {map, start, goal} or {map, draw}");
  return questions;
}

}  // namespace lasius::study
