#include "core/smooth/path_maker.h"

#include <algorithm>
#include <numeric>

#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/smooth/tighten.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

// A shortcut must beat rounding.
constexpr double kClearlyShorter = 1 - exact::kRounding;

// Work that looking for a shortcut may take: so much, and more for each tile that was entered.
constexpr std::int64_t kLeastWords = 16384;
constexpr std::int64_t kWordsPerTile = 128;

}  // namespace

std::span<const Cell> PathMaker::cut(const Grid& grid, std::span<const Cell> walk, bool diagonal,
                                     Corners corners, const StopCondition& stop,
                                     std::span<const kernels::PackedCell> more) {
  return cutter_.cut(grid, walk, diagonal, corners, stop, more);
}

void PathMaker::polish(const Grid& grid, std::span<const Cell> way, const Params& params,
                       const StopCondition& stop, std::vector<Point>& path) {
  make(grid, way, params, params.polish != Polish::taut, stop, path);
}

double PathMaker::polish(const Grid& grid, const disc::DiscSpace& disc, double limit,
                         std::span<const Cell> way, const Params& params, const StopCondition& stop,
                         std::vector<Point>& path) {
  make(grid, way, params, true, stop, path);
  const double length = path_length(path);
  if (!(length < limit)) {
    path.clear();
    return length;
  }
  const auto vertices = straightener_.vertices();
  const auto known = std::ranges::find_if(
      known_, [&](const Known& one) { return std::ranges::equal(one.vertices, vertices); });
  if (known != known_.end()) {
    path = known->path;
    return length;
  }
  Known& fresh = known_[oldest_++ % known_.size()];
  fresh.vertices.assign(vertices.begin(), vertices.end());
  straightener_.keep_radius(grid, disc, params.polish != Polish::local, stop);
  path.clear();
  for (const Cell c : straightener_.vertices()) path.push_back(centre(c));
  if (params.polish == Polish::taut) tighten(disc, stop, path);
  fresh.path = path;
  return length;
}

/// `on_cells`: the path's vertices are centres of cells.
void PathMaker::make(const Grid& grid, std::span<const Cell> way, const Params& params,
                     bool on_cells, const StopCondition& stop, std::vector<Point>& path) {
  path.clear();
  const auto take_centres = [&] {
    for (const Cell c : straightener_.vertices()) path.push_back(centre(c));
  };
  if (params.polish == Polish::local) {
    straightener_.run(grid, way, stop, params.straight_window);
    return take_centres();
  }
  straightener_.run(grid, way, stop);
  if (on_cells)
    straightener_.straighten(grid, stop);
  else
    taut_string_.run(grid, straightener_.vertices(), params.corners, stop);
  const auto string = on_cells ? straightener_.string() : taut_string_.path();
  const bool shorter = straightener_.vertices().size() > 2 &&
                       stop.poll() == StopCondition::Cause::none &&
                       find_shortcut(grid, way, path_length(string), stop);
  if (shorter) straightener_.take(grid, shortcut_, stop);
  if (on_cells) {
    take_centres();
  } else {
    const std::span<const Point> taut = shorter ? shortcut_ : string;
    path.assign(taut.begin(), taut.end());
  }
}

/// Finds a string that is shorter than `length` and bends only at corners of cells that the walk
/// entered, or that the path goes over.
bool PathMaker::find_shortcut(const Grid& grid, std::span<const Cell> way, double length,
                              const StopCondition& stop) {
  Poller poller(stop, Poller::kSteps);
  for (const Cell c : straightener_.cells()) {
    cutter_.entered().add(c);
    if (poller.stop_after(1)) return false;
  }
  const CellSet& entered = cutter_.entered();
  const auto tiles = static_cast<std::int64_t>(entered.tiles().size());
  search_.shortcut(grid, way.front(), way.back(), length * kClearlyShorter, entered,
                   kLeastWords + kWordsPerTile * tiles, stop, shortcut_);
  return !shortcut_.empty();
}

std::int64_t PathMaker::bytes() const noexcept {
  return cutter_.bytes() + straightener_.bytes() + taut_string_.bytes() + search_.bytes() +
         held_bytes(shortcut_) +
         std::accumulate(known_.begin(), known_.end(), std::int64_t{0},
                         [](std::int64_t sum, const Known& one) {
                           return sum + held_bytes(one.vertices, one.path);
                         });
}

}  // namespace lasius
