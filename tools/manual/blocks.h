// A text as blocks, from which a page for the terminal or for `man` is made, and lines.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace lasius::tool {

struct Block {
  enum class Kind {
    heading,
    paragraph,
    item,  ///< a label and what it means
    code,  ///< lines as they are
  };
  Kind kind = Kind::paragraph;
  std::string text;  ///< without line breaks, but code; `x` is code in it
  std::string label = {};
  int depth = 0;  ///< of an item, or of what is said below one
};

inline Block heading(const std::string& text) { return {Block::Kind::heading, text}; }
inline Block paragraph(const std::string& text) { return {Block::Kind::paragraph, text}; }

using Blocks = std::vector<Block>;

/// For a terminal of 80 columns.
std::string plain_text(const Blocks& blocks);

inline void append(Blocks& to, const Blocks& blocks) {
  to.insert(to.end(), blocks.begin(), blocks.end());
}

/// Takes the first line off a text, and returns it.
inline std::string_view next_line(std::string_view& text) {
  const auto line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  return line;
}

}  // namespace lasius::tool
