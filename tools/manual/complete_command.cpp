// lasius complete: what a shell may complete, from the same tables as --help.
#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/manual/topics.h"
#include "tools/options/commands.h"
#include "tools/options/manual.h"
#include "tools/study/description/study_file.h"

namespace lasius::tool {
namespace {

struct Candidate {
  std::string word;     ///< in place of the last one; more is to be typed behind a final "="
  std::string meaning;  ///< a line; may be empty
};

struct Completion {
  std::vector<Candidate> candidates;  ///< all of them begin with the last word
  bool files = false;                 ///< files with `endings`, too; behind "=", where it has one
  bool folders = false;
  std::vector<std::string> endings;
};

/// What stands before the word that is typed.
struct Typed {
  const CommandText* command = nullptr;
  const OptionText* pending = nullptr;  ///< option whose value comes next
  std::set<const OptionText*> used;
  std::vector<std::string> arguments;
  std::string algorithm;
  bool options_ended = false;  ///< by "--"
};

const OptionText* find_option(const std::vector<OptionText>& options, std::string_view name) {
  const auto found = std::ranges::find_if(options, [&](const OptionText& option) {
    return std::ranges::find(option.names, name) != option.names.end();
  });
  return found == options.end() ? nullptr : &*found;
}

void take_value(Typed& typed, const OptionText& option, std::string_view value) {
  if (option.values.names == Values::Names::algorithms) typed.algorithm = value;
}

void take_option(Typed& typed, std::string_view word) {
  const auto equals = word.find('=');
  const OptionText* option = find_option(typed.command->options, word.substr(0, equals));
  if (option == nullptr) return;
  typed.used.insert(option);
  if (option->value.empty()) return;
  if (equals == word.npos)
    typed.pending = option;
  else
    take_value(typed, *option, word.substr(equals + 1));
}

void take_word(Typed& typed, const std::string& word) {
  if (typed.pending != nullptr) {
    take_value(typed, *typed.pending, word);
    typed.pending = nullptr;
  } else if (word == "--") {
    typed.options_ended = true;
  } else if (word.size() > 1 && word.front() == '-' && !typed.options_ended) {
    take_option(typed, word);
  } else {
    typed.arguments.push_back(word);
  }
}

/// Whether a command's algorithms are those of a kind, as far as what is typed tells.
bool concerns(const Typed& typed, const ProblemKind& kind) {
  const auto runs = [&](const ProblemKind* one) {
    return std::ranges::find(one->commands, typed.command->name) != one->commands.end();
  };
  const auto many = std::ranges::count_if(kinds(), runs);
  if (many == 0) return true;
  return runs(&kind) &&
         (many == 1 || typed.arguments.empty() || kind.takes(typed.arguments.front()));
}

class Completer {
 public:
  Completer(const Manual& manual, Typed typed, std::string_view word)
      : manual_(manual), typed_(std::move(typed)), word_(word) {}

  Completion complete() {
    if (typed_.pending != nullptr) {
      add_values(typed_.pending->values, "");
    } else if (word_.starts_with('-') && !typed_.options_ended) {
      add_options();
    } else {
      add_argument();
    }
    return std::move(completion_);
  }

 private:
  void add(const std::string& word, std::string_view meaning) {
    if (!word.starts_with(word_)) return;
    Candidate candidate{word, std::string(meaning.substr(0, meaning.find('\n')))};
    if (std::ranges::find(completion_.candidates, word, &Candidate::word) ==
        completion_.candidates.end())
      completion_.candidates.push_back(std::move(candidate));
  }

  /// Options; or behind "--option=" its values.
  void add_options() {
    const auto equals = word_.find('=');
    if (equals != word_.npos) {
      const OptionText* option = find_option(typed_.command->options, word_.substr(0, equals));
      if (option != nullptr) add_values(option->values, std::string(word_.substr(0, equals + 1)));
      return;
    }
    for (const OptionText& option : typed_.command->options)
      if (!option.is_argument() && (option.repeatable || !typed_.used.contains(&option)))
        add(word_ == "-" || option.names.back().starts_with(word_) ? option.names.back()
                                                                   : option.names.front(),
            option.help);
  }

  void add_argument() {
    std::size_t left = typed_.arguments.size();
    for (const OptionText& option : typed_.command->options)
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
    completion_.files = values.files;
    completion_.folders = values.folders;
    completion_.endings = values.endings;
    for (const auto& choice : values.choices) add(before + choice, "");
    switch (values.names) {
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
      case Values::Names::parameters:
        return add_settings(before);
    }
  }

  template <class Use>
  void for_algorithms(const Use& use) {
    for (const ProblemKind* kind : kinds())
      if (concerns(typed_, *kind)) std::ranges::for_each(kind->algorithms, use);
  }

  /// NAME=VALUE, of the algorithm that was named, else of any.
  void add_settings(const std::string& before) {
    for_algorithms([&](const Algorithm& a) {
      if (!typed_.algorithm.empty() && a.name != typed_.algorithm) return;
      for (const Parameter& parameter : a.parameters) add_setting(before, parameter);
    });
  }

  void add_setting(const std::string& before, const Parameter& parameter) {
    const std::string name = before + std::string(parameter.name) + "=";
    if (!word_.starts_with(name)) return add(name, parameter.summary);
    const std::string part = before_part(name.size());
    for (const auto choice : parameter.choices) add(part + std::string(choice), "");
  }

  const Manual& manual_;
  Typed typed_;
  std::string_view word_;
  Completion completion_;
};

/// For the words behind the program's name, of which the last one, empty or not, is being typed.
Completion complete(const Manual& manual, std::span<const std::string> words) {
  static const std::string kNothing;
  const std::string& word = words.empty() ? kNothing : words.back();
  // The program itself is like a command whose argument is the command's name.
  CommandText program;
  program.options = manual.options;
  program.options.push_back({.names = {"COMMAND"}, .value = {}, .help = {}});
  for (const auto& command : manual.commands)
    program.options.back().values.choices.push_back(command.name);
  Typed typed;
  typed.command = &program;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (typed.command != &program || words[i].starts_with('-')) {
      take_word(typed, words[i]);
      continue;
    }
    const auto known = std::ranges::find(manual.commands, words[i], &CommandText::name);
    if (known == manual.commands.end()) return {};
    typed = {};
    typed.command = &*known;
  }
  Completion completion = Completer(manual, std::move(typed), word).complete();
  for (Candidate& candidate : completion.candidates)  // of commands, what they do
    if (const auto command = std::ranges::find(manual.commands, candidate.word, &CommandText::name);
        command != manual.commands.end() && candidate.meaning.empty())
      candidate.meaning = command->summary;
  return completion;
}

}  // namespace

// What the scripts in shells/ read: "WORD<tab>MEANING", ":files<tab>ENDING ENDING...", ":folders".
int run_command(const CompleteCommand& command) {
  const Completion completion = complete(command.manual, command.words);
  std::string text;
  for (const auto& [word, meaning] : completion.candidates) text += word + "\t" + meaning + "\n";
  if (completion.files) {
    text += ":files\t";
    for (const auto& ending : completion.endings) text += ending + " ";
    text += "\n";
  }
  if (completion.folders) text += ":folders\t\n";
  print(text);
  return kFound;
}

}  // namespace lasius::tool
