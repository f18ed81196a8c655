// The known name that a misspelt one most likely means.
#pragma once

#include <algorithm>
#include <cctype>
#include <numeric>
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

/// Asks for the known name nearest to `name`, the first of equals: one that begins with it before
/// others, and capitals count as small letters unless nothing else differs. Precondition: `known`
/// is not empty. `list` tells where all are, and is added where the nearest is far.
inline std::string did_you_mean(std::string_view name, std::span<const std::string_view> known,
                                const std::string& list = {}) {
  const auto small = [](std::string_view text) {
    std::string letters(text);
    for (char& c : letters) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
  };
  const auto farness = [&, name_small = small(name)](std::string_view candidate) {
    const std::string candidate_small = small(candidate);
    return std::tuple(!candidate_small.starts_with(name_small),
                      edit_distance(name_small, candidate_small), edit_distance(name, candidate));
  };
  const auto nearest =
      std::ranges::min_element(known, [&](auto a, auto b) { return farness(a) < farness(b); });
  const auto [other_begin, changes, exact_changes] = farness(*nearest);
  const bool far = other_begin && 2 * static_cast<std::size_t>(changes) > name.size();
  return "did you mean \"" + std::string(*nearest) + "\"?" + (far ? list : "");
}

/// The same among things with a name and a summary, such as parameters: one whose summary gives
/// `name` as the symbol of its source ("ants an iteration, m") before the nearest.
template <class Described>
std::string did_you_mean(std::string_view name, std::span<const Described> known,
                         const std::string& list = {}) {
  const std::string symbol = ", " + std::string(name);
  std::vector<std::string_view> names;
  for (const Described& one : known) {
    const std::string_view summary = one.summary;
    if (summary.ends_with(symbol) || summary.find(symbol + ";") != summary.npos ||
        summary.starts_with(std::string(name) + " of ")) {
      return did_you_mean(name, std::span(&one.name, 1));
    }
    names.push_back(one.name);
  }
  return did_you_mean(name, names, list);
}

}  // namespace lasius
