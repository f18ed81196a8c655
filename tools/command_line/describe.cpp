#include "tools/command_line/describe.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <string_view>

#include "tools/command_line/notes.h"

namespace lasius::tool {
namespace {

std::vector<std::string> names_of(const CLI::Option& option) {
  if (option.get_positional()) return {option.get_single_name()};
  std::vector<std::string> names;
  for (const auto& name : option.get_snames()) names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// Of the program itself where `command` is empty.
OptionText describe(const CLI::Option& option, std::string_view command) {
  OptionText text{.names = names_of(option),
                  .value = option.get_type_name(),
                  .help = option.get_description(),
                  .required = option.get_required(),
                  .repeatable = option.get_items_expected_max() > 1};
  text.values = values_of(command, text.names.back(), text.value);
  return text;
}

/// Without those that are only there to be refused.
std::vector<OptionText> options_of(const CLI::App& app, std::string_view command) {
  std::vector<OptionText> options;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() != kRefused) options.push_back(describe(*option, command));
  std::stable_partition(options.begin(), options.end(),
                        [](const OptionText& option) { return option.is_argument(); });
  return options;
}

}  // namespace

Manual describe(const CLI::App& app, const std::vector<Subcommand>& commands) {
  Manual manual{.summary = app.get_description(), .options = options_of(app, ""), .commands = {}};
  for (const auto& command : commands) {
    const std::string name = command.app->get_name();
    manual.commands.push_back(
        {notes_of(name), name, command.app->get_description(), options_of(*command.app, name)});
  }
  return manual;
}

}  // namespace lasius::tool
