#include <algorithm>
#include <filesystem>
#include <ostream>

#include "core/base/did_you_mean.h"
#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/manual/documents.h"
#include "tools/manual/man_page.h"
#include "tools/manual/pages.h"
#include "tools/manual/plain_text.h"
#include "tools/manual/topics.h"
#include "tools/options/commands.h"

namespace lasius::tool {
namespace {

constexpr const char* kSynopsis = "lasius COMMAND [arguments and options]";
constexpr const char* kMore =
    "Of a command or topic: `lasius COMMAND --help`, `lasius help TOPIC`.";

std::string program_text(const Manual& manual) {
  Blocks blocks = command_list(manual);
  append(blocks, option_blocks(manual.options));
  append(blocks, topic_list());
  blocks.push_back(paragraph(kMore));
  return std::string("Usage: ") + kSynopsis + "\n\n" + manual.summary + ".\n\n" +
         plain_text(blocks);
}

Blocks command_blocks(const CommandText& command) {
  Blocks blocks{paragraph(command.summary + ".")};
  if (!command.detail.empty()) blocks.push_back(paragraph(command.detail));
  append(blocks, option_blocks(command.options));
  append(blocks, note_blocks(command));
  return blocks;
}

std::string command_text(const CommandText& command) {
  Blocks blocks = command_blocks(command);
  return "Usage: " + usage(command) + "\n\n" + plain_text(blocks);
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
         plain_text(topic.blocks());
}

std::string text_of(const HelpCommand& help) {
  const Manual& manual = help.manual;
  if (help.topic.empty()) return program_text(manual);
  if (const Topic* topic = find_topic(help.topic); topic != nullptr && !help.of_command)
    return topic_text(*topic);
  const CommandText* command = find_command(manual, help.topic);
  if (command == nullptr) refuse_topic(manual, help.topic);
  return command_text(*command);
}

std::string see_also(const Manual& manual, std::string_view but) {
  std::string text;
  for (const CommandText& command : manual.commands)
    if (command.name != but)
      text += (text.empty() ? "`lasius-" : ", `lasius-") + command.name + "`(1)";
  return but.empty() ? text : "`lasius`(1), " + text;
}

std::string program_page(const Manual& manual) {
  Blocks blocks{heading("Description"), paragraph(manual.summary + ".")};
  append(blocks, command_list(manual));
  append(blocks, option_blocks(manual.options));
  append(blocks, topic_list());
  blocks.push_back(paragraph(kMore));
  for (const Topic& topic : topics())
    if (topic.in_man_page) {
      blocks.push_back(heading(std::string(topic.name)));
      append(blocks, topic.blocks());
    }
  append(blocks, {heading("See also"), paragraph(see_also(manual, ""))});
  return roff_title("lasius", manual.summary, release_date(), {kSynopsis}) + roff(blocks);
}

std::string command_page(const Manual& manual, const CommandText& command) {
  Blocks blocks{heading("Description")};
  append(blocks, command_blocks(command));
  append(blocks, {heading("See also"), paragraph(see_also(manual, command.name))});
  return roff_title("lasius-" + command.name, command.summary, release_date(), {usage(command)}) +
         roff(blocks);
}

void write_pages(const Manual& manual, const std::string& folder) {
  const auto write = [&](const std::string& name, const std::string& page) {
    write_file((std::filesystem::path(folder) / (name + ".1")).string(),
               [&](std::ostream& file) { file << page; });
  };
  write("lasius", program_page(manual));
  for (const CommandText& command : manual.commands)
    write("lasius-" + command.name, command_page(manual, command));
}

}  // namespace

int run_command(const HelpCommand& command) {
  if (!command.pages.empty())
    write_pages(command.manual, command.pages);
  else
    print(text_of(command));
  return kFound;
}

}  // namespace lasius::tool
