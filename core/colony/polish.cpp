#include "core/colony/polish.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/grid/move_rule.h"
#include "lasius/path.h"

namespace lasius {

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
                     const Params& params, int threads, const disc::DiscSpace* disc) {
  grid_ = &grid;
  moves_ = &moves;
  stop_ = &request.stop;
  start_ = request.start;
  params_ = &params;
  disc_ = disc;
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
    path.of_point = scratch.maker.polish(*grid_, *disc_, limit_, way, *params_, stop, path.points);
  } else {
    scratch.maker.polish(*grid_, way, *params_, stop, path.points);
  }
  const auto cells = scratch.maker.raster();
  path.raster.assign(cells.begin(), cells.end());
  path.length = path.points.empty() ? path.of_point : path_length(path.points);
}

std::int64_t Polisher::bytes() const noexcept {
  return held_bytes_of_all(scratch_) + held_bytes_of_all(paths_);
}

}  // namespace lasius
