#include "tools/manual/documents.h"

#include <algorithm>
#include <string_view>

#include "tools/manual/topics.h"

namespace lasius::tool {
namespace {

/// "-o, --output FILE"
std::string label_of(const OptionText& option) {
  std::string label;
  for (const auto& name : option.names) label += (label.empty() ? "" : ", ") + name;
  return option.value.empty() ? label : label + " " + option.value;
}

/// An option's help: a sentence, and a list where lines part label and meaning by two blanks.
void append_help(Blocks& blocks, const OptionText& option) {
  std::string_view rest = option.help;
  blocks.push_back({Block::Kind::item, std::string(next_line(rest)), label_of(option)});
  while (!rest.empty()) {
    const auto line = next_line(rest);
    const auto gap = line.find("  ");
    if (gap == line.npos) {
      blocks.back().text.append(" ").append(line);
      continue;
    }
    const auto meaning = std::min(line.find_first_not_of(' ', gap), line.size());
    blocks.push_back({Block::Kind::item, std::string(line.substr(meaning)),
                      std::string(line.substr(0, gap)), 1});
  }
}

}  // namespace

std::string usage(const CommandText& command) {
  std::string text = "lasius " + command.name;
  bool more = false;
  for (const OptionText& option : command.options) {
    const bool argument = option.is_argument();
    const std::string word =
        argument ? option.names.front() : option.names.front() + " " + option.value;
    if (option.required)
      text += " " + word;
    else if (argument)
      text += " [" + word + "]";
    else
      more = true;
  }
  return more ? text + " [options]" : text;
}

Blocks option_blocks(const std::vector<OptionText>& options) {
  Blocks blocks;
  for (const bool arguments : {true, false}) {
    const auto first = blocks.size();
    for (const OptionText& option : options)
      if (option.is_argument() == arguments) append_help(blocks, option);
    if (blocks.size() > first)
      blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(first),
                    heading(arguments ? "Arguments" : "Options"));
  }
  return blocks;
}

Blocks note_blocks(const Notes& notes) {
  Blocks blocks;
  if (!notes.examples.empty()) blocks.push_back(heading("Examples"));
  for (const Example& example : notes.examples) {
    blocks.push_back(paragraph(example.what + ":"));
    blocks.push_back({Block::Kind::code, example.line + "\n"});
  }
  if (!notes.json.empty()) {
    blocks.push_back(heading("JSON"));
    const auto fields = std::ranges::find(field_names(), notes.json, &FieldNames::heading);
    blocks.push_back(paragraph(std::string(fields->names) + "."));
    blocks.push_back(paragraph("What they mean: `lasius help json`."));
  }
  blocks.push_back(heading("Exit codes"));
  for (const ExitText& exit : notes.exits)
    blocks.push_back({Block::Kind::item, exit.meaning, std::to_string(exit.code)});
  return blocks;
}

Blocks command_list(const Manual& manual) {
  Blocks blocks{heading("Commands")};
  for (const CommandText& command : manual.commands)
    blocks.push_back({Block::Kind::item, command.summary, command.name});
  return blocks;
}

Blocks topic_list() {
  Blocks blocks{heading("Topics")};
  for (const Topic& topic : topics())
    blocks.push_back({Block::Kind::item, std::string(topic.summary), std::string(topic.name)});
  return blocks;
}

}  // namespace lasius::tool
