#include "commands.h"
#include "exit_code.h"
#include "lasius/generate.h"
#include "lasius/io.h"
#include "signals.h"
#include "streams.h"

namespace lasius::tool {

int run_generate(const GenerateCommand& command) {
  check_writable(command.output);
  const Grid map = generate(command.kind, command.options);
  const SignalWatcher signals;  // what is begun is written whole
  write_any_map(map, command.output);
  return signals.interrupted() ? kInterrupted : kFound;
}

}  // namespace lasius::tool
