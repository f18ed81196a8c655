// The known name that a misspelt one most likely means.
#pragma once

#include <algorithm>
#include <cctype>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace lasius {

/// Edit distance: insertions, deletions, replacements and swaps of neighbours, one each.
inline int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

/// The known name that `name` most likely means, the first of equals: one that begins with it
/// before others, then one of which at most a third of its letters are others, then one that has it
/// in it or is in it. Capitals count as small letters unless nothing else differs. Nothing where
/// each is far.
inline std::optional<std::string_view> nearest_name(std::string_view name,
                                                    std::span<const std::string_view> known) {
  const auto bare = [](std::string_view text) {  // an option without its dashes
    return text.substr(std::min(text.find_first_not_of('-'), text.size()));
  };
  const auto small = [](std::string_view text) {
    std::string letters(text);
    for (char& c : letters) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
  };
  constexpr std::size_t kWord = 4;  // letters that name something
  std::string word = small(bare(name));
  if (word.empty()) return std::nullopt;
  if (word == "dims" || word == "dimensions") word = "size";
  const auto farness = [&](std::string_view candidate) {
    const std::string other = small(bare(candidate));
    const auto holds = [&](const std::string& text, const std::string& part) {
      return part.size() >= kWord && text.find(part) != std::string::npos;
    };
    const int changes = edit_distance(word, other);
    const bool near = 3 * static_cast<std::size_t>(changes) <= word.size() + 1;
    const bool part = holds(other, word) || holds(word, other);
    const int kind = other.starts_with(word) ? 0 : near ? 1 : part ? 2 : 3;
    return std::tuple(kind, changes, edit_distance(name, candidate));
  };
  const auto nearest =
      std::ranges::min_element(known, [&](auto a, auto b) { return farness(a) < farness(b); });
  if (nearest == known.end()) return std::nullopt;
  if (std::get<0>(farness(*nearest)) == 3) return std::nullopt;
  return *nearest;
}

/// Asks for the known name nearest to `name`; where none is near, tells where all are, as `list`
/// has it, or which they are. Precondition: `known` is not empty.
inline std::string did_you_mean(std::string_view name, std::span<const std::string_view> known,
                                const std::string& list = {}) {
  if (const auto nearest = nearest_name(name, known))
    return "did you mean \"" + std::string(*nearest) + "\"?";
  if (!list.empty()) return list;
  constexpr std::size_t kFew = 16;
  if (known.size() > kFew) return "no known name is like it";
  std::string all = known.size() > 1 ? "it is one of" : "the only one is";
  for (const auto& one : known) all.append(&one == known.data() ? " " : ", ").append(one);
  return all;
}

/// The remedy for an unknown name among things with a name and a summary, such as parameters: one
/// whose summary gives `name` as its source's symbol ("ants an iteration, m"), else the nearest.
template <class Described>
std::string did_you_mean(std::string_view name, std::span<const Described> known,
                         const std::string& list = {}) {
  const std::string symbol = ", " + std::string(name);
  std::vector<std::string_view> names;
  for (const Described& one : known) {
    const std::string_view summary = one.summary;
    if (summary.ends_with(symbol) || summary.find(symbol + ";") != summary.npos ||
        summary.starts_with(std::string(name) + " of ")) {
      return "did you mean \"" + std::string(one.name) + "\"?";
    }
    names.push_back(one.name);
  }
  return did_you_mean(name, names, list);
}

}  // namespace lasius
