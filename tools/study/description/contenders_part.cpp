// Contenders, sweep, budget and seeds of a study's file.
#include <algorithm>
#include <set>

#include "core/base/did_you_mean.h"
#include "lasius/base/error.h"
#include "tools/console/values.h"
#include "tools/study/description/study_parts.h"
#include "tools/yaml/preset_file.h"

namespace lasius::study {
namespace {

constexpr int kMostPoints = 10000;
constexpr std::int64_t kEndlessIterations = 1'000'000'000;

/// A setting, and where it stands.
struct Placed {
  std::string name, value;
  const Node* place;
};

/// A contender as a file describes it, before a sweep makes several of it.
struct Entry {
  Contender contender;
  std::vector<Placed> settings = {};
  const Node* place = nullptr;
  const Node* algorithm = nullptr;
  const Node* budget = nullptr;
  bool swept = true;

  void set(const std::string& name, std::string value, const Node& where) {
    const auto parameter = tool::parameter_meant_by(name);
    std::erase_if(settings,
                  [&](const Placed& s) { return tool::parameter_meant_by(s.name) == parameter; });
    settings.push_back({name, std::move(value), &where});
  }
};

class Reader {
 public:
  Reader(const Node& study, const Words& words, std::filesystem::path folder, bool checked)
      : study_(study), words_(words), folder_(std::move(folder)), checked_(checked) {}

  Entry described(const std::string& name, const Node& asked, int depth = 0) const {
    const Node& found = node_of(name, asked);
    found.allow({"name", "label", "algorithm", "preset", "set", "like", "budget", "sweep"});
    const Node* const like = found.find("like");
    if (depth > 20 || (like != nullptr && like->text() == name))
      found.fail("is like itself", "name another contender");
    Entry d = like != nullptr ? described(like->text(), *like, depth + 1) : Entry{};
    take(d, found, like == nullptr);
    d.contender.name = name;
    d.contender.label = found.text_or("label", name);
    d.swept = found.flag_or("sweep", d.swept);
    return d;
  }

  /// What a map says of a contender; `named`: of its algorithm, too.
  void take(Entry& d, const Node& from, bool named) const {
    d.place = &from;
    if (named) {
      d.algorithm = &from.at("algorithm");
      d.contender.algorithm = d.algorithm->text();
    }
    if (const Node* const preset = from.find("preset")) take_preset(d, *preset);
    if (const Node* const set = from.find("set")) {
      tool::refuse_both_words(*set);
      for (const auto& [parameter, value] : set->entries())
        d.set(parameter, filled(value.text(), words_), value);
    }
    if (const Node* const budget = from.find("budget")) d.budget = budget;
  }

  /// With the budget's settings, tried where that can be.
  Contender finished(Entry d, const Settings& point, const Node* sweep) const {
    Contender& c = d.contender;
    const Node* const budget = d.budget != nullptr ? d.budget : study_.find("budget");
    if (budget != nullptr && !checked_) budget->fail("is for bitmaps", "set iterations instead");
    c.budget = budget_of(budget);
    c.factors = point;
    for (const auto& [name, value] : point) d.set(name, value, *sweep);
    const std::string iterations = iterations_of(budget);
    if (!iterations.empty() && takes_iterations(d)) d.set("iterations", iterations, *budget);
    if (checked_) try_settings(d);
    for (const Placed& s : d.settings) c.settings.emplace_back(s.name, s.value);
    return c;
  }

 private:
  const Node& node_of(const std::string& name, const Node& asked) const {
    std::vector<std::string_view> names;
    for (const Node& node : study_.at("contenders").items()) {
      names.push_back(node.at("name").text());
      if (names.back() == name) return node;
    }
    asked.fail("names no contender \"" + name + "\"", did_you_mean(name, names));
  }

  void take_preset(Entry& d, const Node& preset) const {
    if (!tool::is_document(preset.text())) {
      d.contender.preset = static_cast<Preset>(preset.choice(kPresetNames));
      return;
    }
    d.contender.preset_file = (folder_ / preset.text()).string();
    const auto file = tool::read_preset_file(d.contender.preset_file);
    if (file.algorithm != d.contender.algorithm)
      preset.fail("is of " + file.algorithm + ", not of " + d.contender.algorithm,
                  "name its algorithm");
    d.contender.preset = file.preset;
    for (const auto& [name, value] : file.settings) d.set(name, value, preset);
  }

  /// The contender has iterations, and says nothing of them itself.
  bool takes_iterations(const Entry& d) const {
    const auto said = [](const Placed& s) { return s.name == "iterations"; };
    return find_algorithm(d.contender.algorithm).has("iterations") &&
           std::ranges::none_of(d.settings, said);
  }

  static void try_settings(const Entry& d) {
    Params params = tool::known_params(d.contender.algorithm, d.contender.preset, *d.algorithm);
    for (const Placed& s : d.settings) tool::try_setting(params, s.name, s.value, *s.place);
    try {
      validate(params);
    } catch (const Error& fault) {
      d.place->fail("\"" + d.contender.name + "\": " + fault.problem(), fault.remedy());
    }
  }

  const Node& study_;
  const Words& words_;
  std::filesystem::path folder_;
  bool checked_;
};

bool has_parameter(const std::string& algorithm, const std::string& name) {
  const auto all = algorithms();
  const auto found = std::ranges::find(all, algorithm, &Algorithm::name);
  return found != all.end() && found->has(name);
}

/// The points of those factors that an algorithm has; none where it has none of them.
std::vector<Settings> points_of(const Node& sweep, const std::vector<Factor>& factors,
                                const std::string& algorithm) {
  static constexpr std::string_view kDesigns[] = {"grid", "random", "latin"};
  const Node* const chosen = sweep.find("design");
  const auto design =
      chosen == nullptr ? Design::grid : static_cast<Design>(chosen->choice(kDesigns));
  std::vector<Factor> own;
  for (const Factor& f : factors)
    if (has_parameter(algorithm, f.name)) own.push_back(f);
  if (own.empty()) return {};
  if (design != Design::grid)
    return design_points(
        design, own, static_cast<int>(sweep.at("points").integer(1, kMostPoints)),
        static_cast<std::uint64_t>(sweep.integer_or("seed", 1, 0, tool::kMaxExactInteger)));
  for (const Factor& f : own)
    if (f.values.empty() && f.levels == 0)
      sweep.at("factors").find(f.name)->fail("is a range, and a grid takes levels of it",
                                             "add `levels`, or say `design: latin`");
  if (grid_size(own) > kMostPoints)
    sweep.at("factors").fail("makes " + std::to_string(grid_size(own)) + " points",
                             "keep it to " + std::to_string(kMostPoints));
  return design_points(design, own, 0, 0);
}

/// All contenders' algorithms are known before anything is made of them.
void check_algorithms(const Node& study, bool bitmaps) {
  for (const Node& node : study.at("contenders").items())
    if (const Node* const algorithm = node.find("algorithm"); algorithm != nullptr && bitmaps)
      (void)tool::known_params(algorithm->text(), Preset::usual, *algorithm);
  if (const Node* const sweep = study.find("sweep"); sweep != nullptr && !bitmaps)
    sweep->fail("is for bitmaps", "write a contender for each value");
}

/// Adds a contender for each point of the sweep; without a sweep the contender itself.
void add_swept(const Reader& reader, const Node& study, const Entry& d,
               std::vector<Contender>& to) {
  const Node* const sweep = study.find("sweep");
  std::vector<Settings> points;
  if (sweep != nullptr && d.swept) {
    std::vector<std::string> all;
    for (const Node& node : study.at("contenders").items())
      if (const Node* const algorithm = node.find("algorithm")) all.push_back(algorithm->text());
    sweep->allow({"design", "points", "seed", "factors"});
    points = points_of(*sweep, factors_of(sweep->at("factors"), all), d.contender.algorithm);
  }
  if (points.empty()) to.push_back(reader.finished(d, {}, nullptr));
  for (const Settings& point : points) {
    Entry one = d;
    one.contender.name += '-' + std::to_string(&point - points.data() + 1);
    for (const auto& [name, value] : point) one.contender.label += ", " + name + ' ' + value;
    to.push_back(reader.finished(std::move(one), point, &sweep->at("factors")));
  }
}

}  // namespace

std::vector<Contender> contenders_of(const Node& study, const Node* compare, const Words& words,
                                     const std::filesystem::path& folder, bool checked) {
  const Node& all = study.at("contenders");
  check_algorithms(study, checked);
  const Reader reader(study, words, folder, checked);
  std::vector<Contender> contenders;
  if (compare == nullptr) compare = study.find("compare");
  if (compare != nullptr) {
    const auto asked = compare->texts();
    if (asked.empty()) compare->fail("is empty", "name contenders, or leave it out");
    for (const Node& name : compare->items()) {
      if (std::ranges::count(asked, name.text()) > 1)
        compare->fail("has \"" + name.text() + "\" twice", "name it once");
      add_swept(reader, study, reader.described(name.text(), name), contenders);
    }
  } else {
    for (const Node& node : all.items())
      add_swept(reader, study, reader.described(node.at("name").text(), node), contenders);
  }
  std::set<std::string> names;
  for (const Contender& c : contenders) {
    if (c.name.find_first_of("/\\\n") != std::string::npos || c.name.starts_with('.'))
      all.fail("has \"" + c.name + "\", no name of a file", "use letters, digits and -");
    if (!names.insert(c.name).second)
      all.fail("has \"" + c.name + "\" twice", "give one another name");
  }
  if (contenders.empty()) all.fail("is empty", "add {name, algorithm}");
  return contenders;
}

Contender described_contender(const Node& map, const std::string& name, const Settings& point,
                              const Node* place, const std::filesystem::path& folder) {
  const Words none;
  const Reader reader(map, none, folder, true);
  (void)tool::known_params(map.at("algorithm").text(), Preset::usual, map.at("algorithm"));
  Entry d{.contender = {.name = name, .label = name}};
  reader.take(d, map, true);
  return reader.finished(std::move(d), point, place);
}

namespace {

/// A parameter of the first of these algorithms that has it.
const Parameter& parameter_of(const Node& factor, const std::vector<std::string>& algorithms) {
  std::vector<std::string_view> known;
  for (const std::string& algorithm : algorithms) {
    for (const Parameter& p : find_algorithm(algorithm).parameters) {
      if (p.name == tool::parameter_meant_by(factor.key())) return p;
      known.push_back(p.name);
    }
  }
  factor.fail("is no parameter of them",
              known.empty() ? "leave it out" : did_you_mean(factor.key(), known));
}

Factor factor_of(const Node& node, const Parameter& parameter) {
  Factor factor{.name = node.key()};
  if (!node.is_map()) {
    factor.values = node.texts();
    if (factor.values.empty()) node.fail("has no values", "list some");
    return factor;
  }
  node.allow({"from", "to", "scale", "levels"});
  if (parameter.type == "choice") node.fail("has no range", "list its values");
  static constexpr std::string_view kScales[] = {"linear", "log"};
  const Node* const scale = node.find("scale");
  factor.logarithmic = scale != nullptr && scale->choice(kScales) == 1;
  factor.whole = parameter.type == "integer";
  const double least = factor.logarithmic ? std::max(1e-300, parameter.least) : parameter.least;
  factor.from = node.at("from").number(least, parameter.most);
  factor.to = node.at("to").number(factor.from, parameter.most);
  factor.levels = static_cast<int>(node.integer_or("levels", 0, 2, kMostPoints));
  return factor;
}

}  // namespace

std::vector<Factor> factors_of(const Node& map, const std::vector<std::string>& algorithms) {
  std::vector<Factor> factors;
  for (const auto& [name, node] : map.entries())
    factors.push_back(factor_of(node, parameter_of(node, algorithms)));
  if (factors.empty()) map.fail("is empty", "add PARAMETER: [values]");
  return factors;
}

Budget budget_of(const Node* budget) {
  Budget found;
  if (budget == nullptr) return found;
  budget->allow({"iterations", "steps", "seconds"});
  found.steps = budget->number_or("steps", found.steps, 1, 1e15);
  found.seconds = budget->number_or("seconds", found.seconds, 1e-6, 1e9);
  return found;
}

std::string iterations_of(const Node* budget) {
  if (budget == nullptr) return {};
  if (const Node* const iterations = budget->find("iterations"))
    return std::to_string(iterations->integer(1, kEndlessIterations));
  const bool ends = budget->find("steps") != nullptr || budget->find("seconds") != nullptr;
  return ends ? std::to_string(kEndlessIterations) : "";
}

Seeds seeds_of(const Node* seeds, Seeds usual) {
  if (seeds == nullptr) return usual;
  const auto range = tool::parse_range(seeds->text());
  if (!range || range->first < 1 || range->second > tool::kMaxExactInteger ||
      range->second - range->first >= kMostSeeds)
    seeds->fail("is \"" + seeds->text() + "\"",
                "say N, or A..B, from 1; at most " + std::to_string(kMostSeeds) + " of them");
  return {static_cast<std::uint64_t>(range->first),
          static_cast<int>(range->second - range->first) + 1};
}

}  // namespace lasius::study
