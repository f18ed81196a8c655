// lasius tune: a race over parameters, and what it writes.
#include <filesystem>

#include "core/base/output.h"
#include "tools/console/crew.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/outputs.h"
#include "tools/study/files.h"
#include "tools/study/sources/console.h"
#include "tools/study/tune/tune_report.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;

void write_tuning(const study::Tuning& tuning, const study::Tuned& tuned, Delivery& files) {
  const EndAtOnce runs_are_kept;
  files.write([&](const std::string& file) {
    const std::string name = fs::path(file).filename().string();
    study::write_text(file, name == "race.csv"         ? race_table(tuned).csv()
                            : name == "candidates.csv" ? candidate_table(tuning, tuned).csv()
                            : name == "report.md"      ? tune_page(tuning, tuned)
                                                       : preset_text(tuning, tuned));
  });
}

void make_ready(const TuneCommand& command, const study::Tuning& tuning,
                const std::vector<std::string>& files) {
  study::make_folder(command.folder);
  std::vector<std::string> inputs{command.file};
  for (const study::Contender& c : tuning.candidates) inputs.push_back(c.preset_file);
  check_outputs(files, inputs);  // before hours of work
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
  std::vector<std::string> files;
  for (const char* name : {"race.csv", "candidates.csv", "report.md", "preset.yaml"})
    files.push_back((fs::path(command.folder) / name).string());
  if (!follows()) make_ready(command, tuning, files);
  Delivery delivery(files);
  const SignalWatcher signals;
  const study::Tuned tuned = conduct_tuning(tuning, command, signals.token());
  leave_to_leader();
  write_tuning(tuning, tuned, delivery);
  const std::string& preset = files.back();
  if (!tuned.whole) {
    message("interrupted: " + preset + " is the best so far; the same command goes on from here");
    return kInterrupted;
  }
  if (!command.messages.quiet) message(verdict_text(tuning, tuned));
  print(preset + "\n");
  return kFound;
}

}  // namespace lasius::tool
