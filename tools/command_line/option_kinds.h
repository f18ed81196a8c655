// Kinds of options, and those that all planning commands have.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "tools/command_line/run_text.h"

namespace lasius::tool {

/// One that may be given often.
void add_repeatable(CLI::App& app, const std::string& names, std::vector<std::string>& to,
                    const std::string& help, const std::string& type);

/// One without a value.
void add_switch(CLI::App& app, const std::string& names, bool& to, const std::string& help);

using AddOption = std::function<CLI::Option*(const char* names, std::string& to, const char* help,
                                             const char* type)>;

/// Adds options with a value to `app`.
AddOption option_adder(CLI::App& app);

/// What the options that all planning commands have mean to one of them.
struct SearchHelp {
  const char* seed;
  const char* time_limit;
  const char* target_gap;
  const char* json;
  const char* outputs;
};

void add_search_options(CLI::App& app, SearchText& text, const SearchHelp& help);

}  // namespace lasius::tool
