#include "tools/command_line/option_table.h"

#include <algorithm>
#include <cctype>

#include "tools/console/exit_code.h"

namespace lasius::tool {
namespace {

/// An option that was given an empty value was not left out.
std::string not_empty(const std::string& value) { return value.empty() ? "has no value" : ""; }

bool is_choice(std::string_view word) {
  return !word.empty() && std::ranges::none_of(word, [](unsigned char c) {
    return std::isupper(c) != 0 || c == ',' || c == '.';
  });
}

/// What the name of a value says that a shell may write: FILE, DIR, choices as in "a|b".
Values values_of(std::string_view type) {
  Values values;
  for (const auto word : split(type, '|')) {
    if (word == "FILE") values.files = true;
    if (word == "DIR") values.folders = true;
    if (is_choice(word)) values.choices.emplace_back(word);
  }
  return values;
}

/// The exit codes that every command has, with its own among them.
std::vector<ExitText> exits(std::vector<ExitText> own) {
  const auto add = [&](int code, const char* meaning) {
    if (std::ranges::find(own, code, &ExitText::code) == own.end()) own.push_back({code, meaning});
  };
  add(kFound, "it was done");
  add(kInternal, "internal error");
  add(kUsage, "usage");
  std::ranges::sort(own, {}, &ExitText::code);
  return own;
}

}  // namespace

CLI::Option* OptionTable::add(const std::string& names, const char* help, const char* type,
                              const Read& read) {
  auto* option = app_.add_option_function<std::string>(names, read, help)->type_name(type);
  return shell(option->check(not_empty), values_of(type));
}

CLI::Option* OptionTable::repeatable(const std::string& names, const char* help, const char* type,
                                     const Read& read) {
  const auto all = [read](const Texts& texts) { std::ranges::for_each(texts, read); };
  auto* option = app_.add_option_function<Texts>(names, all, help)->type_name(type);
  return shell(option->allow_extra_args(false)->check(not_empty), values_of(type));
}

CLI::Option* OptionTable::shell(CLI::Option* option, Values values) {
  values_[option] = std::move(values);
  return option;
}

void OptionTable::refuse(std::initializer_list<const char*> names, const std::string& why) const {
  for (const char* name : names)
    if (given(name)) throw UsageError(name + why);
}

std::vector<std::pair<std::string, std::string>> OptionTable::in_order(
    std::string_view beginning) const {
  std::map<const CLI::Option*, std::size_t> used;
  std::vector<std::pair<std::string, std::string>> found;
  for (const CLI::Option* option : app_.parse_order()) {
    const std::string name = option->get_name();
    if (name.starts_with(beginning)) found.emplace_back(name, option->results()[used[option]++]);
  }
  return found;
}

Subcommand OptionTable::command(Notes notes, std::function<int(const Call&)> run) const {
  app_.allow_extras();
  notes.exits = exits(std::move(notes.exits));
  return {&app_, std::move(notes), values_, std::move(run)};
}

}  // namespace lasius::tool
