#include "tools/study/sources/online_worlds.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/plan/planner.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

/// Numbers that are the same everywhere; the distributions of <random> are not.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}
  int between(int least, int most) {
    return least + static_cast<int>(engine_() % static_cast<std::uint64_t>(most - least + 1));
  }

 private:
  std::mt19937_64 engine_;
};

constexpr int kClosures = 6, kDoors = 6, kPallets = 10, kForklifts = 12;
constexpr int kTries = 20;  // for each of them, until one leaves a way

/// Shelves in rows, and the aisles between them.
struct Warehouse {
  static constexpr int kWidth = 144, kHeight = 128, kAisle = 7;
  int shelf_width, shelf_height;

  explicit Warehouse(Draws& draws)
      : shelf_width(draws.between(18, 30)), shelf_height(draws.between(5, 8)) {}

  int column(int i) const noexcept { return i * (shelf_width + kAisle); }
  int row(int i) const noexcept { return i * (shelf_height + kAisle); }
  int columns() const noexcept { return (kWidth - kAisle) / (shelf_width + kAisle); }
  int rows() const noexcept { return (kHeight - kAisle) / (shelf_height + kAisle); }
  Grid map() const {
    Grid grid(kWidth, kHeight);
    for (int j = 0; j < rows(); ++j)
      for (int i = 0; i < columns(); ++i)
        grid.fill({column(i) + kAisle, row(j) + kAisle, shelf_width, shelf_height}, true);
    return grid;
  }
  /// Along two aisles that meet, one lane wide.
  MovingObstacle forklift(Draws& draws) const {
    constexpr int kSide = 3, kLane = (kAisle - kSide) / 2;
    const auto x = [&] { return column(draws.between(0, columns())) + kLane; };
    const auto y = [&] { return row(draws.between(0, rows())) + kLane; };
    const int turn_x = x(), turn_y = y();
    return {.width = kSide,
            .height = kSide,
            .speed = 0.25 * draws.between(1, 3),
            .track = {{x(), turn_y}, {turn_x, turn_y}, {turn_x, y()}}};
  }
};

/// A map with sides of at most 200 cells, one cell for each square of k x k: blocked if any is.
Grid shrunk(const Grid& grid) {
  constexpr int kMost = 200;
  const int k = (std::max(grid.width(), grid.height()) + kMost - 1) / kMost;
  Grid small((grid.width() + k - 1) / k, (grid.height() + k - 1) / k);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x)
      if (grid.blocked({x, y})) small.set_blocked({x / k, y / k});
  return small;
}

bool joined(const Grid& grid, Cell a, Cell b) {
  return grid.free(a) && grid.free(b) && Planner(grid).connected(a, b);
}

void draw_ends(OnlineWorld& world, Draws& draws) {
  const Grid& grid = world.known;
  const Planner planner(grid);
  const auto cell = [&] {
    return Cell{draws.between(0, grid.width() - 1), draws.between(0, grid.height() - 1)};
  };
  const double far = 0.75 * std::max(grid.width(), grid.height());
  do {
    world.start = cell();
    world.goal = cell();
  } while (std::hypot(world.goal.x - world.start.x, world.goal.y - world.start.y) < far ||
           grid.blocked(world.start) || grid.blocked(world.goal) ||
           !planner.connected(world.start, world.goal));
}

/// Blocks squares one after another where the shortest way that is left turns, each where that
/// leaves a way: in doors, at the corners of buildings.
std::vector<Rectangle> shut_ways(Grid& grid, Cell start, Cell goal, int count, Draws& draws) {
  std::vector<Rectangle> shut;
  for (int tries = 0; tries < kTries * count && static_cast<int>(shut.size()) < count; ++tries) {
    const Result way = Planner(grid).plan({start, goal}, Params("exact"));
    const int last = static_cast<int>(way.path.size()) - 1;
    const Point at = last > 1 ? way.path[static_cast<std::size_t>(draws.between(1, last - 1))]
                              : Point{(start.x + goal.x) / 2.0, (start.y + goal.y) / 2.0};
    const int half = draws.between(3, 6);
    const int x = std::max(0, static_cast<int>(at.x) - half);
    const int y = std::max(0, static_cast<int>(at.y) - half);
    const Rectangle part{x, y, std::min(2 * half + 1, grid.width() - x),
                         std::min(2 * half + 1, grid.height() - y)};
    Grid shut_there = grid;
    shut_there.fill(part, true);
    if (!joined(shut_there, start, goal)) continue;
    grid = std::move(shut_there);
    shut.push_back(part);
  }
  return shut;
}

/// Doors shut early in the drive, and open again: what was a wall stays one.
void shut_doors(OnlineWorld& world, Draws& draws) {
  constexpr int kSoonest = 5, kLatest = 100, kShortest = 100, kLongest = 300;  // ticks
  Grid shut = world.truth;
  for (const Rectangle& part : shut_ways(shut, world.start, world.goal, kDoors, draws)) {
    const int tick = draws.between(kSoonest, kLatest);
    const int again = tick + draws.between(kShortest, kLongest);
    world.changes.cells.push_back({tick, part, true});
    for (int y = part.y; y < part.y + part.height; ++y)
      for (int x = part.x; x < part.x + part.width; ++x)
        if (world.truth.free({x, y})) world.changes.cells.push_back({again, {x, y, 1, 1}, false});
  }
}

/// One cell in 16 is otherwise; those that would leave no way are not.
void scatter(OnlineWorld& world, Draws& draws) {
  Grid& truth = world.truth;
  for (int tries = 0; tries < kTries; ++tries) {
    truth = world.known;
    for (int y = 0; y < truth.height(); ++y)
      for (int x = 0; x < truth.width(); ++x)
        if (draws.between(1, 16) == 1) truth.set_blocked({x, y}, truth.free({x, y}));
    truth.set_blocked(world.start, false);
    truth.set_blocked(world.goal, false);
    if (joined(truth, world.start, world.goal)) return;
  }
  truth = world.known;
}

void put_pallets(OnlineWorld& world, Draws& draws) {
  for (int i = 0; i < kPallets; ++i) {
    Grid truth = world.truth;
    truth.fill({draws.between(0, truth.width() - 4), draws.between(0, truth.height() - 4), 4, 4},
               true);
    if (joined(truth, world.start, world.goal)) world.truth = std::move(truth);
  }
}

std::string made_of(const std::string& family, int number) {
  const std::string seed = ' ' + std::to_string(number);
  if (family == "city") return "city 128x128 0.4" + seed;
  if (family == "rooms") return "rooms 128x128 0.1" + seed;
  if (family == "noise") return "random 128x128 0.15" + seed;
  throw Error(ErrorCode::invalid_parameter, "no world is made by \"" + family + "\"",
              "say city, rooms, warehouse, noise or file, and a number");
}

}  // namespace

OnlineWorld make_online_world(const std::string& words, std::uint64_t seed,
                              const std::filesystem::path& maps) {
  std::istringstream in(words);
  std::string family, file;
  int number = 0;
  in >> family >> number >> file;
  Draws of_map(static_cast<std::uint64_t>(number)), of_seed(1000 + seed);
  const Warehouse warehouse(of_map);
  const Grid known =
      family == "warehouse"
          ? warehouse.map()
          : shrunk(load_map(family == "file" ? file : made_of(family, number), maps));
  OnlineWorld world{known, known, {}, {}, {}};
  draw_ends(world, of_map);
  const auto close = [&](int count) {
    (void)shut_ways(world.truth, world.start, world.goal, count, of_seed);
  };
  if (family == "city") close(kClosures);
  if (family == "file") close(kClosures / 2);
  if (family == "rooms" || family == "file") shut_doors(world, of_seed);
  if (family == "noise") scatter(world, of_seed);
  if (family == "warehouse") {
    put_pallets(world, of_seed);
    for (int i = 0; i < kForklifts; ++i)
      world.changes.obstacles.push_back(warehouse.forklift(of_seed));
  }
  return world;
}

Grid all_shut(const OnlineWorld& world) {
  Grid grid = world.truth;
  for (const Change& change : world.changes.cells)
    if (change.blocked) grid.fill(change.part, true);
  return grid;
}

}  // namespace lasius::study
