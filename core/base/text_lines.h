// Lines of a text: they end in LF, CR LF or CR.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lasius {

/// The line, from 1, on which a byte of the text stands, or its end.
inline std::int64_t line_at(std::string_view text, std::size_t byte) {
  std::int64_t line = 1;
  for (std::size_t i = 0; i < std::min(byte, text.size()); ++i) {
    line += text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'));
  }
  return line;
}

/// Puts an LF in place of each CR that ends a line alone, for readers that know only LF.
inline void end_lines_in_lf(std::string& text) {
  for (auto at = text.find('\r'); at != text.npos; at = text.find('\r', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] != '\n') text[at] = '\n';
  }
}

}  // namespace lasius
