// lasius complete: what a shell may complete, from the same tables as --help.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/streams.h"
#include "tools/manual/topics.h"
#include "tools/options/commands.h"
#include "tools/options/manual.h"
#include "tools/study/description/study_file.h"

namespace lasius::tool {
namespace {

/// Completes the last word of a command line, told the words before it.
class Completer {
 public:
  explicit Completer(const Manual& manual) : manual_(manual) {
    // The program itself is like a command whose argument is the command's name.
    program_.options = manual.options;
    program_.options.push_back({.names = {"COMMAND"}, .value = {}, .help = {}});
  }

  /// Takes a word before the last one.
  void take(const std::string& word) {
    if (command_ == nullptr) return;
    if (pending_ != nullptr) {
      take_value(*std::exchange(pending_, nullptr), word);
    } else if (word == "--") {
      options_ended_ = true;
    } else if (word.size() > 1 && word.front() == '-' && !options_ended_) {
      take_option(word);
    } else if (command_ != &program_) {
      arguments_.push_back(word);
    } else {
      const auto known = std::ranges::find(manual_.commands, word, &CommandText::name);
      command_ = known == manual_.commands.end() ? nullptr : &*known;
      options_ended_ = false;
    }
  }

  /// What the scripts in shells/ read of the last word, empty or not: "WORD<tab>MEANING",
  /// ":files<tab>ENDING ENDING...",
  /// ":folders". More is to be typed behind a final "="; files stand behind it, too.
  std::string complete(std::string_view word) {
    word_ = word;
    if (command_ == nullptr) return {};
    if (pending_ != nullptr)
      add_values(pending_->values, "");
    else if (word.starts_with('-') && !options_ended_)
      add_options();
    else
      add_argument();
    return std::move(text_);
  }

 private:
  const OptionText* find_option(std::string_view name) const {
    const auto found = std::ranges::find_if(command_->options, [&](const OptionText& option) {
      return std::ranges::find(option.names, name) != option.names.end();
    });
    return found == command_->options.end() ? nullptr : &*found;
  }

  void take_value(const OptionText& option, std::string_view value) {
    if (option.values.names == Values::Names::algorithms) algorithm_ = value;
  }

  void take_option(std::string_view word) {
    const auto equals = word.find('=');
    const OptionText* option = find_option(word.substr(0, equals));
    if (option == nullptr) return;
    used_.insert(option);
    if (option->value.empty()) return;
    if (equals == word.npos)
      pending_ = option;
    else
      take_value(*option, word.substr(equals + 1));
  }

  /// Whether the command's algorithms are those of a kind, as far as what is typed tells.
  bool concerns(const ProblemKind& kind) const {
    const auto runs = [&](const ProblemKind* one) {
      return std::ranges::find(one->commands, command_->name) != one->commands.end();
    };
    const auto many = std::ranges::count_if(kinds(), runs);
    if (many == 0) return true;
    return runs(&kind) && (many == 1 || arguments_.empty() || kind.takes(arguments_.front()));
  }

  void add(const std::string& word, std::string_view meaning) {
    if (word.starts_with(word_) && told_.insert(word).second)
      text_.append(word).append("\t").append(meaning.substr(0, meaning.find('\n'))).append("\n");
  }

  /// Options; or behind "--option=" its values.
  void add_options() {
    const auto equals = word_.find('=');
    if (equals != word_.npos) {
      const OptionText* option = find_option(word_.substr(0, equals));
      if (option != nullptr) add_values(option->values, std::string(word_.substr(0, equals + 1)));
      return;
    }
    for (const OptionText& option : command_->options)
      if (!option.is_argument() && (option.repeatable || !used_.contains(&option)))
        add(word_ == "-" || option.names.back().starts_with(word_) ? option.names.back()
                                                                   : option.names.front(),
            option.help);
  }

  void add_argument() {
    if (command_ == &program_)
      for (const auto& command : manual_.commands) add(command.name, command.summary);
    std::size_t left = arguments_.size();
    for (const OptionText& option : command_->options)
      if (option.is_argument() && left-- == 0) return add_values(option.values, "");
    if (word_.empty()) add_options();
  }

  /// What is typed of a list, up to the part that is being typed.
  std::string before_part(std::size_t from) const {
    const auto comma = word_.rfind(',');
    const bool parts = comma != word_.npos && comma >= from;
    return std::string(word_.substr(0, parts ? comma + 1 : from));
  }

  void add_values(const Values& values, std::string before) {
    if (values.list) before = before_part(before.size());
    for (const auto& choice : values.choices) add(before + choice, "");
    add_names(values.names, before);
    if (values.files) {
      text_ += ":files\t";
      for (const auto& ending : values.endings) text_ += ending + " ";
      text_ += "\n";
    }
    if (values.folders) text_ += ":folders\t\n";
  }

  void add_names(Values::Names names, const std::string& before) {
    switch (names) {
      case Values::Names::none:
        return;
      case Values::Names::studies:
        for (const auto name : study::study_names()) add(before + std::string(name), "");
        return;
      case Values::Names::topics:
        for (const Topic& topic : topics()) add(before + std::string(topic.name), topic.summary);
        for (const auto& command : manual_.commands) add(before + command.name, command.summary);
        return;
      case Values::Names::algorithms:
        for_algorithms([&](const Algorithm& a) { add(before + std::string(a.name), a.summary); });
        return;
      case Values::Names::parameters:  // of the algorithm that was named, else of any
        for_algorithms([&](const Algorithm& a) {
          if (!algorithm_.empty() && a.name != algorithm_) return;
          for (const Parameter& parameter : a.parameters) add_setting(before, parameter);
        });
    }
  }

  template <class Use>
  void for_algorithms(const Use& use) {
    for (const ProblemKind* kind : kinds())
      if (concerns(*kind)) std::ranges::for_each(kind->algorithms, use);
  }

  /// NAME=VALUE.
  void add_setting(const std::string& before, const Parameter& parameter) {
    const std::string name = before + std::string(parameter.name) + "=";
    if (!word_.starts_with(name)) return add(name, parameter.summary);
    const std::string part = before_part(name.size());
    for (const auto choice : parameter.choices) add(part + std::string(choice), "");
  }

  const Manual& manual_;
  CommandText program_;
  const CommandText* command_ = &program_;  ///< null: there is none of that name
  const OptionText* pending_ = nullptr;     ///< option whose value comes next
  std::set<const OptionText*> used_;
  std::vector<std::string> arguments_;
  std::string algorithm_;
  bool options_ended_ = false;  ///< by "--"
  std::string_view word_;
  std::set<std::string> told_;
  std::string text_;
};

}  // namespace

int run_command(const CompleteCommand& command) {
  Completer completer(command.manual);
  if (command.words.empty()) {
    print(completer.complete(""));
    return kFound;
  }
  for (std::size_t i = 0; i + 1 < command.words.size(); ++i) completer.take(command.words[i]);
  print(completer.complete(command.words.back()));
  return kFound;
}

}  // namespace lasius::tool
