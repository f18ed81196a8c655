// lasius tune: a race over parameters, and what it writes.
#include <filesystem>

#include "core/base/output.h"
#include "tools/console/crew.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/study/files.h"
#include "tools/study/sources/console.h"
#include "tools/study/tune/tune_report.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;

void write_tuning(const study::Tuning& tuning, const study::Tuned& tuned, const fs::path& folder) {
  const EndAtOnce runs_are_kept;
  study::write_text(folder / "race.csv", race_table(tuned).csv());
  study::write_text(folder / "candidates.csv", candidate_table(tuning, tuned).csv());
  study::write_text(folder / "report.md", tune_page(tuning, tuned));
  study::write_text(folder / "preset.yaml", preset_text(tuning, tuned));
}

void make_ready(const fs::path& folder, const TuneCommand& command, const study::Tuning& tuning) {
  study::make_folder(folder);
  std::vector<std::string> inputs{command.file};
  for (const study::Contender& c : tuning.candidates) inputs.push_back(c.preset_file);
  for (const char* name : {"report.md", "race.csv", "candidates.csv", "preset.yaml"})
    check_outputs({(folder / name).string()}, inputs);  // before hours of work
}

study::Tuned conduct_tuning(study::Tuning& tuning, const TuneCommand& command,
                            const std::stop_token& stop) {
  const auto tell = [&](double seconds) {
    if (!command.messages.quiet)
      message(tuning.name + ": " + std::to_string(tuning.candidates.size()) +
              " candidates, at most about " + duration_text(seconds) + " with " +
              counted(command.threads, "thread") + ", by a part of one run of each");
  };
  return study::tune(tuning, {.threads = command.threads,
                              .folder = command.folder,
                              .maps = find_maps(command.maps),
                              .stop = stop,
                              .estimate = tell,
                              .progress = progress_shown(command.messages)});
}

}  // namespace

int run_command(const TuneCommand& command) {
  study::Tuning tuning = study::read_tuning(command.file);
  if (!command.messages.quiet) tell_unread(tuning.candidates);
  const fs::path folder = command.folder;
  if (!follows()) make_ready(folder, command, tuning);
  const SignalWatcher signals;
  const study::Tuned tuned = conduct_tuning(tuning, command, signals.token());
  leave_to_leader();
  write_tuning(tuning, tuned, folder);
  const std::string preset = (folder / "preset.yaml").string();
  if (!tuned.whole) {
    message("interrupted: " + preset + " is the best so far; the same command goes on from here");
    return kInterrupted;
  }
  if (!command.messages.quiet) message(verdict_text(tuning, tuned));
  print(preset + "\n");
  return kFound;
}

}  // namespace lasius::tool
