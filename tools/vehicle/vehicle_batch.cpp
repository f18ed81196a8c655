#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/base/text_lines.h"
#include "core/loop/batch_run.h"
#include "lasius/base/error.h"
#include "tools/bitmap/picture.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/values.h"
#include "tools/record/batch.h"
#include "tools/record/outputs.h"
#include "tools/record/queries.h"
#include "tools/vehicle/vehicle_answer.h"
#include "tools/vehicle/vehicle_kind.h"

namespace lasius::tool {
namespace {

struct PoseQuery {
  VehicleEnd start;
  std::vector<VehicleEnd> goals;
  StopCondition stop = {};
};

/// The queries of a table whose header names sx, sy, syaw, gx, gy and gyaw among others. `turned`
/// is the turns_hint() of the first yaw that has one.
/// @throws Error(file_missing, file_broken) naming file and line
std::vector<PoseQuery> read_pose_queries(const std::string& file, const LoadedMap& map, Frame frame,
                                         std::string& turned) {
  static constexpr std::array<std::string_view, 6> kVehicleColumns{"sx", "sy", "syaw",
                                                                   "gx", "gy", "gyaw"};
  const std::string text = table_text(file, "name a table of poses");
  std::vector<PoseQuery> queries;
  std::array<std::size_t, 6> at{};
  std::size_t columns = 0;
  char separator = ' ';
  std::int64_t line = 0;
  const auto fail = [&](const std::string& problem, const std::string& remedy) {
    throw Error(ErrorCode::file_broken, {.file = file, .line = std::max<std::int64_t>(line, 1)},
                problem, remedy);
  };
  for (const std::string_view row : split(text, '\n')) {
    ++line;
    if (words_of(row, kBlanksAndCommas).empty()) continue;
    if (columns == 0) separator = separator_of(row);
    auto fields = fields_of(row, separator);
    if (columns == 0) {
      columns = fields.size();
      for (std::size_t i = 0; i < kVehicleColumns.size(); ++i) {
        const auto found = std::ranges::find(fields, kVehicleColumns[i]);
        if (found == fields.end())
          fail("the header has no column " + std::string(kVehicleColumns[i]),
               "begin with sx sy syaw gx gy gyaw");
        if (std::find(found + 1, fields.end(), kVehicleColumns[i]) != fields.end())
          fail("two columns are named " + std::string(kVehicleColumns[i]), "rename one of them");
        at[i] = static_cast<std::size_t>(found - fields.begin());
      }
      continue;
    }
    leave_out_empty(fields, columns);
    if (fields.size() != columns)
      fail(counted(static_cast<std::int64_t>(fields.size()), "field") + " instead of " +
               std::to_string(columns),
           "give every line what the header names");
    const auto end = [&](std::size_t first) {
      const char* const name = first == 0 ? "start" : "goal";
      try {
        // A yaw that is a number, out of range, is of its query alone.
        PoseEnd asked{point_value(name, fields[at[first]] + "," + fields[at[first + 1]], frame)};
        asked.yaw = angle_value(name, fields[at[first + 2]], -kNoLimit, kNoLimit);
        if (turned.empty()) turned = turns_hint(fields[at[first + 2]], asked.yaw);
        return vehicle_end(map, asked, frame);
      } catch (const UsageError& error) {
        fail(error.what(), "correct the line");
        throw;
      }
    };
    const VehicleEnd start = end(0);
    queries.push_back({start, {end(3)}});
  }
  if (columns == 0) fail("is empty", "begin with sx sy syaw gx gy gyaw");
  return queries;
}

std::vector<std::string> end_texts(const VehicleAnswer& answer) {
  std::vector<std::string> texts;
  for (const VehicleEnd* end : {&answer.start, &answer.goal()})
    for (const double value : {end->asked.x, end->asked.y, end->asked.yaw})
      texts.push_back(to_text(value));
  return texts;
}

}  // namespace

int run_vehicle_batch(VehicleCommand command) {
  RunOptions& run = command.run;  // that of the records, which tell their part
  check_files(run);
  SignalWatcher signals;
  Delivery delivery(run.outputs);
  const VehicleMap on = load_vehicle_map(command, {}, signals.token());
  note_files(on, run);
  check_files(run);
  std::string turned;
  std::vector<PoseQuery> queries = read_pose_queries(command.queries, on.map, run.frame, turned);
  if (!turned.empty()) run.notes.push_back(command.queries + ": a yaw" + turned);
  keep_part(queries, command.queries, run.part);
  const auto answer_all = [&](const Batch::Part& part, const BatchOptions& how,
                              const Batch::Take& take) {
    const BatchReceiverOf<VehicleAnswer> receive = [&](const auto& found) {
      VehicleAnswer answer = found.result;
      Record record = vehicle_record(on, command, answer);
      record.index = run.part.among_all(part.first + found.index);
      std::vector<Point> path;
      for (const auto& timed : timed_poses(on, command, answer))
        path.push_back({timed.at.pose.x, timed.at.pose.y});
      take(std::move(record), end_texts(answer), path);
    };
    const auto asked = std::span<const PoseQuery>(queries).subspan(part.first, part.count);
    run_batch<VehicleAnswer>(asked, part.seed, how, receive, [&] {
      return [&](const PoseQuery& query, std::uint64_t) {
        return plan_vehicle(on, command, query.start, query.goals, query.stop);
      };
    });
  };
  const auto draw = [&](const auto& picture, const auto& paths, const auto& caption) {
    write_batch_picture(picture, on.map, run, paths, caption);
  };
  return run_batch({.options = run,
                    .unit = run.frame == Frame::world ? "m" : "",
                    .queries = queries.size(),
                    .poses = true,
                    .costs = on.map.costs.has_value(),
                    .answer = answer_all,
                    .draw = draw},
                   signals, delivery);
}

}  // namespace lasius::tool
