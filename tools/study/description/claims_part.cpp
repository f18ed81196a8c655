// Claims of a study's file.
#include <algorithm>

#include "core/base/did_you_mean.h"
#include "tools/console/values.h"
#include "tools/study/description/study_parts.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

/// Experiments by name; all of them where none is named.
std::vector<std::string> names_in(const Node& claim, const char* key,
                                  const std::vector<Experiment>& experiments) {
  std::vector<std::string> names;
  const Node* const in = claim.find(key);
  if (in != nullptr) names = in->texts();
  std::vector<std::string_view> known;
  for (const Experiment& e : experiments) {
    known.push_back(e.name);
    if (in == nullptr) names.push_back(e.name);
  }
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      in->fail("names no experiment \"" + name + "\"", did_you_mean(name, known));
  return names;
}

/// Refuses the name of a contender that none of the experiments has.
void check_contender(const Node& place, const std::string& name, const std::vector<std::string>& in,
                     const std::vector<Experiment>& experiments) {
  std::vector<std::string_view> known;
  for (const Experiment& e : experiments)
    if (std::ranges::find(in, e.name) != in.end())
      for (const Contender& c : e.contenders) known.push_back(c.name);
  if (known.empty() || std::ranges::find(known, name) != known.end()) return;
  place.fail("names no contender \"" + name + "\"", did_you_mean(name, known));
}

double real(const Node& claim, const char* name, double usual) {
  return claim.number_or(name, usual, -tool::kNoLimit, tool::kNoLimit);
}

/// What a claim and the baseline of one have: a value of a contender in a range.
void read_value(const Node& node, const std::vector<Experiment>& experiments, Claim& claim) {
  claim.a = node.at("a").text();
  check_contender(node.at("a"), claim.a, claim.in, experiments);
  if (claim.test == Claim::Test::arithmetic) {
    claim.value.name = node.text_or("value", "length");  // or what only arithmetic knows
    return;
  }
  claim.value = value_of_claim(node);
  claim.value.budget = real(node, "budget", kUnknown);
  claim.from = real(node, "from", claim.from);
  claim.to = real(node, "to", claim.to);
}

Claim baseline_of(const Node& node, const std::vector<std::string>& in,
                  const std::vector<Experiment>& experiments) {
  node.allow({"a", "value", "at", "budget", "target", "best_of", "own_limit", "from", "to"});
  Claim claim{.text = {}, .place = {}, .test = Claim::Test::most, .in = in};
  read_value(node, experiments, claim);
  return claim;
}

/// Against one control, or none.
Claim claim_of(const Node& node, const std::string& control, std::vector<std::string> in,
               const std::vector<Experiment>& experiments) {
  static constexpr std::string_view kTests[] = {"less", "similar", "most", "arithmetic", "none"};
  Claim claim{.text = node.joined_or_empty("text"), .place = node.text_or("place", "")};
  claim.test = static_cast<Claim::Test>(node.at("test").choice(kTests));
  claim.note = node.joined_or_empty("note");
  if (claim.test == Claim::Test::none) return claim;
  claim.in = std::move(in);
  claim.b = control;
  if (!control.empty()) check_contender(node.at("b"), control, claim.in, experiments);
  if (claim.test == Claim::Test::less || claim.test == Claim::Test::similar) (void)node.at("b");
  read_value(node, experiments, claim);
  claim.factor = node.number_or("factor", claim.factor, 0, tool::kNoLimit);
  claim.within = node.number_or("within", claim.within, 0, 1);
  claim.share = node.number_or("share", claim.share, 0, 1);
  if (const Node* const baseline = node.find("baseline"))
    claim.baseline.push_back(baseline_of(*baseline, claim.in, experiments));
  return claim;
}

}  // namespace

Value value_of_claim(const Node& claim) {
  const auto named = [&](const char* key, const char* usual, const auto& names) {
    const Node* const node = claim.find(key);
    return node == nullptr ? std::string(usual) : std::string(names[node->choice(names)]);
  };
  return {.name = named("value", "length", value_names()),
          .at = named("at", "end", budget_names()),
          .budget = kUnknown,
          .target = real(claim, "target", 0),
          .best_of = static_cast<int>(claim.integer_or("best_of", 1, 1, 100000)),
          .own_limit = claim.flag_or("own_limit", false)};
}

std::vector<Claim> claims_of(const Node& node, const std::vector<Experiment>& experiments) {
  node.allow({"text",   "place",  "test",  "note",   "in",     "in_each", "a",
              "b",      "value",  "at",    "budget", "target", "best_of", "own_limit",
              "factor", "within", "share", "from",   "to",     "baseline"});
  const Node* const b = node.find("b");
  const auto controls = b != nullptr ? b->texts() : std::vector<std::string>{""};
  std::vector<std::vector<std::string>> places;
  if (node.find("in_each") != nullptr)
    for (std::string& name : names_in(node, "in_each", experiments)) places.push_back({name});
  else
    places.push_back(names_in(node, "in", experiments));
  std::vector<Claim> claims;
  for (const auto& in : places)
    for (const std::string& control : controls)
      claims.push_back(claim_of(node, control, in, experiments));
  return claims;
}

}  // namespace lasius::study
