#include "commands.h"
#include "exit_code.h"
#include "lasius/generate.h"
#include "lasius/io.h"
#include "streams.h"

namespace lasius::tool {

int run_generate(const GenerateCommand& command) {
  check_writable(command.output);
  write_any_map(generate(command.kind, command.options), command.output);
  return kFound;
}

}  // namespace lasius::tool
