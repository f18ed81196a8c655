#include "tools/draw/text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/io/json_values.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

/// The end of the first letters of a UTF-8 text, `most` of them.
std::size_t end_of_letters(std::string_view text, std::size_t most) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if (begins(text[at]) && most-- == 0) return at;
  return at;
}

std::string cut(std::string_view text, std::size_t most) {
  if (end_of_letters(text, most) == text.size()) return std::string(text);
  return std::string(text.substr(0, end_of_letters(text, most - 1))) + "\u2026";
}

}  // namespace

std::string drawn(const std::string& text) {
  constexpr std::size_t kMostOfWord = 100, kMost = 1000;
  const auto whole = json::read(json::line(text), "a text").get<std::string>();
  std::string words;
  for (std::size_t from = 0; from <= whole.size();) {
    const std::size_t to = std::min(whole.find(' ', from), whole.size());
    words +=
        (from > 0 ? " " : "") + cut(std::string_view(whole).substr(from, to - from), kMostOfWord);
    from = to + 1;
  }
  return cut(words, kMost);
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  const std::string text = printed("%.*f", decimals, value);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string p_text(double p) { return p < 0.001 ? "< 0.001" : fixed(p, 3); }

std::string seconds_text(double seconds) {
  if (!(seconds > 0)) return fixed(seconds, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(seconds)));
  return fixed(seconds, std::max(0, std::min(decimals, 5)));
}

std::string against(double length, double optimum, const std::string& name,
                    const std::string& shown) {
  const double gap = 100 * (length / optimum - 1), size = std::abs(gap);
  if (!std::isfinite(gap)) return {};
  const std::string how =
      size < 1e-6 ? "equal to"
                  : fixed(size, size < 0.01 ? 5 : 2) + (gap < 0 ? "% below" : "% above");
  return ", " + how + " the " + name + " " + shown;
}

std::string no_path_text(Status status) {
  switch (status) {
    case Status::limit:
      return "no path within the time limit";
    case Status::interrupted:
      return "no path before the interruption";
    case Status::unreachable:
      return "no path: the goal is unreachable, proven";
    case Status::invalid:
      return "no path: start or goal is outside or blocked";
    case Status::solved:
    case Status::no_path:
      break;
  }
  return "no path found in all iterations";
}

}  // namespace lasius::tool
