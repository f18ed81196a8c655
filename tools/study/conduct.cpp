#include "tools/study/conduct.h"

#include <filesystem>

#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/study/files.h"

namespace lasius::tool {

int conduct(const StudyCommand& command, const study::Study& study, const study::Domain& domain,
            const std::function<void(const study::Findings&, const StopCondition&)>& write) {
  const std::filesystem::path folder = command.folder;
  study::make_folder(folder);
  for (const char* name : {"report.md", "runs.csv", "results.csv", "tests.csv"})
    check_outputs({(folder / name).string()}, {});  // before hours of work
  SignalWatcher signals;
  const auto findings = [&] {
    constexpr std::int64_t kParts = 1000;
    ProgressLine bar(wants_progress(command.messages), kParts);
    const auto show = [&](std::int64_t done, std::int64_t total, const std::string& note) {
      bar.update(done * kParts / std::max<std::int64_t>(total, 1), note);
    };
    return study::run_study(study, domain,
                            {.seeds = command.seeds,
                             .threads = command.threads,
                             .folder = folder,
                             .stop = signals.token(),
                             .progress = show});
  }();
  if (!findings) {
    message("interrupted; the same command goes on from here");
    return kInterrupted;
  }
  write(*findings, {.token = signals.token()});
  print((folder / "report.md").string() + "\n");
  return kFound;
}

}  // namespace lasius::tool
