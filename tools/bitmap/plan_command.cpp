#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "lasius/batch.h"
#include "tools/bitmap/announce.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/picture.h"
#include "tools/bitmap/report.h"
#include "tools/commands.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

std::string note(const PreparedMap& map, Frame frame, const Progress& progress) {
  const double cells = progress.best_length;
  if (!std::isfinite(cells)) return "no path yet";
  std::array<char, 48> text;
  std::snprintf(text.data(), text.size(), "best %.3f%s", map.length_in(frame, cells),
                frame == Frame::world ? " m" : "");
  return text.data();
}

/// Plans, with a progress line and the recorder looking on where there are any.
Answer watched_answer(const PreparedMap& map, const RunOptions& run, const Place& start,
                      const Place& goal, const std::stop_token& token,
                      std::optional<PictureRecorder>& recorder) {
  const bool counted = find_algorithm(run.params.algorithm()).has("iterations");
  const bool shown = wants_progress(run.messages);
  ProgressLine bar(shown, counted ? run.params.iterations : 0, run.time_limit.value_or(0));
  Observer observer;
  if (shown || recorder)
    observer = [&](const GridProgress& progress) {
      bar.update(progress.iteration + 1, note(map, run.frame, progress));
      if (recorder) recorder->observe(progress);
    };
  const StopCondition stop{.token = token, .deadline = deadline_after(run.time_limit)};
  return answer(map, run, start, goal, stop, observer);
}

/// False where the answer is known before any search, and preparing more a waste.
bool is_search(const PreparedMap& map, Corners corners, const Request& query,
               const std::stop_token& token) {
  const Cell start = query.start, goal = query.goal;
  return map.planner && map.grid().free(start) && map.grid().free(goal) && start != goal &&
         map.planner->label(corners, {.token = token}) &&
         map.planner->connected(start, goal, corners);
}

}  // namespace

int run_plan(const PlanCommand& command) {
  const RunOptions& run = command.run;
  for (const auto& file : run.outputs) check_writable(file);
  SignalWatcher signals;
  MapOptions first = run.map;
  first.prepare = false;
  PreparedMap map = prepare_map(first, run.frame, run.params.corners, signals.token());
  const Place start = to_place(map, command.start, run.frame);
  const Place goal = to_place(map, command.goal, run.frame);
  map.prepare = run.map.prepare;
  if (map.prepare &&
      is_search(map, run.params.corners, {.start = start.cell, .goal = goal.cell}, signals.token()))
    prepare_more(map, run.map.threads, signals.token());
  announce(map, run);

  std::optional<PictureRecorder> recorder;
  if (moves_on_cells(run) && std::any_of(run.outputs.begin(), run.outputs.end(), is_picture))
    recorder.emplace(map.grid(), run.track_iterations, run.params.iterations);
  const Answer found = watched_answer(map, run, start, goal, signals.token(), recorder);

  const Outcome ended = outcome(map, run, found);
  report(ended, run.messages);
  if (run.with_optimum && !run.json && !run.messages.quiet) {
    if (const std::string gap = gap_text(map, run, found); !gap.empty()) message(gap);
  }
  const bool counts = ended.iterations.has_value();
  const Forms forms{.text = [&] { return result_text(map, run, found); },
                    .json = [&] { return line(result_json(map, run, found)); },
                    .csv =
                        [&] {
                          const Result shown = in_frame(map, run.frame, found.result);
                          return result_csv(shown, shown.path, counts, run.frame);
                        },
                    .write_picture =
                        [&](const std::string& file) {
                          write_plan_picture(file, map, run, found,
                                             recorder ? &*recorder : nullptr);
                        }};
  deliver(forms, run.json, run.outputs, run.messages);
  return signals.interrupted() ? kInterrupted : exit_code(ended);  // --gap may be what was cut off
}

}  // namespace lasius::tool
