// Which rules read a parameter, in words and in code: what the tables of lasius/rules.h say.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "lasius/params.h"

namespace lasius {

/// Words that the compiler puts together.
struct Words {
  std::array<char, 160> text{};
  std::size_t size = 0;

  constexpr void add(std::string_view more) {
    for (const char c : more) text.at(size++) = c;
  }
  constexpr std::string_view view() const noexcept { return {text.data(), size}; }
};

/// Adds the rules that read a parameter: "update=rank|max-min", or where most do "an update but
/// rank|max-min"; nothing where none does.
template <class Value, std::size_t kCount>
constexpr void add_readers(Words& words, std::string_view kind, std::string_view parameter,
                           const std::array<Rule<Value>, kCount>& rules) {
  const auto readers =
      std::ranges::count_if(rules, [&](const auto& rule) { return rule.reads(parameter); });
  if (readers == 0) return;
  const bool most = 2 * readers > static_cast<std::ptrdiff_t>(kCount);
  if (words.size > 0) words.add(", ");
  if (most) words.add(kind.starts_with('u') ? "an " : "a ");
  words.add(kind);
  std::string_view between = most ? " but " : "=";
  for (const auto& rule : rules) {
    if (rule.reads(parameter) == most) continue;
    words.add(between);
    words.add(rule.name);
    between = "|";
  }
}

/// The rules that read a parameter which only some do; empty for any other.
constexpr Words readers_of(std::string_view parameter) {
  Words words;
  add_readers(words, "heuristic", parameter, kHeuristics);
  add_readers(words, "visibility", parameter, kVisibilities);
  add_readers(words, "update", parameter, kUpdates);
  return words;
}

/// Does one of the rules in hand read it?
constexpr bool is_read_by_rules(const Params& p, std::string_view parameter) noexcept {
  return rule_of(p.heuristic, kHeuristics).reads(parameter) ||
         rule_of(p.visibility, kVisibilities).reads(parameter) ||
         rule_of(p.update, kUpdates).reads(parameter);
}

}  // namespace lasius
