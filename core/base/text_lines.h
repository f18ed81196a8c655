// Lines of a text: they end in LF, CR LF or CR.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lasius {

/// The line, from 1, on which a byte of the text stands, or its end.
inline std::int64_t line_at(std::string_view text, std::size_t byte) {
  std::int64_t line = 1;
  for (std::size_t i = 0; i < std::min(byte, text.size()); ++i) {
    line += text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'));
  }
  return line;
}

inline constexpr std::string_view kBlanksOfLines = " \t\r\v\f";

/// A text without the `blanks` around it.
inline std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const auto from = text.find_first_not_of(blanks);
  if (from == text.npos) return {};
  return text.substr(from, text.find_last_not_of(blanks) + 1 - from);
}

/// The words of a line, parted by any of `blanks`.
inline std::vector<std::string_view> words_of(std::string_view line, std::string_view blanks) {
  std::vector<std::string_view> words;
  for (auto at = line.find_first_not_of(blanks); at != line.npos;) {
    const auto end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

/// The fields of a line of CSV (RFC 4180, but for blanks about them, in quotes too, which are cut
/// off, and line breaks in quotes). Nothing where a quote is not closed.
inline std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields;
  std::string field;
  bool quoted = false;
  const std::string text = std::string(line) + ",";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' && quoted && text[i + 1] == '"') {
      field += text[++i];
    } else if (text[i] == '"' && (quoted || trimmed(field, kBlanksOfLines).empty())) {
      quoted = !quoted;
    } else if (text[i] == ',' && !quoted) {
      fields.emplace_back(trimmed(std::exchange(field, {}), kBlanksOfLines));
    } else {
      field += text[i];
    }
  }
  if (quoted) fields.clear();
  return fields;
}

/// Puts an LF in place of each CR that ends a line alone, for readers that know only LF.
inline void end_lines_in_lf(std::string& text) {
  for (auto at = text.find('\r'); at != text.npos; at = text.find('\r', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] != '\n') text[at] = '\n';
  }
}

}  // namespace lasius
