// A subcommand: its options, what is told of it, and what it does.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tools/options/manual.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lasius::tool {

/// How the program was called.
struct Call {
  std::string line;                ///< for a shell to read
  std::function<Manual()> manual;  ///< what there is to say of all commands
};

struct Subcommand {
  CLI::App* app;
  Notes notes;
  std::map<const CLI::Option*, Values> values;  ///< that shells may write
  std::function<int(const Call&)> run;          ///< its exit code, once all options are read
};

/// The group of options that are only there to be refused: CLI11 tells no name of one without.
inline constexpr const char* kRefused = "refused";

/// Adds a subcommand to the program's. All of them: tools/kinds.cpp.
using AddSubcommand = Subcommand (*)(CLI::App& program);
std::vector<AddSubcommand> subcommands();

Subcommand add_plan(CLI::App& app);
Subcommand add_batch(CLI::App& app);
Subcommand add_check_proof(CLI::App& app);
Subcommand add_info(CLI::App& app);
Subcommand add_algorithms(CLI::App& app);
Subcommand add_generate(CLI::App& app);
Subcommand add_verify(CLI::App& app);
Subcommand add_merge(CLI::App& app);
Subcommand add_study(CLI::App& app);
Subcommand add_tune(CLI::App& app);
Subcommand add_help(CLI::App& app);

}  // namespace lasius::tool
