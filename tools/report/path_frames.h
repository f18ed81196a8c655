// The best path of a run, frame by frame, as pages play it.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "lasius/grid/geometry.h"
#include "tools/record/json_values.h"
#include "tools/report/thinned.h"

namespace lasius::tool {

/// What the frames of all worlds have.
struct PathFrame {
  static constexpr std::size_t kMostVertices = 2000;
  using Path = std::vector<Point>;

  int iteration = 0;                      ///< from 1; 0: none yet
  std::shared_ptr<const Path> path = {};  ///< shared with the frame before where it is the same
  double length = 0;                      ///< of `path`

  /// Brings it up to date; a path of more than kMostVertices is thinned.
  template <class SomeProgress>
  void observe(const SomeProgress& progress) {
    iteration = progress.iteration + 1;
    if (!std::isfinite(progress.best_length) || (path && progress.best_length == length)) return;
    length = progress.best_length;
    const Path all = progress.path();
    path = std::make_shared<const Path>(thinned(all, all.size() / kMostVertices + 1));
  }
};

/// Sets of frames, which are PathFrames or derived from them:
///   iterations       of each
///   paths, path_of   [[[x, y]...]...], and the number of each frame's path, or -1
template <class Frame>
void set_paths(Json& json, const std::vector<Frame>& frames) {
  for (const char* name : {"iterations", "paths", "path_of"}) json[name] = Json::array();
  const PathFrame::Path* last = nullptr;
  for (const PathFrame& frame : frames) {
    json["iterations"].push_back(frame.iteration);
    if (frame.path && frame.path.get() != last) json["paths"].push_back(points(*frame.path));
    last = frame.path.get();
    json["path_of"].push_back(static_cast<int>(json["paths"].size()) - 1);
  }
}

}  // namespace lasius::tool
