#include "tools/manual/markdown.h"

#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>

#include "tools/manual/wrapped.h"

namespace lasius::tool {
namespace {

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// [text](target) becomes text; code stays as it is.
std::string without_links(std::string_view text) {
  std::string plain;
  bool code = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '`') code = !code;
    const auto middle = text[i] == '[' && !code ? text.find("](", i) : text.npos;
    const auto end = middle == text.npos ? text.npos : text.find(')', middle);
    if (end == text.npos) {
      plain += text[i];
    } else {
      plain += text.substr(i + 1, middle - i - 1);
      i = end;
    }
  }
  return plain;
}

/// The cells of a line of a table.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  line = without_blanks(line).substr(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|')
      cells.back() += line[++i];
    else if (line[i] == '|')
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  cells.pop_back();  // behind the last bar
  for (auto& cell : cells) cell = without_links(without_blanks(cell));
  return cells;
}

/// "* " or "1. ": how long it is; 0 where the line begins no item.
std::size_t bullet_size(std::string_view line) {
  if (line.starts_with("* ")) return 2;
  std::size_t digits = 0;
  while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0)
    ++digits;
  return digits > 0 && line.substr(digits).starts_with(". ") ? digits + 2 : 0;
}

class Reader {
 public:
  bool in_fence() const { return fence_; }

  void read(std::string_view line) {
    if (line.starts_with("```")) {
      fence_ = !fence_;
      open_ = false;
      return;
    }
    if (fence_) return add_code(line);
    if (line.starts_with("|")) return read_row(line);
    header_.clear();
    if (without_blanks(line).empty()) {
      open_ = false;
    } else if (line.starts_with("    ") && !(open_ && blocks_.back().kind == Block::Kind::item)) {
      add_code(line.substr(4));
    } else if (const auto bullet = bullet_size(line)) {
      const auto label = without_blanks(line.substr(0, bullet));
      blocks_.push_back(
          {Block::Kind::item, without_links(line.substr(bullet)), std::string(label)});
      open_ = true;
    } else {
      add_text(without_blanks(line));
    }
  }
  Blocks take() { return std::move(blocks_); }

 private:
  void add_text(std::string_view line) {
    if (!open_) blocks_.push_back({Block::Kind::paragraph, ""});
    std::string& text = blocks_.back().text;
    if (!text.empty()) text += ' ';
    text += line;
    text = without_links(text);
    open_ = true;
  }

  void add_code(std::string_view line) {
    if (!open_) blocks_.push_back({Block::Kind::code, ""});
    blocks_.back().text.append(line).append("\n");
    open_ = true;
  }

  void read_row(std::string_view line) {
    open_ = false;
    auto cells = cells_of(line);
    if (header_.empty()) {
      header_ = std::move(cells);
      return;
    }
    if (cells[0].starts_with("--")) return;
    std::string text;
    for (std::size_t i = 1; i < cells.size(); ++i) {
      if (cells[i].empty()) continue;
      if (!text.empty()) text += "; ";
      if (cells.size() > 2 && !header_[i].empty()) text += header_[i] + ": ";
      text += cells[i];
    }
    blocks_.push_back({Block::Kind::item, text, cells[0]});
  }

  Blocks blocks_;
  bool open_ = false;   ///< the next line goes on with the last block
  bool fence_ = false;  ///< between lines of ```
  std::vector<std::string> header_;
};

bool is_heading(std::string_view line) { return line.starts_with("#"); }

}  // namespace

Blocks markdown_section(std::string_view page, std::string_view heading) {
  while (!page.empty()) {
    const auto line = next_line(page);
    if (!is_heading(line) || without_blanks(line.substr(line.find_first_not_of('#'))) != heading)
      continue;
    Reader reader;
    while (!page.empty()) {
      const auto next = next_line(page);
      if (is_heading(next) && !reader.in_fence()) break;
      reader.read(next);
    }
    return reader.take();
  }
  throw std::logic_error("no heading " + std::string(heading));
}

}  // namespace lasius::tool
