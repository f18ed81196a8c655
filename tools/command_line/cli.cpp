#include "tools/command_line/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/did_you_mean.h"
#include "core/base/kernel_choice.h"
#include "core/base/number_text.h"
#include "lasius/version.h"
#include "tools/command_line/subcommands.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/options/commands.h"

namespace lasius::tool {
namespace {

/// What there is in place of options that planners elsewhere have, and where all are.
std::string instead_of(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::array<std::array<std::string_view, 3>, 2> kElsewhere{
      {{"--footprint", "--radius", "robots are discs: --radius R; "},
       {"--waypoints", "--via", "give each of them with --via X,Y; "}}};
  for (const auto& [theirs, ours, text] : kElsewhere)
    if (word == theirs && std::ranges::find(known, ours) != known.end())
      return std::string(text) + "see --help";
  return "see --help";
}

/// The first thing on the command line that nothing takes, with the nearest known word.
void refuse_extras(const CLI::App& app, const std::vector<std::string>& words) {
  const auto extras = app.remaining();
  const auto extra = std::ranges::find_if(extras, [](const auto& word) { return word != "--"; });
  if (extra == extras.end()) return;
  const std::string word = extra->substr(0, extra->find('='));
  if (word.size() < 2 || word[0] != '-') {
    const auto at = std::find(words.rbegin(), words.rend(), *extra);
    const auto word_before = [&](int n) {
      return words.rend() - at > n ? at[n].substr(0, at[n].find('=')) : std::string();
    };
    const std::string before = word_before(1), last = before[0] == '-' ? before : word_before(2);
    const bool point = last == "--start" || last == "--goal" || last == "--via";
    const bool may_have = before == "--prepare" || before == "--islands";
    throw UsageError("\"" + word + "\" is one argument too many" +
                     (may_have                    ? ", and no value of " + before
                      : point && parse_real(word) ? "; points are X,Y, without a blank"
                                                  : "") +
                     "; see --help");
  }
  const auto dashes = std::ranges::find(words, "--");
  if (std::find(words.begin(), dashes, *extra) == dashes)
    throw UsageError("\"" + word + "\" is one argument too many: no option follows --; see --help");
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group() == kRefused) continue;
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    for (const auto& name : option->get_snames()) names.push_back("-" + name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw UsageError("unknown option \"" + word + "\"; " +
                   did_you_mean(word, known, instead_of(word, known)));
}

/// A first word that is no subcommand, named before CLI11 gets to see the rest.
void refuse_unknown_command(std::string_view word, const std::vector<Subcommand>& commands) {
  std::vector<std::string> names;
  for (const auto& command : commands) names.push_back(command.app->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  throw UsageError("unknown command \"" + std::string(word) + "\"; " + did_you_mean(word, known));
}

/// "--option=", for which CLI11 would take the next word.
void refuse_empty_values(const CLI::App& app, const std::vector<std::string_view>& words) {
  for (const auto word : words) {
    if (word == "--") return;
    if (!word.starts_with("--") || !word.ends_with('=')) continue;
    const std::string name(word.substr(0, word.size() - 1));
    const CLI::Option* option = app.get_option_no_throw(name);
    if (option == nullptr || option->get_type_name().empty()) continue;  // told about elsewhere
    throw UsageError(name + " needs a value, " + option->get_type_name() + "; see --help");
  }
}

void refuse_extras(const CLI::App& app, const std::vector<Subcommand>& commands,
                   const std::vector<std::string>& words) {
  refuse_extras(app, words);
  for (const auto& command : commands)
    if (command.app->parsed()) refuse_extras(*command.app, words);
}

/// What CLI11 says, in plain words where its own are not.
std::string plain_words(const std::string& text) {
  constexpr std::string_view kFlag = " was given a disallowed flag override";
  if (text.ends_with(kFlag))
    return "--" + text.substr(0, text.size() - kFlag.size()) + " takes no value";
  const auto colon = text.find(": ");
  if (colon == std::string::npos) return text;
  const std::string option = text.substr(0, colon), problem = text.substr(colon + 2);
  constexpr std::string_view kNeeded = "1 required ", kMissing = " missing";
  if (problem.starts_with(kNeeded) && problem.ends_with(kMissing))
    return option + " needs a value, " +
           problem.substr(kNeeded.size(), problem.size() - kNeeded.size() - kMissing.size());
  if (problem.starts_with("At Most 1 required")) return option + " is given more than once";
  return text;
}

/// "plan, drive, ...; see lasius help".
std::string known_commands(const std::vector<Subcommand>& commands) {
  std::string text = "one of";
  for (const auto& command : commands) text += " " + command.app->get_name();
  return text + "; see `lasius help`";
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (option.get_positional()) return {option.get_single_name()};
  std::vector<std::string> names;
  for (const auto& name : option.get_snames()) names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

using ShellValues = std::map<const CLI::Option*, Values>;

OptionText describe(const CLI::Option& option, const ShellValues& values) {
  OptionText text{.names = names_of(option),
                  .value = option.get_type_name(),
                  .help = option.get_description(),
                  .required = option.get_required(),
                  .repeatable = option.get_items_expected_max() > 1};
  if (const auto known = values.find(&option); known != values.end()) text.values = known->second;
  return text;
}

/// Without those that are only there to be refused.
std::vector<OptionText> options_of(const CLI::App& app, const ShellValues& values) {
  std::vector<OptionText> options;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() != kRefused) options.push_back(describe(*option, values));
  std::stable_partition(options.begin(), options.end(),
                        [](const OptionText& option) { return option.is_argument(); });
  return options;
}

/// The commands and their options as data, read off CLI11's tables.
Manual describe(const CLI::App& app, const std::vector<Subcommand>& commands) {
  Manual manual{.summary = app.get_description(), .options = options_of(app, {}), .commands = {}};
  for (const auto& command : commands)
    manual.commands.push_back({command.notes, command.app->get_name(),
                               command.app->get_description(),
                               options_of(*command.app, command.values)});
  return manual;
}

/// A word as a shell reads it back.
std::string shell_word(std::string_view word) {
  const bool plain = !word.empty() && std::ranges::all_of(word, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_./,:=+@%").find(c) != std::string_view::npos;
  });
  if (plain) return std::string(word);
  std::string quoted = "'";
  for (const char c : word)
    if (c == '\'')
      quoted += "'\\''";
    else
      quoted += c;
  return quoted + "'";
}

/// The command line, for a shell to read.
std::string line_of(std::span<const std::string_view> words) {
  std::string text = "lasius";
  for (const auto word : words.subspan(1)) text += " " + shell_word(word);
  return text;
}

/// The words, with the values of options that may do without one. What is like one, and no file, is
/// meant for --prepare, and refused with the name that is.
std::vector<std::string> with_values(std::span<const std::string_view> words) {
  constexpr std::array<std::string_view, 2> kPreparations{"graph", "labels"};
  const auto is_value = [&](std::string_view word) {
    if (std::ranges::find(kPreparations, word) != kPreparations.end()) return true;
    return !word.starts_with('-') && nearest_name(word, kPreparations).has_value() &&
           !std::filesystem::exists(word);
  };
  // What begins as a number and is no file is meant for --islands, and refused with its name.
  const auto is_count = [&](std::string_view word) {
    const auto digit = word.substr(word.starts_with('-') ? 1 : 0).substr(0, 1);
    if (digit.find_first_of("0123456789") == digit.npos) return false;
    return word.find_first_not_of("0123456789") == word.npos || !std::filesystem::exists(word);
  };
  std::vector<std::string> whole;
  const auto end = static_cast<std::size_t>(std::ranges::find(words, "--") - words.begin());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view next = i + 1 < words.size() ? words[i + 1] : "";
    std::string& word = whole.emplace_back(words[i]);
    if (i > end) continue;
    if (word == "--prepare" && !is_value(next)) word += "=graph";
    if (word != "--islands") continue;
    const bool counted = is_count(next);
    word.append("=").append(counted ? next : "8");
    if (counted) ++i;
  }
  return whole;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App app{"Ant-colony and exact motion planning on maps", "lasius"};
  app.set_version_flag("--version", LASIUS_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  std::vector<Subcommand> commands;
  for (const AddSubcommand add : subcommands()) commands.push_back(add(app));
  const auto manual = [&] { return describe(app, commands); };
  const auto help = [&] {
    const auto chosen = app.get_subcommands();
    if (chosen.empty()) return run_command(HelpCommand{manual(), ""});
    return run_command(
        HelpCommand{.manual = manual(), .topic = chosen.front()->get_name(), .of_command = true});
  };
  const std::vector<std::string_view> words(argv, argv + argc);
  const std::vector<std::string> whole = with_values(words);
  if (argc < 2) throw UsageError("no command; " + known_commands(commands));
  if (words[1] == "complete")
    return run_command(CompleteCommand{manual(), {words.begin() + 2, words.end()}});
  if (argv[1][0] != '-') refuse_unknown_command(argv[1], commands);
  for (const auto& command : commands)
    if (command.app->get_name() == argv[1]) refuse_empty_values(*command.app, words);
  app.allow_extras();
  try {
    app.parse(std::vector<std::string>(whole.rbegin(), whole.rend() - 1));
  } catch (const CLI::CallForHelp&) {
    return help();
  } catch (const CLI::CallForVersion&) {
    print(std::string("lasius ") + LASIUS_VERSION + "\n");
    return kFound;
  } catch (const CLI::ParseError& fault) {
    refuse_extras(app, commands, whole);
    throw UsageError(plain_words(fault.what()) + "; see --help");
  } catch (const UsageError&) {  // of a value, which CLI11 reads before it looks for --help
    for (const CLI::App* chosen : app.get_subcommands())
      if (chosen->get_help_ptr()->count() > 0) return help();
    refuse_extras(app, commands, whole);
    throw;
  }
  refuse_extras(app, commands, whole);
  const auto asked = std::ranges::find_if(
      commands, [](const Subcommand& command) { return command.app->parsed(); });
  if (asked == commands.end()) throw UsageError("no command; " + known_commands(commands));
  if (asked->app->get_name() != "help") (void)chosen_isa();  // refuses what is none
  return asked->run({line_of(words), manual});
}

}  // namespace lasius::tool
