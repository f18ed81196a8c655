// The modes of lasius_bench beside Google Benchmark's own.
#pragma once

#include <CLI/CLI.hpp>

namespace lasius::bench {

/// Each adds a subcommand; its callback runs it and throws CLI::RuntimeError(1) on a fault found.
void add_queries_command(CLI::App& app);

}  // namespace lasius::bench
