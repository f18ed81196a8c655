// lasius_mpi: the commands of lasius on many ranks.
#include <array>
#include <cstdio>
#include <string_view>

#include "tools/command_line/program.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/mpi/mpi_crew.h"

int main(int argc, char** argv) {
  using namespace lasius::tool;
  // What a shell asks at a key needs no ranks.
  if (argc > 1 && std::string_view(argv[1]) == "complete") return run_program(argc, argv);
  MpiCrew ranks(&argc, &argv);
  constexpr std::array<std::string_view, 4> kShared{"batch", "plan", "study", "tune"};
  bool shares = false;
  for (const auto command : kShared) shares = shares || (argc > 1 && command == argv[1]);
  int code = kFound;
  if (!ranks.leads())  // one rank speaks for all
    for (std::FILE* const stream : {stdout, stderr})
      if (std::freopen("/dev/null", "w", stream) == nullptr) code = kInternal;
  if (shares) {
    set_crew(&ranks);
    try {
      ranks.read_environment();
    } catch (const UsageError& fault) {
      message(fault.what());
      code = kUsage;
    }
  }
  if (code == kFound && (ranks.leads() || shares)) code = run_program(argc, argv);
  ranks.leave(code);
  return ranks.leads() ? code : kFound;
}
