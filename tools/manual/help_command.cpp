#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/did_you_mean.h"
#include "lasius/version.h"
#include "tools/command_line/option_table.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/manual/documents.h"
#include "tools/manual/topics.h"
#include "tools/options/commands.h"

namespace lasius::tool {
namespace {

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
