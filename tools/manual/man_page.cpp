#include "tools/manual/man_page.h"

#include <algorithm>
#include <cctype>

#include "lasius/version.h"
#include "tools/console/values.h"
#include "tools/manual/wrapped.h"

namespace lasius::tool {
namespace {

constexpr std::size_t kLineBytes = 78;

/// Characters that troff would take for its own, or draw otherwise than they are typed.
constexpr Escape kEscapes[] = {{'\\', "\\(rs"}, {'-', "\\-"},   {'\'', "\\(aq"},
                               {'^', "\\(ha"},  {'~', "\\(ti"}, {'`', "\\(ga"}};

std::string escaped(std::string_view text) { return with_escapes(text, kEscapes); }

/// Text in lines, `x` in bold. No line begins like a request.
std::string lines_of(std::string_view text) {
  std::string marked;
  bool code = false;
  while (true) {
    const auto tick = text.find('`');
    marked += escaped(text.substr(0, tick));
    if (tick == text.npos) break;
    code = !code;
    marked += code ? "\\fB" : "\\fR";
    text.remove_prefix(tick + 1);
  }
  std::string out;
  for (const auto& line : wrapped(marked, kLineBytes))
    out.append(line.starts_with('.') ? "\\&" : "").append(line).append("\n");
  return out;
}

std::string bold_line(std::string text) {
  std::erase(text, '`');
  return "\\fB" + escaped(text) + "\\fR\n";
}

/// A label: what is typed in bold, what stands for something in italics.
std::string label_line(const std::string& label) {
  const auto blank = label.rfind(' ');
  if (!label.starts_with('-') || blank == label.npos || label[blank + 1] == '-')
    return bold_line(label);
  return "\\fB" + escaped(label.substr(0, blank)) + "\\fR \\fI" + escaped(label.substr(blank + 1)) +
         "\\fR\n";
}

std::string capitals(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
}

std::string code_lines(std::string_view text) {
  std::string out = ".PP\n.RS 4\n.nf\n";
  while (!text.empty()) {
    const std::string line = escaped(next_line(text));
    out.append(line.starts_with('.') ? "\\&" : "").append(line).append("\n");
  }
  return out + ".fi\n.RE\n";
}

}  // namespace

std::string roff(const Blocks& blocks) {
  std::string page;
  int depth = 0;
  bool after_heading = false;
  for (const Block& block : blocks) {
    const int wanted = block.kind == Block::Kind::item ? block.depth : 0;
    if (wanted > depth) page += ".RS\n";
    if (wanted < depth) page += ".RE\n";
    depth = wanted;
    switch (block.kind) {
      case Block::Kind::heading:
        page += block.depth > 0 ? ".SS " + escaped(block.text) + "\n"
                                : ".SH " + escaped(capitals(block.text)) + "\n";
        break;
      case Block::Kind::paragraph:
        page += (after_heading ? "" : ".PP\n") + lines_of(block.text);
        break;
      case Block::Kind::item:
        page += ".TP\n" + label_line(block.label) + lines_of(block.text);
        break;
      case Block::Kind::code:
        page += code_lines(block.text);
        break;
    }
    after_heading = block.kind == Block::Kind::heading;
  }
  return depth > 0 ? page + ".RE\n" : page;
}

std::string roff_title(std::string_view name, std::string_view summary, std::string_view date,
                       const std::vector<std::string>& usage) {
  std::string page = ".TH " + escaped(capitals(name)) + " 1 " + std::string(date) + " \"lasius " +
                     LASIUS_VERSION + "\" \"lasius manual\"\n.SH NAME\n" +
                     lines_of(std::string(name) + " - " + std::string(summary)) +
                     ".SH SYNOPSIS\n.nf\n";
  for (const auto& line : usage) page += bold_line(line);
  return page + ".fi\n";
}

}  // namespace lasius::tool
