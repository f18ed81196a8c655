#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/base/did_you_mean.h"
#include "lasius/version.h"
#include "tools/command_line/option_table.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/manual/topics.h"
#include "tools/options/commands.h"

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

/// "lasius plan MAP [options]": arguments, and the options that must be there.
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

/// Arguments and options as items, below headings.
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

/// The rest of what is told of a command: examples, JSON, exit codes.
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
    if (fields == field_names().end())
      throw std::logic_error("docs/ have no heading " + std::string(notes.json));
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

constexpr const char* kSynopsis = "lasius COMMAND [arguments and options]";
constexpr const char* kMore =
    "Of a command or topic: `lasius COMMAND --help`, `lasius help TOPIC`.";

Blocks program_blocks(const Manual& manual) {
  Blocks blocks{paragraph(manual.summary + ".")};
  append(blocks, command_list(manual));
  append(blocks, option_blocks(manual.options));
  append(blocks, topic_list());
  blocks.push_back(paragraph(kMore));
  return blocks;
}

Blocks command_blocks(const CommandText& command) {
  Blocks blocks{paragraph(command.summary + ".")};
  if (!command.detail.empty()) blocks.push_back(paragraph(command.detail));
  append(blocks, option_blocks(command.options));
  append(blocks, note_blocks(command));
  return blocks;
}

std::string with_usage(const std::string& usage, const Blocks& blocks) {
  return "Usage: " + usage + "\n\n" + plain_text(blocks);
}

const CommandText* find_command(const Manual& manual, std::string_view name) {
  const auto found = std::ranges::find(manual.commands, name, &CommandText::name);
  return found == manual.commands.end() ? nullptr : &*found;
}

const Topic* find_topic(std::string_view name) {
  const auto found = std::ranges::find(topics(), name, &Topic::name);
  return found == topics().end() ? nullptr : &*found;
}

/// Neither a topic nor a command. @throws UsageError with the nearest name.
void refuse_topic(const Manual& manual, const std::string& name) {
  std::vector<std::string_view> known;
  for (const Topic& topic : topics()) known.push_back(topic.name);
  for (const CommandText& command : manual.commands) known.push_back(command.name);
  throw UsageError("there is no topic \"" + name + "\"; " +
                   (nearest_name(name, known) ? did_you_mean(name, known) + " " : std::string()) +
                   "`lasius help` lists them");
}

std::string topic_text(const Topic& topic) {
  return std::string(topic.name) + ": " + std::string(topic.summary) + ".\n\n" +
         plain_text(topic.blocks);
}

std::string text_of(const HelpCommand& help) {
  const Manual& manual = help.manual;
  if (help.topic.empty()) return with_usage(kSynopsis, program_blocks(manual));
  if (const Topic* topic = find_topic(help.topic); topic != nullptr && !help.of_command)
    return topic_text(*topic);
  const CommandText* command = find_command(manual, help.topic);
  if (command == nullptr) refuse_topic(manual, help.topic);
  return with_usage(usage(*command), command_blocks(*command));
}

using Json = nlohmann::ordered_json;

Json blocks_json(const Blocks& blocks) {
  constexpr const char* kKinds[] = {"heading", "paragraph", "item", "code"};
  Json json = Json::array();
  for (const Block& block : blocks)
    json.push_back({{"kind", kKinds[static_cast<int>(block.kind)]},
                    {"text", block.text},
                    {"label", block.label},
                    {"depth", block.depth}});
  return json;
}

/// All that there is to tell, of which the manual pages are made.
Json manual_json(const Manual& manual) {
  Json json = {{"version", LASIUS_VERSION}, {"summary", manual.summary},
               {"usage", kSynopsis},        {"blocks", blocks_json(program_blocks(manual))},
               {"commands", Json::array()}, {"topics", Json::array()}};
  for (const CommandText& command : manual.commands)
    json["commands"].push_back({{"name", command.name},
                                {"summary", command.summary},
                                {"usage", usage(command)},
                                {"blocks", blocks_json(command_blocks(command))}});
  for (const Topic& topic : topics())
    json["topics"].push_back({{"name", topic.name},
                              {"summary", topic.summary},
                              {"in_man_page", topic.in_man_page},
                              {"blocks", blocks_json(topic.blocks)}});
  return json;
}

}  // namespace

int run_command(const HelpCommand& command) {
  print(command.json ? manual_json(command.manual).dump() + "\n" : text_of(command));
  return kFound;
}

Subcommand add_help(CLI::App& app) {
  auto to = std::make_shared<HelpCommand>();
  OptionTable table(app, "help", "Tell of a topic or a command");
  table.shell(
      table.text("TOPIC", to->topic, "A topic, or a command; without it what there is", "TOPIC"),
      {.names = Values::Names::topics});
  table.flag("--json", to->json, "All that there is to tell, of which the manual pages are made");
  return table.command({.examples = {{"lasius help json", "the fields of results"},
                                     {"lasius help plan", "what `lasius plan --help` says"}}},
                       [to](const Call& call) {
                         to->manual = call.manual();
                         return run_command(*to);
                       });
}

}  // namespace lasius::tool
