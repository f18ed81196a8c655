// What results of questions on a bitmap have in common: `plan`, each query of `batch`, `drive`.
#pragma once

#include <optional>
#include <string>

#include "tools/bitmap/reasons.h"
#include "tools/record/problem.h"

namespace lasius::tool {

/// The ends of a question, as they were given and as its answer found them.
struct MapEnds {
  template <class Result>
  MapEnds(const LoadedMap& on, const RunOptions& asked, const Place& from, const Place& to,
          const Result& result, const Remedy* joined_by = nullptr)
      : map(on),
        run(asked),
        start(from),
        goal(to),
        status(result.status),
        fault(result.fault),
        error(result.error),
        nearest_free(result.nearest_free),
        nearest_reachable(result.nearest_reachable),
        reached(result.goal_reached),
        remedy(joined_by) {
    if (reached) end = centre(*reached);
    if constexpr (requires { result.way_out; }) {  // but for a drive's
      way_out = result.way_out;
      bad_via = result.bad_via;
      if (reached && !result.path.empty()) end = result.path.back();
    }
  }

  const LoadedMap& map;
  const RunOptions& run;
  const Place &start, &goal;
  Status status;
  Fault fault;
  std::string error;
  std::optional<Cell> nearest_free;       ///< to an invalid start or goal
  std::optional<Cell> nearest_reachable;  ///< likewise
  std::optional<Cell> reached;            ///< where the path ends, with a goal tolerance
  std::optional<Point> end = {};          ///< the place in it
  std::optional<Point> way_out = {};      ///< as Result::way_out
  std::optional<int> bad_via = {};        ///< likewise
  const Remedy* remedy;                   ///< of ends that are not joined; null: none is known

  bool in_metres() const { return run.frame == Frame::world; }
  bool curved() const;  ///< paths are a disc's curves
};

/// The record of a question, but for what came of it beside. Of a path that begins with a way out
/// or ends short of its goal it remarks where. Its error says of an invalid start or goal where it
/// is, as it was given, what blocks it, and the free cell that is nearest; of two that are not
/// joined what would join them; of a goal out of reach what is out of its tolerance.
Record map_record(const MapEnds& ends, const SearchResult& result);
/// The same of another algorithm than that of paths.
Record map_record(const MapEnds& ends, const SearchResult& result, const Algorithm& algorithm);

/// Where the path ends, where a goal tolerance was given.
void add_goal_reached(Json& json, const MapEnds& ends);
/// What blocks an invalid start or goal, and what would join ends that are not.
Json end_findings(const MapEnds& ends);

/// {file, hash, width, height}
Json map_json(const LoadedMap& map);
/// [x, y] of a start or goal, whole: the cell; with decimals a point, in metres told beside.
Json cell_json(const Place& place, bool in_metres = false);

/// The options of the question that a result answers. @throws UsageError, Error
RunOptions recorded_run(const Recorded& from);
/// The same but for the algorithm that paths are by, and its parameters.
RunOptions recorded_run(const Recorded& from, const Algorithm& algorithm);
/// What cells cost in a result. @throws UsageError, Error
CostLayers recorded_costs(const Recorded& from);
/// A start or goal of a result, by its key; a list of them. @throws UsageError, Error
End recorded_end(const Json& result, const std::string& key);
std::vector<End> recorded_ends(const Json& result, const std::string& key);
/// The question that a result answers. @throws UsageError, Error
PlanCommand recorded_plan(const Recorded& from);

}  // namespace lasius::tool
