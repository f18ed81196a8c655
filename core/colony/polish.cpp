#include "core/colony/polish.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/cost/polish.h"
#include "core/grid/move_rule.h"
#include "lasius/path/path.h"

namespace lasius {

namespace {

bool adjacent(std::span<const Cell> way) {
  for (std::size_t i = 1; i < way.size(); ++i)
    if (std::abs(way[i].x - way[i - 1].x) > 1 || std::abs(way[i].y - way[i - 1].y) > 1)
      return false;
  return true;
}

}  // namespace

/// The cells of a tour, start first, and those that its moves cross; none when stopped.
std::span<const Cell> Polisher::swept_cells(std::span<const std::uint8_t> tour,
                                            const StopCondition& stop,
                                            GrowingArray<Cell>& cells) const {
  std::size_t most = 1;  // cells a move
  for (int k = 0; k < moves_->count; ++k) {
    most = std::max<std::size_t>(most, 1 + (*moves_)[k].swept_count);
  }
  cells.grow(1 + most * tour.size());
  Poller poller(stop, Poller::kSteps);
  Cell* end = cells.data();
  Cell c = *end++ = start_;
  for (const int k : tour) {
    if (poller.stop_after(1)) return {};
    const kernels::Move& move = (*moves_)[k];
    for (int i = 0; i < move.swept_count; ++i) *end++ = c + move.swept[i];
    c = *end++ = c + move.to;
  }
  return {cells.data(), end};
}

void Polisher::reset(const Grid& grid, const Request& request, const kernels::Moves& moves,
                     const Params& params, int threads, const disc::DiscSpace* disc,
                     const TourMeasure& measure) {
  grid_ = &grid;
  moves_ = &moves;
  stop_ = &request.stop;
  start_ = request.start;
  params_ = &params;
  disc_ = disc;
  measure_ = measure;
  limit_ = kInfinity;
  threads_ = threads;
  if (static_cast<int>(scratch_.size()) < threads) scratch_.resize(threads);
  for (Scratch& scratch : scratch_) scratch.maker.forget();
  const auto ants = static_cast<std::size_t>(params.ants);
  if (paths_.size() < ants) paths_.resize(ants);  // to free some may take long
  for (PolishedPath& path : paths_) path.made = false;
}

void Polisher::polish(std::span<const Ant> ants, const StopCondition& stop,
                      const std::function<void()>& meanwhile) {
  const auto count = static_cast<int>(ants.size());
  const int threads = params_->polish == Polish::none ? 1 : std::clamp(count / 2, 1, threads_);
  parallel_for(count + 1, threads, [&](int i, int thread) {
    if (i == 0) {
      if (meanwhile) meanwhile();
    } else if (PolishedPath& path = paths_[i - 1]; !std::exchange(path.made, false)) {
      make(ants[i - 1], stop, scratch_[thread], path);
    }
  });
}

void Polisher::polish_ahead(std::span<const Ant> ants, int ant, int thread) {
  PolishedPath& path = paths_[ant];
  if (!std::exchange(path.made, true)) make(ants[ant], *stop_, scratch_[thread], path);
}

void Polisher::make(const Ant& ant, const StopCondition& stop, Scratch& scratch,
                    PolishedPath& path) const {
  path.points.clear();
  path.raster.clear();
  path.length = kNaN;
  if (params_->polish == Polish::none || !ant.arrived) return;
  if (stop.poll() != StopCondition::Cause::none) return;

  const bool local = params_->polish == Polish::local;
  auto way = swept_cells(local ? ant.left() : ant.tour(), stop, scratch.cells);
  if (way.empty()) return;
  // Cells that the ant left again may shorten its way, too.
  if (!local)
    way =
        scratch.maker.cut(*grid_, way, moves_->count > 4, params_->corners, stop, ant.dead_ends());
  if (way.empty()) return;
  if (disc_ != nullptr) {
    const double limit = measure_.terrain() != nullptr ? kInfinity : limit_;
    path.of_point = scratch.maker.polish(*grid_, *disc_, limit, way, *params_, stop, path.points);
  } else {
    scratch.maker.polish(*grid_, way, *params_, stop, path.points);
  }
  const auto cells = scratch.maker.raster();
  path.raster.assign(cells.begin(), cells.end());
  if (measure_.terrain() != nullptr) return cheapen(ant, way, stop, path);
  path.length = path.points.empty() ? path.of_point : path_length(path.points);
}

// What was straightened by length may be dearer than the tour: then this, or the way made cheaper
// where it crosses edges of cells.
void Polisher::cheapen(const Ant& ant, std::span<const Cell> way, const StopCondition& stop,
                       PolishedPath& path) const {
  path.length = path.points.empty() ? kInfinity : measure_.of(path.points);
  const auto offer = [&](std::vector<Point>&& points, const auto& cells) {
    const double cost = measure_.of(points);
    if (!(cost < path.length) || (disc_ != nullptr && !disc_->reaches_along(points))) return;
    path.length = cost;
    path.points = std::move(points);
    path.raster.assign(cells.begin(), cells.end());
  };
  std::vector<Cell> tour{start_};
  std::vector<Point> centres{centre(start_)};
  along_tour(ant.tour(), *moves_, start_, [&](Cell c) {
    if (c == tour.back()) return;
    tour.push_back(c);
    centres.push_back(centre(c));
  });
  offer(std::move(centres), tour);
  if (path.length > limit_ || !adjacent(way)) return end_cheapened(path);
  Poller poller(stop);
  cost::Polish polish(*measure_.terrain());
  offer(polish.polish(centre(start_), cost::legs_of(way), poller), way);
  end_cheapened(path);
}

void Polisher::end_cheapened(PolishedPath& path) {
  path.of_point = path.length;
  if (!(path.length < kInfinity)) path.length = kNaN;
}

std::int64_t Polisher::bytes() const noexcept {
  return held_bytes_of_all(scratch_) + held_bytes_of_all(paths_);
}

}  // namespace lasius
