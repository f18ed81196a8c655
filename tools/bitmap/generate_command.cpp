#include <optional>

#include "core/base/output.h"
#include "lasius/generate.h"
#include "lasius/io.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"

namespace lasius::tool {

int run_command(const GenerateCommand& command) {
  check_outputs({command.output}, {});
  GenerateOptions options = command.options;
  const double most = max_density(command.kind);
  if (options.density > most) {
    options.density = most;
    message("--density is " + to_text(most) + ": this kind of map gets no denser");
  }
  const Grid map = generate(command.kind, options);
  std::optional<SignalWatcher> signals;
  if (is_stream(command.output)) signals.emplace();  // what is begun is written whole
  write_any_map(map, command.output);
  return signals && signals->interrupted() ? kInterrupted : kFound;
}

}  // namespace lasius::tool
