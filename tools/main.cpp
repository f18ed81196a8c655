#include <exception>
#include <new>

#include "lasius/error.h"
#include "tools/command_line/cli.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/options/commands.h"

namespace lasius::tool {
namespace {

int run_command(const Text& text) {
  print(text.text);
  return kFound;
}

int exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_parameter:
      return kUsage;
    case ErrorCode::output_failed:
      return kNoOutput;
    case ErrorCode::file_missing:
    case ErrorCode::file_broken:
    case ErrorCode::file_unsupported:
      break;
  }
  return kBadFile;
}

int guarded_main(int argc, char** argv) {
  end_on_signals();
  guard_standard_streams();
  try {
    return std::visit([](const auto& command) { return run_command(command); },
                      parse_command_line(argc, argv));
  } catch (const ClosedOutput&) {
    return kFound;
  } catch (const UsageError& fault) {
    message(fault.what());
    return kUsage;
  } catch (const Error& fault) {
    message(fault.what());
    return exit_code(fault.code());
  } catch (const std::bad_alloc&) {
    message("out of memory");
  } catch (const std::exception& fault) {
    message(std::string("internal error: ") + fault.what());
  }
  return kInternal;
}

}  // namespace
}  // namespace lasius::tool

int main(int argc, char** argv) { return lasius::tool::guarded_main(argc, argv); }
