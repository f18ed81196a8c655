#include <algorithm>
#include <string_view>
#include <utility>

#include "tools/manual/blocks.h"

namespace lasius::tool {
namespace {

/// `text` broken at blanks into lines of at most `width` bytes; a longer word is a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const auto word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width)
      lines.emplace_back();
    else if (!lines.back().empty())
      lines.back() += ' ';
    lines.back() += word;
  }
  return lines;
}

constexpr std::size_t kColumns = 80, kIndent = 2, kWidestLabel = 24;

/// Appends `text` from `column` on, where the line already is; later lines begin there too.
void append_wrapped(std::string& page, std::string_view text, std::size_t column) {
  std::size_t indent = 0;
  for (const auto& line : wrapped(text, kColumns - column)) {
    page.append(indent, ' ').append(line).append("\n");
    indent = column;
  }
}

std::string without_ticks(std::string text) {
  std::erase(text, '`');
  return text;
}

/// Where the meanings of a list's items begin: behind the longest label that is not too long.
std::size_t column_of(const Blocks& blocks, std::size_t first) {
  std::size_t widest = 0;
  const int depth = blocks[first].depth;
  for (std::size_t i = first; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    if (block.kind != Block::Kind::item || block.depth < depth) break;
    if (block.depth > depth) continue;
    const auto width = without_ticks(block.label).size();
    if (width <= kWidestLabel) widest = std::max(widest, width);
  }
  return kIndent + widest + 2;
}

class Printer {
 public:
  std::string print(const Blocks& blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Block& block = blocks[i];
      const bool item = block.kind == Block::Kind::item;
      if (!item) columns_[0] = columns_[1] = 0;
      if (item && block.depth == 0) columns_[1] = 0;
      if (item && columns_[block.depth] == 0)
        columns_[block.depth] =
            column_of(blocks, i) + (block.depth > 0 ? columns_[0] - kIndent : 0);
      // A list stands together, all else apart.
      if (i > 0 && !(item && (last_ == Block::Kind::item || last_ == Block::Kind::heading)) &&
          last_ != Block::Kind::heading)
        page_ += '\n';
      add(block);
      last_ = block.kind;
    }
    return std::move(page_);
  }

 private:
  void add(const Block& block) {
    switch (block.kind) {
      case Block::Kind::heading:
        page_ += block.text + ":\n";
        return;
      case Block::Kind::paragraph:
        page_.append(kIndent, ' ');
        return append_wrapped(page_, block.text, kIndent);
      case Block::Kind::code:
        return add_code(block.text);
      case Block::Kind::item:
        return add_item(block);
    }
  }

  void add_code(std::string_view text) {
    while (!text.empty()) page_.append(2 * kIndent, ' ').append(next_line(text)).append("\n");
  }

  void add_item(const Block& block) {
    const auto from = block.depth == 0 ? kIndent : columns_[0];
    const auto to = columns_[block.depth];
    const std::string label = without_ticks(block.label);
    page_.append(from, ' ').append(label);
    if (from + label.size() + 2 > to)
      page_.append("\n").append(to, ' ');
    else
      page_.append(to - from - label.size(), ' ');
    append_wrapped(page_, block.text, to);
  }

  std::string page_;
  std::size_t columns_[2] = {0, 0};  ///< by depth, where meanings begin
  Block::Kind last_ = Block::Kind::paragraph;
};

}  // namespace

std::string plain_text(const Blocks& blocks) { return Printer().print(blocks); }

}  // namespace lasius::tool
