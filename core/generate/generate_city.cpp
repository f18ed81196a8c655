// A city: streets cut the map into blocks, blocks into lots; lots carry buildings of many outlines.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <vector>

#include "core/base/poller.h"
#include "core/generate/generate_kinds.h"

namespace lasius {
namespace {

// The cells [x0, x1) x [y0, y1).
struct Plot {
  int x0, y0, x1, y1;
  int width() const noexcept { return x1 - x0; }
  int height() const noexcept { return y1 - y0; }
  std::int64_t area() const noexcept { return std::int64_t{width()} * height(); }
};

struct Direction {
  int x, y, length;
};

Direction random_direction(MapDraws& draws) {
  const int x = draws.between(20, 100);
  const int y = draws.between(20, 100);
  const auto length = integer_sqrt(static_cast<std::uint32_t>(x * x + y * y));
  return {draws.chance(128) ? x : -x, y, static_cast<int>(length)};
}

// A building by an implicit outline, in half cells from the middle of its lot.
class Building {
 public:
  Building(const Plot& lot, int unit, MapDraws draws) {
    const int margin =
        std::min(draws.below(2 + unit / 6), (std::min(lot.width(), lot.height()) - 2) / 2);
    plot_ = {lot.x0 + margin, lot.y0 + margin, lot.x1 - margin, lot.y1 - margin};
    half_x_ = plot_.width();
    half_y_ = plot_.height();
    constexpr std::array<Outline, 14> kMix = {kBox,     kBox,    kBox,    kNotched, kNotched,
                                              kNotched, kYard,   kYard,   kBevel,   kBevel,
                                              kBevel,   kTurned, kTurned, kRound};
    outline_ = kMix[draws.below(kMix.size())];
    cut_x_ = half_x_ * draws.between(-60, 40) / 100;
    cut_y_ = half_y_ * draws.between(-60, 40) / 100;
    flip_x_ = draws.chance(128) ? -1 : 1;
    flip_y_ = draws.chance(128) ? -1 : 1;
    for (int& bevel : bevels_) bevel = draws.between(110, 220);
    direction_ = random_direction(draws);
  }

  const Plot& plot() const noexcept { return plot_; }

  bool covers(int x, int y) const noexcept {
    const int u = (2 * x + 1 - plot_.x0 - plot_.x1) * flip_x_;
    const int v = (2 * y + 1 - plot_.y0 - plot_.y1) * flip_y_;
    switch (outline_) {
      case kBox:
        return true;
      case kNotched:
        return u < cut_x_ || v < cut_y_;
      case kYard:
        return 2 * std::abs(u) > half_x_ || v < cut_y_;
      case kBevel:
        return inside_bevels(u, v);
      case kTurned:
        return inside_turned(u, v);
      case kRound: {
        const std::int64_t a = std::int64_t{half_x_} * half_x_;
        const std::int64_t b = std::int64_t{half_y_} * half_y_;
        return std::int64_t{u} * u * b + std::int64_t{v} * v * a <= a * b;
      }
    }
    return false;
  }

 private:
  enum Outline { kBox, kNotched, kYard, kBevel, kTurned, kRound };

  // The four corners are cut off, each by its own share.
  bool inside_bevels(int u, int v) const noexcept {
    const int corner = (u > 0 ? 1 : 0) + (v > 0 ? 2 : 0);
    const std::int64_t reach =
        std::int64_t{std::abs(u)} * half_y_ + std::int64_t{std::abs(v)} * half_x_;
    return reach * 100 <= std::int64_t{half_x_} * half_y_ * bevels_[corner];
  }
  bool inside_turned(int u, int v) const noexcept {
    const int along = std::abs(u * direction_.x + v * direction_.y);
    const int aside = std::abs(v * direction_.x - u * direction_.y);
    return 10 * along <= 9 * half_x_ * direction_.length &&
           10 * aside <= 6 * half_y_ * direction_.length;
  }

  Plot plot_{};
  int half_x_, half_y_;
  Outline outline_;
  int cut_x_, cut_y_, flip_x_, flip_y_;
  std::array<int, 4> bevels_{};
  Direction direction_{};
};

class City {
 public:
  City(int width, int height, const MapRandom& random)
      : width_(width),
        height_(height),
        unit_(std::clamp(std::min(width, height) / 24, 3, 14)),
        random_(random) {}

  /// Calls `visit(lot, number)` for every lot.
  void for_each_lot(Poller& poller,
                    const std::function<void(const Plot&, std::uint32_t)>& visit) const {
    MapDraws draws(random_, MapStream::city);
    std::uint32_t number = 0;
    std::vector<Plot> blocks = {{0, 0, width_, height_}};
    while (!blocks.empty()) {
      const Plot block = blocks.back();
      blocks.pop_back();
      if (poller.stop_after(std::max(block.width(), block.height()))) return;
      if (std::max(block.width(), block.height()) > 7 * unit_)
        cut(block, street_width(block), 2 * unit_, draws, blocks);
      else
        cut_lots(block, draws, [&](const Plot& lot) { visit(lot, number++); });
    }
  }

  Building building(const Plot& lot, std::uint32_t number) const {
    return Building(lot, unit_, MapDraws(random_, MapStream::buildings, number, 1));
  }
  /// Decides which lots are built on; uniform in 32 bits.
  std::uint32_t rank(std::uint32_t number) const {
    return random_.at(MapStream::buildings, number, 0)[0];
  }

  /// Straight streets across everything, at any angle.
  void clear_avenues(Grid& grid, Poller& poller) const {
    MapDraws draws(random_, MapStream::city, 1);
    const int count = (width_ + height_) / (50 * unit_);
    for (int k = 0; k < count && !poller.stop_after(grid.height()); ++k) {
      const Direction way = random_direction(draws);
      const Cell through{draws.below(width_), draws.below(height_)};
      clear_avenue(grid, way, through, std::max(2, unit_ / 2));
    }
  }

 private:
  int street_width(const Plot& block) const noexcept {
    const int longer = std::max(block.width(), block.height());
    if (longer > 80 * unit_) return unit_ * 5 / 4;
    return std::max(2, longer > 20 * unit_ ? unit_ * 3 / 4 : unit_ * 2 / 5);
  }

  // Cuts a plot across its longer side, leaving `gap` cells between the parts.
  static void cut(const Plot& plot, int gap, int least, MapDraws& draws, std::vector<Plot>& parts) {
    const bool upright = plot.width() >= plot.height();
    const int side = upright ? plot.width() : plot.height();
    const int low = std::max(least, side / 3);
    const int at = draws.between(low, side - gap - low);
    Plot first = plot;
    Plot second = plot;
    (upright ? first.x1 : first.y1) = (upright ? plot.x0 : plot.y0) + at;
    (upright ? second.x0 : second.y0) = (upright ? plot.x0 : plot.y0) + at + gap;
    parts.push_back(first);
    parts.push_back(second);
  }

  template <typename Visit>
  void cut_lots(const Plot& block, MapDraws& draws, const Visit& visit) const {
    std::vector<Plot> plots = {block};
    while (!plots.empty()) {
      const Plot plot = plots.back();
      plots.pop_back();
      const int longer = std::max(plot.width(), plot.height());
      if (longer > 4 * unit_ || (longer > 2 * unit_ + 2 && draws.chance(100))) {
        cut(plot, draws.chance(140) ? 0 : draws.between(1, std::max(1, unit_ / 5)), unit_ / 2,
            draws, plots);
      } else if (std::min(plot.width(), plot.height()) >= 2) {
        visit(plot);
      }
    }
  }

  static void clear_avenue(Grid& grid, Direction way, Cell through, int half_width) {
    // |dx * way.y - dy * way.x| <= half_width * length, solved for dx; way.y > 0.
    const std::int64_t reach = std::int64_t{half_width} * way.length;
    for (int y = 0; y < grid.height(); ++y) {
      const std::int64_t middle = std::int64_t{y - through.y} * way.x;
      const std::int64_t from = through.x + (middle - reach) / way.y;
      const std::int64_t to = through.x + (middle + reach) / way.y;
      const int x0 = static_cast<int>(std::clamp<std::int64_t>(from, 0, grid.width()));
      const int x1 = static_cast<int>(std::clamp<std::int64_t>(to + 1, 0, grid.width()));
      grid.fill({x0, y, x1 - x0, 1}, false);
    }
  }

  int width_;
  int height_;
  int unit_;
  MapRandom random_;
};

std::int64_t count_covered(const Building& building) {
  std::int64_t count = 0;
  const Plot& plot = building.plot();
  for (int y = plot.y0; y < plot.y1; ++y) {
    for (int x = plot.x0; x < plot.x1; ++x) count += building.covers(x, y) ? 1 : 0;
  }
  return count;
}

// The rank below which lots are built on, so that buildings take about `share` of the map. Of very
// many lots one in 16 is looked at.
std::uint64_t rank_limit(const City& city, const Grid& grid, BlockedShare share, Poller& poller) {
  constexpr std::int64_t kManyCells = 1 << 22;
  const std::int64_t cells = std::int64_t{grid.width()} * grid.height();
  const std::uint32_t step = cells > kManyCells ? 16 : 1;
  std::int64_t covered = 0;
  std::int64_t looked_at = 0;
  std::int64_t lots = 0;
  city.for_each_lot(poller, [&](const Plot& lot, std::uint32_t number) {
    ++lots;
    if (number % step != 0) return;
    ++looked_at;
    poller.stop_after(lot.area());
    covered += count_covered(city.building(lot, number));
  });
  if (covered == 0) return 0;
  // cells * share / (covered * lots / looked_at), in an order that does not overflow
  const std::int64_t all_covered = std::max<std::int64_t>(1, covered * lots / looked_at);
  const std::int64_t wanted =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(cells) * share >> 32);
  return static_cast<std::uint64_t>(std::min(wanted, all_covered) << 32) /
         static_cast<std::uint64_t>(all_covered);
}

}  // namespace

void make_city(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller) {
  const City city(grid.width(), grid.height(), random);
  const std::uint64_t limit = rank_limit(city, grid, share, poller);
  city.for_each_lot(poller, [&](const Plot& lot, std::uint32_t number) {
    if (city.rank(number) >= limit) return;
    poller.stop_after(lot.area());
    const Building building = city.building(lot, number);
    const Plot& plot = building.plot();
    for (int y = plot.y0; y < plot.y1; ++y) {
      for (int x = plot.x0; x < plot.x1; ++x)
        if (building.covers(x, y)) grid.set_blocked({x, y});
    }
  });
  city.clear_avenues(grid, poller);
}

}  // namespace lasius
