// The subcommands: their options, and how what was typed becomes a command.
#pragma once

#include <functional>
#include <vector>

#include "tools/options/options.h"

namespace CLI {
class App;
}

namespace lasius::tool {

/// One subcommand: its options, and how they become a command.
struct Subcommand {
  CLI::App* app;
  std::function<Command()> make;
};

/// The group of options that are only there to be refused: CLI11 tells no name of one without.
inline constexpr const char* kRefused = "refused";

/// All of them, added to the program's.
std::vector<Subcommand> add_subcommands(CLI::App& app);

/// `lasius study` and `lasius tune`.
Subcommand add_study(CLI::App& app);
Subcommand add_tune(CLI::App& app);

/// `lasius arm`.
Subcommand add_arm(CLI::App& app);

}  // namespace lasius::tool
