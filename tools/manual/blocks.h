// A text as blocks, from which a page for the terminal or for `man` is made.
#pragma once

#include <string>
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

inline void append(Blocks& to, const Blocks& blocks) {
  to.insert(to.end(), blocks.begin(), blocks.end());
}

}  // namespace lasius::tool
