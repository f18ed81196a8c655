// The page of a run among polygons.
#pragma once

#include <cstddef>
#include <iosfwd>

#include "tools/polygon/polygon_answer.h"
#include "tools/record/record.h"
#include "tools/report/key_frames.h"
#include "tools/report/path_frames.h"

namespace lasius::tool {

/// The best path of every iteration, or of a long run of every second, fourth, ... one.
class PolygonFrames {
 public:
  static constexpr std::size_t kMostFrames = 400;

  void observe(const polygon::PlanProgress& progress);
  /// See set_paths; null where there was nothing.
  Json json() const;

 private:
  KeyFrames<PathFrame> frames_{kMostFrames};
  PathFrame newest_;
};

/// Adds to run_json: world {free, obstacles: polygons as lists of rings, walls, lines [[a, b]...],
/// low, high, margin}, dijkstra, frames. `frames` may be null.
void write_polygon_report(std::ostream& out, const Record& run, const LoadedWorld& world,
                          const PolygonAnswer& answer, const PolygonFrames* frames);

}  // namespace lasius::tool
