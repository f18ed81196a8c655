#include "core/plan/stale_answers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/held_bytes.h"
#include "core/base/special_values.h"
#include "core/grid/grid_view.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

/// Labels are asked about no more freed cells than this: so many take as long as a search.
constexpr std::size_t kMostDoubtful = 256;
/// Each takes some kilobytes.
constexpr std::size_t kMostFreed = 1024;

/// How far a point is from a closed cell.
double to_cell(Point p, Cell c) noexcept {
  const double x = std::max({c.x - p.x, 0.0, p.x - c.x - 1});
  const double y = std::max({c.y - p.y, 0.0, p.y - c.y - 1});
  return std::sqrt(x * x + y * y);
}

/// Between two closed cells.
double between(Cell a, Cell b) noexcept {
  const double x = std::max(0, std::abs(a.x - b.x) - 1), y = std::max(0, std::abs(a.y - b.y) - 1);
  return std::sqrt(x * x + y * y);
}

bool is_free(const Grid& grid, Point p) {
  const kernels::FinePoint at = kernels::fine(p.x, p.y);
  return kernels::sees_fine(view_of(grid), at, at);
}

auto place(Cell c) noexcept { return std::pair(c.y, c.x); }

}  // namespace

StaleAnswers::StaleAnswers(std::shared_ptr<const PreparedMap> older, const Grid& now,
                           std::span<const Cell> changed)
    : older_(std::move(older)) {
  take(now, changed);
}

StaleAnswers::StaleAnswers(const StaleAnswers& before, const Grid& now,
                           std::span<const Cell> changed)
    : older_(before.older_), freed_(before.freed_), tells_(before.tells_) {
  take(now, changed);
}

void StaleAnswers::take(const Grid& now, std::span<const Cell> changed) {
  std::erase_if(freed_, [&](const auto& freed) { return now.blocked(freed->cell); });
  const auto known = [this](Cell c) {
    const auto at = std::ranges::lower_bound(freed_, place(c), {},
                                             [](const auto& one) { return place(one->cell); });
    return at != freed_.end() && (*at)->cell == c;
  };
  std::vector<Cell> more;
  for (const Cell c : changed)
    if (now.free(c) && older_->grid.blocked(c) && !known(c)) more.push_back(c);
  std::ranges::sort(more, {}, place);
  more.erase(std::unique(more.begin(), more.end()), more.end());
  tells_ = tells_ && freed_.size() + more.size() <= kMostFreed;
  if (!tells_) return freed_.clear();
  exact::LabelSearch search;
  for (const Cell c : more) freed_.push_back(std::make_shared<const Freed>(freed(c, search)));
  std::ranges::sort(freed_, {}, [](const auto& one) { return place(one->cell); });
}

// A way comes to a cell through another one that is free: beside it, or across from a corner, if
// both cells between are blocked.
StaleAnswers::Freed StaleAnswers::freed(Cell cell, exact::LabelSearch& search) const {
  Freed found{cell};
  if (older_->labels == nullptr) return found;
  const Grid& grid = older_->grid;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const Cell c{cell.x + dx, cell.y + dy};
      if ((dx == 0 && dy == 0) || grid.blocked(c)) continue;
      const bool across = dx != 0 && dy != 0;
      if (across && (grid.free({c.x, cell.y}) || grid.free({cell.x, c.y}))) continue;
      found.beside.push_back(search.view(grid, *older_->graph, *older_->labels, centre(c), {}));
    }
  return found;
}

std::int64_t StaleAnswers::bytes() const noexcept {
  std::int64_t bytes = bitmap_bytes(older_->grid) + held_bytes(freed_);
  for (const auto& freed : freed_) {
    bytes += static_cast<std::int64_t>(sizeof *freed) + held_bytes(freed->beside);
    for (const auto& view : freed->beside) bytes += held_bytes(view.blocks, view.dead);
  }
  return bytes;
}

bool StaleAnswers::search(Memory memory, const Grid& now, Point from, Point to,
                          const ExactOptions& options, const StopCondition& stop,
                          ExactAnswer& answer) const {
  const Grid& grid = older_->grid;
  if (!tells_ || !is_free(grid, from) || !is_free(grid, to)) return false;
  // The ordinary search has some path early, tells of better ones, and ends at a gap.
  if (options.improved != nullptr || options.target_gap > 0) return false;
  if (older_->labels != nullptr) {
    if (!memory.labels.search(grid, *older_->graph, *older_->labels, from, to, {}, stop, answer))
      return false;
  } else {
    if (stop.token.stop_possible() || stop.deadline != Clock::time_point::max()) return false;
    const double straight = exact::distance(2 * from.x, 2 * from.y, 2 * to.x, 2 * to.y);
    for (const auto& freed : freed_)
      if (to_cell(from, freed->cell) + to_cell(to, freed->cell) < straight * (1 + 1e-9))
        return false;
    memory.prepared.search(grid, *older_->graph, from, to, {}, stop, answer);
  }
  if (!answer.optimal || path_fault(now, answer.path)) return false;
  return none_shorter(memory, from, to, answer.length);
}

bool StaleAnswers::none_shorter(Memory memory, Point from, Point to, double length) const {
  struct Doubtful {
    const Freed* freed;
    double from_start, to_goal;
  };
  std::vector<Doubtful> doubtful;
  for (const auto& freed : freed_)
    if (to_cell(from, freed->cell) + to_cell(to, freed->cell) < length)
      doubtful.push_back({freed.get(), kInfinity, kInfinity});
  if (doubtful.empty()) return true;
  if (older_->labels == nullptr || doubtful.size() > kMostDoubtful) return false;
  const exact::CornerGraph& graph = *older_->graph;
  const exact::CornerLabels& labels = *older_->labels;
  const auto measure = [&](Point end, double Doubtful::*bound) {
    const auto view = memory.labels.view(older_->grid, graph, labels, end, {});  // whole
    std::array<double, 8> lengths{};
    for (Doubtful& one : doubtful) {
      const auto& beside = one.freed->beside;
      const std::span ways(lengths.data(), beside.size());
      memory.labels.lengths_to(older_->grid, graph, labels, view, beside, ways);
      for (const double way : ways)
        one.*bound = std::min(one.*bound, std::max(way - kReach, to_cell(end, one.freed->cell)));
    }
  };
  // A cell that no way short enough begins to use, or ends to, matters as the other end alone.
  measure(from, &Doubtful::from_start);
  std::vector<Doubtful> firsts;
  std::ranges::copy_if(doubtful, std::back_inserter(firsts), [&](const Doubtful& one) {
    return one.from_start + to_cell(to, one.freed->cell) < length;
  });
  if (firsts.empty()) return true;
  measure(to, &Doubtful::to_goal);
  std::erase_if(doubtful, [&](const Doubtful& one) {
    return to_cell(from, one.freed->cell) + one.to_goal >= length;
  });
  for (const Doubtful& first : firsts)
    for (const Doubtful& last : doubtful)
      if (first.from_start + between(first.freed->cell, last.freed->cell) + last.to_goal < length)
        return false;
  return true;
}

}  // namespace lasius
