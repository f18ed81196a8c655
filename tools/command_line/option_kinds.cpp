#include "tools/command_line/option_kinds.h"

namespace lasius::tool {

void add_repeatable(CLI::App& app, const std::string& names, std::vector<std::string>& to,
                    const std::string& help, const std::string& type) {
  app.add_option(names, to, help)->type_name(type)->allow_extra_args(false);
}

void add_switch(CLI::App& app, const std::string& names, bool& to, const std::string& help) {
  app.add_flag(names, to, help)->disable_flag_override();
}

AddOption option_adder(CLI::App& app) {
  return [&app](const char* names, std::string& to, const char* help, const char* type) {
    return app.add_option(names, to, help)->type_name(type);
  };
}

void add_search_options(CLI::App& app, SearchText& text, const SearchHelp& help) {
  const AddOption option = option_adder(app);
  option("--algorithm", text.algorithm, "Algorithm, as listed by `lasius algorithms`", "NAME");
  add_repeatable(app, "--set", text.set,
                 "Set any parameter of the algorithm (repeatable; wins over its own option)",
                 "NAME=VALUE");
  option("--ants", text.value_of("ants"), "Ants an iteration", "N");
  option("--iterations", text.value_of("iterations"), "Iterations", "N");
  option("--seed", text.seed, help.seed, "N");
  option("--threads", text.threads,
         "Threads (default LASIUS_THREADS, OMP_NUM_THREADS, all cores); never changes a result",
         "N");
  option("--time-limit", text.time_limit, help.time_limit, "SECONDS");
  option("--target-gap", text.target_gap, help.target_gap, "PCT");
  add_switch(app, "--json", text.json, help.json);
  add_repeatable(app, "-o,--output", text.outputs, help.outputs, "FILE");
  option("--progress", text.progress, "Progress on stderr", "auto|always|never");
  add_switch(app, "-q,--quiet", text.quiet, "Print errors only");
  add_switch(app, "-v,--verbose", text.verbose, "Print what is done");
}

}  // namespace lasius::tool
