#include "core/tour/cover/cover_ground.h"

#include <utility>

#include "core/tour/visited.h"

namespace lasius::tour {

namespace {

constexpr double kSamplesOfWidth = 4, kRoundOff = 1e-9;
constexpr double kSamplesOfRadius = 8, kRefined = 4e6;

// Samples that are joined, by one of them and a place there.
struct Part {
  std::int64_t sample;
  Point place;
  std::int64_t size;
};

enum State : std::uint8_t { kBlocked, kPlace, kSeen, kReached };

// Odd, so that the middle of a cell has one.
int odd(double least) { return 2 * static_cast<int>(std::ceil((least - 1) / 2)) + 1; }

int least_samples_of_cell(double width, bool tight) {
  return std::max(tight ? 3 : 1, odd(kSamplesOfWidth / width));
}

int samples_of_cell(const Grid& grid, double width, double radius, bool tight) {
  const int asked = least_samples_of_cell(width, tight);
  if (radius == 0) return asked;
  const double cells = 1.0 * grid.width() * grid.height();
  int count = std::max(asked, odd(std::max(kSamplesOfRadius, kSamplesOfRadius / radius)));
  while (count > asked && cells * count * count > kRefined) count -= 2;
  return count;
}

}  // namespace

bool reaches(const Planner& planner, Point from, Point to, const StopCondition& stop) {
  if (!planner.joined_at(from, to)) return false;
  if (planner.robot().radius == 0) return true;
  const Params exact("exact");  // cells may be joined where a disc is not
  return !planner.plan({.stop = stop, .start_point = from, .goal_point = to}, exact).path.empty() &&
         !planner.plan({.stop = stop, .start_point = to, .goal_point = from}, exact).path.empty();
}

double CoverGround::samples_asked(const Grid& grid, double width, double radius) noexcept {
  const double per_cell = least_samples_of_cell(width, ToolLines::fits_tightly(radius));
  return per_cell * grid.width() * per_cell * grid.height();
}

CoverGround::CoverGround(const Grid& grid, double width, double radius, bool tight)
    : half_(width / 2),
      per_cell_(samples_of_cell(grid, width, radius, tight)),
      slack_(tight ? 0.5 / per_cell_ : 0),
      columns_(grid.width() * per_cell_),
      rows_(grid.height() * per_cell_),
      wanted_(static_cast<std::size_t>(columns_) * rows_, kPlace),
      free_(grid.count_free() * per_cell_ * per_cell_) {}

std::optional<CoverGround> CoverGround::make(const Planner& planner, const ToolLines& lines,
                                             double width, const std::optional<Point>& start,
                                             const StopCondition& stop) {
  const Grid& grid = planner.grid();
  CoverGround ground(grid, width, lines.radius(), lines.tight());
  ground.mark_blocked(grid, lines);
  if (!ground.choose_region(planner, start, stop)) return std::nullopt;
  if (lines.radius() > 0) ground.widen(grid);
  for (const std::uint8_t one : ground.wanted_) ground.wanted_count_ += one;
  ground.waiting_ = {};
  return ground;
}

// Samples that are no place of the tool's centre.
void CoverGround::mark_blocked(const Grid& grid, const ToolLines& lines) {
  const double radius = std::max(0.0, lines.radius() - slack_ - kRoundOff * (slack_ > 0));
  for (int row = 0; row < rows_; ++row) {
    const double y = (row + 0.5) * spacing();
    std::uint8_t* const samples = wanted_.data() + static_cast<std::int64_t>(row) * columns_;
    // Of samples above `from` and below `to`.
    const auto block = [&](double from, double to) {
      const int first = std::max(0, static_cast<int>(std::floor(from * per_cell_ - 0.5)) + 1);
      const int end = std::min(columns_, static_cast<int>(std::ceil(to * per_cell_ - 0.5)));
      if (first < end) std::fill(samples + first, samples + end, kBlocked);
    };
    const bool outside = y < radius || y > grid.height() - radius;
    block(-1, outside ? grid.width() + 1 : radius);
    block(grid.width() - radius, grid.width() + 1);
    const int low = std::max(0, static_cast<int>(std::floor(y - radius)));
    const int high = std::min(grid.height() - 1, static_cast<int>(std::floor(y + radius)));
    for (int cell = low; cell <= high; ++cell) {
      const double away = std::max({0.0, cell - y, y - (cell + 1)});
      if (away > 0 && away >= radius) continue;
      const double reach = std::sqrt(std::max(0.0, radius * radius - away * away));
      for (const ToolLines::Run& run : lines.runs(cell)) block(run.from - reach, run.end + reach);
    }
  }
}

void CoverGround::flood(std::int64_t from, std::uint8_t was, std::uint8_t becomes,
                        std::int64_t& size) {
  size = 0;
  const auto enter = [&](std::int64_t sample) {
    if (wanted_[sample] != was) return;
    wanted_[sample] = becomes;
    waiting_.push_back(sample);
    ++size;
  };
  enter(from);
  while (!waiting_.empty()) {
    const std::int64_t at = waiting_.back();
    waiting_.pop_back();
    const std::int64_t column = at % columns_;
    if (column > 0) enter(at - 1);
    if (column + 1 < columns_) enter(at + 1);
    if (at >= columns_) enter(at - columns_);
    if (at + columns_ < samples()) enter(at + columns_);
  }
}

// A place of the tool's at a sample, or as far from it as samples may be off.
std::optional<Point> CoverGround::clear_beside(const Planner& planner, std::int64_t sample) const {
  const Point p = at(sample);
  for (const double dx : {0.0, slack_, -slack_})
    for (const double dy : {0.0, slack_, -slack_})
      if (planner.clear_at({p.x + dx, p.y + dy})) return Point{p.x + dx, p.y + dy};
  return std::nullopt;
}

// Leaves 1 at the places that are joined to the start, else to the most places, and 0 elsewhere.
bool CoverGround::choose_region(const Planner& planner, const std::optional<Point>& start,
                                const StopCondition& stop) {
  Poller poller(stop);
  std::vector<Part> parts;
  std::int64_t size = 0, most = 0;
  for (std::int64_t sample = 0; sample < samples(); ++sample) {
    if (wanted_[sample] != kPlace) continue;
    flood(sample, kPlace, kSeen, size);
    if (const auto clear = clear_beside(planner, sample)) {
      parts.push_back({sample, *clear, size});
      if (size > most && !start) most = size, place_ = *clear;
    }
    if (poller.stop_after(size)) return false;
  }
  // A start may be of two regions: then of the larger.
  if (start) {
    most = -1;
    for (const Point anchor : anchors_of(planner, *start)) {
      std::int64_t worth = 0;
      for (const Part& part : parts)
        if (planner.joined_at(anchor, part.place)) worth += part.size;
      if (worth > most) most = worth, place_ = anchor;
    }
  }
  for (const Part& part : parts) {
    if (reaches(planner, *place_, part.place, stop)) flood(part.sample, kSeen, kReached, size);
    if (stop.poll() != StopCondition::Cause::none) return false;
  }
  for (std::uint8_t& one : wanted_) one = one == kReached;
  return true;
}

// From the places to the free samples around them, in regions of cells that have a place.
void CoverGround::widen(const Grid& grid) {
  std::vector<std::uint8_t> near(wanted_.size(), 0);
  for (std::int64_t row = 0; row < rows_; ++row)
    for (std::int64_t from = 0; from < columns_; ++from) {
      const std::int64_t first = row * columns_;
      if (wanted_[first + from] == 0) continue;
      std::int64_t to = from;
      while (to + 1 < columns_ && wanted_[first + to + 1] != 0) ++to;
      each_row_within(std::max(0.0, half_ - slack_), at(first + from), at(first + to),
                      [&](std::int64_t a, std::int64_t b) {
                        std::fill(near.begin() + a, near.begin() + b + 1, 1);
                      });
      from = to;
    }
  std::vector<std::int64_t> from;
  for (std::int64_t sample = 0; sample < samples(); ++sample) {
    const Point p = at(sample);
    const bool free = grid.free({static_cast<int>(p.x), static_cast<int>(p.y)});
    if (free && wanted_[sample] != 0) from.push_back(sample);
    wanted_[sample] = free ? kPlace : kBlocked;
  }
  std::int64_t size = 0;
  for (const std::int64_t sample : from) flood(sample, kPlace, kReached, size);
  for (std::int64_t sample = 0; sample < samples(); ++sample)
    wanted_[sample] = wanted_[sample] == kReached && near[sample] != 0;
}

}  // namespace lasius::tour
