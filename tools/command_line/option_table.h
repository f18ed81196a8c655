// A command's options, read into its own fields while the command line is parsed.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/command_line/subcommands.h"
#include "tools/console/values.h"
#include "tools/options/manual.h"

namespace lasius::tool {

class OptionTable {
 public:
  using Texts = std::vector<std::string>;
  using Read = std::function<void(const std::string& text)>;

  OptionTable(CLI::App& program, const char* name, const char* summary)
      : app_(*program.add_subcommand(name, summary)) {}

  // An option or, named without dashes, an argument, whose value `type` calls. What cannot be read
  // is a UsageError.
  CLI::Option* add(const std::string& names, const char* help, const char* type, const Read& read);
  CLI::Option* text(const std::string& names, std::string& to, const char* help, const char* type) {
    return add(names, help, type, [&to](const auto& text) { to = text; });
  }
  template <class Number>
  CLI::Option* real(const std::string& names, Number& to, double least, double most,
                    const char* help, const char* type) {
    return add(names, help, type, [names, &to, least, most](const auto& text) {
      to = real_value(names, text, least, most);
    });
  }
  template <class Integer>
  CLI::Option* integer(const std::string& names, Integer& to, std::int64_t least, std::int64_t most,
                       const char* help, const char* type) {
    return add(names, help, type, [names, &to, least, most](const auto& text) {
      to = static_cast<Integer>(integer_value(names, text, least, most));
    });
  }
  /// `to` becomes the index of a word.
  template <class Choice>
  CLI::Option* choice(const std::string& names, Choice& to, std::span<const std::string_view> words,
                      const char* help, const char* type) {
    return add(names, help, type, [names, &to, words](const auto& text) {
      to = static_cast<Choice>(choice_value(names, text, words));
    });
  }
  /// A file with one of these endings, as shells complete it.
  CLI::Option* file(const std::string& names, std::string& to, const char* help, Texts endings) {
    return shell(text(names, to, help, "FILE"), {.files = true, .endings = std::move(endings)});
  }
  /// One that may be given often.
  CLI::Option* repeatable(const std::string& names, const char* help, const char* type,
                          const Read& read);
  CLI::Option* repeatable(const std::string& names, Texts& to, const char* help, const char* type) {
    return repeatable(names, help, type, [&to](const auto& text) { to.push_back(text); });
  }
  /// One without a value.
  void flag(const char* names, bool& to, const char* help) {
    app_.add_flag(names, to, help)->disable_flag_override();
  }

  /// What a shell may write for it, where its type does not say.
  CLI::Option* shell(CLI::Option* option, Values values);
  CLI::Option* operator[](const std::string& name) { return app_.get_option(name); }
  bool given(const std::string& name) const { return app_.get_option(name)->count() > 0; }
  /// @throws UsageError, a name and why, where one of these is given.
  void refuse(std::initializer_list<const char*> names, const std::string& why) const;
  /// Those whose names begin so, name and value, in their order on the command line.
  std::vector<std::pair<std::string, std::string>> in_order(std::string_view beginning) const;

  /// `run` is what the command does; it returns the exit code.
  Subcommand command(Notes notes, std::function<int(const Call&)> run) const;

 private:
  CLI::App& app_;
  std::map<const CLI::Option*, Values> values_;
};

}  // namespace lasius::tool
