#include "tools/command_line/program.h"

#include <sys/resource.h>

#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "lasius/base/error.h"
#include "tools/command_line/cli.h"
#include "tools/console/crew.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"

namespace lasius::tool {
namespace {

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

std::string remedy(const std::error_code& fault) {
  if (fault == std::errc::too_many_files_open || fault == std::errc::too_many_files_open_in_system)
    return "; close files, or allow more (ulimit -n)";
  if (fault == std::errc::resource_unavailable_try_again)
    return "; end other programs, or allow more threads (ulimit -u)";
  return {};
}

/// Less than this would end in the middle of a command, without a word.
bool stack_suffices() {
  constexpr rlim_t kLeast = 1 << 20;
  rlimit stack{};
  if (::getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= kLeast) return true;
  message("the stack may take " + std::to_string(stack.rlim_cur / 1024) + " kB only; allow " +
          std::to_string(kLeast / 1024) + " or more (ulimit -s)");
  return false;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  end_on_signals();
  if (!stack_suffices()) return kInternal;
  guard_standard_streams();
  try {
    return run_command_line(argc, argv);
  } catch (const ClosedOutput&) {
    return kFound;
  } catch (const Dismissed&) {
    return kFound;
  } catch (const UsageError& fault) {
    message(fault.what());
    return kUsage;
  } catch (const Error& fault) {
    message(fault.what());
    return exit_code(fault.code());
  } catch (const std::bad_alloc&) {
    message("out of memory");
  } catch (const std::system_error& fault) {  // of files, where lasius::Error says which, too
    message(std::string(fault.what()) + remedy(fault.code()));
  } catch (const std::exception& fault) {
    message(std::string("internal error: ") + fault.what());
  }
  return kInternal;
}

}  // namespace lasius::tool
