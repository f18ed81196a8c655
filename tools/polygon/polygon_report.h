// The page of a run among polygons.
#pragma once

#include <iosfwd>
#include <memory>
#include <vector>

#include "tools/polygon/polygon_answer.h"
#include "tools/record/task.h"
#include "tools/report/key_frames.h"

namespace lasius::tool {

/// The best path of every iteration, or of a long run of every second, fourth, ... one.
class PolygonFrames {
 public:
  static constexpr std::size_t kMostFrames = 400;

  void observe(const polygon::PlanProgress& progress);
  /// {iterations, paths, path_of}, as RunFrames::json has them; null where there was nothing.
  Json json() const;

 private:
  using Path = std::vector<Point>;
  struct Frame {
    int iteration;
    std::shared_ptr<const Path> path;
  };
  KeyFrames<Frame> frames_{kMostFrames};
  double best_ = 0;
  Frame newest_{0, nullptr};
};

/// Adds to run_json: world {free, obstacles: polygons as lists of rings, lines [[a, b]...], low,
/// high, margin}, dijkstra, frames. `frames` may be null.
void write_polygon_report(std::ostream& out, const Task& task, const LoadedWorld& world,
                          const PolygonAnswer& answer, const PolygonFrames* frames);

}  // namespace lasius::tool
