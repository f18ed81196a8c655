// One question on a polygon world answered, with all that a result records.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "lasius/polygon/plan.h"
#include "tools/options/options.h"
#include "tools/record/problem.h"

namespace lasius::tool {

/// A world made ready, and what it took.
struct LoadedWorld {
  WorldOptions options;    ///< what it was made of
  std::uint64_t hash = 0;  ///< of the world as read
  polygon::Planner planner;
  double read_ms = 0;
  double ready_ms = 0;

  /// Corners of the boundary's bounding box.
  Point low() const;
  Point high() const;
};

/// @throws Error for a file that is missing or broken, or leaves no free space.
LoadedWorld load_world(const WorldOptions& options);

/// Notes what reading the world said and, with -v, what it holds.
void note_world(const LoadedWorld& world, const Algorithm& algorithm, SearchOptions& options);
/// What a result tells of its world: {map: {file, hash, width, height}}.
Json inputs_json(const LoadedWorld& world);
/// And among its parameters.
Json parameters_of(const LoadedWorld& world, const SearchOptions& options,
                   const Algorithm& algorithm);
/// The world of a result. @throws UsageError
WorldOptions recorded_world(const Recorded& from);

/// All that a plan on a polygon world was asked and found.
struct PolygonAnswer {
  polygon::Params parameters;
  Point start, goal;
  polygon::Result result;
  double elapsed_ms = 0;  ///< without the search for the optimum, unless that is asked
};

/// What ran on what.
std::string polygon_title(const LoadedWorld& world, const polygon::Params& parameters);

/// The answer to `asked`, with start and goal; `elapsed` with the search for the optimum.
PolygonAnswer to_answer(const polygon::Params& parameters, const polygon::Request& asked,
                        polygon::Result result, std::chrono::duration<double, std::milli> elapsed);

/// Plans. Precondition: start and goal are given by the command or the world.
PolygonAnswer polygon_answer(const LoadedWorld& world, const PolygonCommand& command,
                             const polygon::Params& parameters, const StopCondition& stop,
                             const polygon::Observer& observer = {});

}  // namespace lasius::tool
