// lasius_bench survive: what a trail that survives a change of the map is worth.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bench/commands.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/number_text.h"
#include "core/colony/colony.h"
#include "lasius/base/error.h"
#include "lasius/path/shortest_walk.h"
#include "lasius/plan/planner.h"

namespace lasius::bench {
namespace {

struct SurviveOptions : Reported {
  int worlds = 30;
  std::uint64_t seed = 1;
  std::string algorithm = "ras";  // constant exponents: blank and surviving differ in the trail
  int train = 200;
  double budget = 4e6;
  double within = 0.02;
};

using Random = std::mt19937_64;

int between(Random& random, int least, int most) {  // equal with every standard library
  return least + static_cast<int>(random() % static_cast<std::uint64_t>(most - least + 1));
}

/// A map, a question, and a rectangle that is blocked or freed.
struct ChangedMap {
  MapKind kind;
  Grid grid;
  Cell start, goal;
  Rectangle part = {};

  std::optional<double> optimum(const Params& params) const {
    return shortest_walk(grid, start, goal, params.neighbours, params.corners);
  }
  Rectangle around(Cell c, int width, int height) const {
    const int x = std::clamp(c.x - width / 2, 0, grid.width() - width);
    const int y = std::clamp(c.y - height / 2, 0, grid.height() - height);
    return {x, y, width, height};
  }
};

/// The i-th map and a question across at least half of it; nothing where no such one is found.
std::optional<ChangedMap> make_map(int i, Random& random) {
  constexpr std::array kinds{MapKind::rooms, MapKind::city, MapKind::blobs, MapKind::random};
  const MapKind kind = kinds[static_cast<std::size_t>(i / 2) % kinds.size()];
  const int side = 128 + 32 * between(random, 0, 4);
  ChangedMap map{kind, generate(kind, {.width = side, .height = side, .seed = random()}), {}, {}};
  const Planner planner(map.grid);
  const auto cell = [&] {
    return Cell{between(random, 0, side - 1), between(random, 0, side - 1)};
  };
  for (int tries = 0; tries < 1'000'000; ++tries) {
    map.start = cell();
    map.goal = cell();
    if (std::hypot(map.goal.x - map.start.x, map.goal.y - map.start.y) >= side / 2.0 &&
        map.grid.free(map.start) && map.grid.free(map.goal) &&
        planner.connected(map.start, map.goal))
      return map;
  }
  return std::nullopt;
}

/// Blocks 7 x 7 to 23 x 23 cells on a way that is known; false where that leaves no way.
bool block_way(ChangedMap& map, const Params& params, Random& random,
               const std::vector<Cell>& way) {
  const int last = static_cast<int>(way.size()) - 1, side = between(random, 7, 23);
  map.part = map.around(way[between(random, last / 5, last * 4 / 5)], side, side);
  Grid grid = map.grid;
  map.grid.fill(map.part, true);
  if (map.optimum(params)) return true;
  map.grid = std::move(grid);
  return false;
}

/// Lays a bar of 3 cells across, to be taken away: false where it does not make the optimum at
/// least 1 / 0.95 times as long.
bool add_bar(ChangedMap& map, const Params& params, Random& random) {
  const int side = map.grid.width(), length = between(random, side / 4, side * 3 / 4);
  const Cell middle{(map.start.x + map.goal.x) / 2 + between(random, -side / 5, side / 5),
                    (map.start.y + map.goal.y) / 2 + between(random, -side / 5, side / 5)};
  const bool upright = std::abs(map.goal.x - map.start.x) > std::abs(map.goal.y - map.start.y);
  map.part = map.around(middle, upright ? 3 : length, upright ? length : 3);
  const Grid grid = map.grid;
  map.grid.fill(map.part, false);
  const auto open = map.optimum(params);
  map.grid.fill(map.part, true);
  const auto closed = map.optimum(params);
  if (open && closed && *open <= 0.95 * *closed) return true;
  map.grid = grid;
  return false;
}

/// Steps of a colony until its shortest cut tour of an iteration is at most `length`; infinite
/// where that takes more than `budget`.
double steps_until(SurvivingColony& colony, const ChangedMap& map, double length, double budget) {
  double steps = 0;
  bool there = false;
  colony.run(map.start, 1 << 30, {}, [&](const GridProgress& seen) {
    steps += static_cast<double>(seen.curves->steps.back());
    there = seen.curves->cut_best.back() <= length;
    return there || steps >= budget ? Go::stop : Go::on;
  });
  return there ? steps : std::numeric_limits<double>::infinity();
}

/// What came of one changed map.
struct Survival {
  ChangedMap map;
  bool blocks;
  double before, after;     // optima
  double surviving, blank;  // steps
  double ratio() const {
    if (std::isinf(surviving) && std::isinf(blank)) return 1;  // neither within the budget
    return surviving / blank;
  }
};

Survival run_map(int i, const SurviveOptions& options) {
  Params params(options.algorithm);
  params.seed = options.seed + static_cast<std::uint64_t>(i);
  params.threads = 1;
  Random random(1'000'003 * options.seed + static_cast<std::uint64_t>(i));
  const bool blocks = i % 2 == 0;
  for (int drawn = 0; drawn < 1000; ++drawn) {
    auto made = make_map(i, random);
    if (!made) continue;
    ChangedMap& map = *made;
    const auto tries = [](const auto& change) {
      for (int n = 0; n < 100; ++n) {
        if (change()) return true;
      }
      return false;
    };
    if (!blocks && !tries([&] { return add_bar(map, params, random); })) continue;
    const double before = map.optimum(params).value();
    SurvivingColony surviving(map.grid, map.goal, params);
    std::vector<Cell> way;
    const Result trained = surviving.run(map.start, options.train);
    for (const Point p : trained.path)
      way.push_back({static_cast<int>(p.x), static_cast<int>(p.y)});
    if (blocks && (way.empty() || !tries([&] { return block_way(map, params, random, way); })))
      continue;
    if (!blocks) map.grid.fill(map.part, false);
    surviving.changed(map.part);
    const double after = map.optimum(params).value();
    SurvivingColony blank(map.grid, map.goal, params);
    const double near = (1 + options.within) * after;
    return {map,
            blocks,
            before,
            after,
            steps_until(surviving, map, near, options.budget),
            steps_until(blank, map, near, options.budget)};
  }
  throw Error(ErrorCode::invalid_parameter, "no world of 1000 can be changed as wanted",
              "give the colony more iterations by --train");
}

/// Ranks, from 0, of the order statistics that hold the median in at least 95 of 100 samples of n.
std::pair<int, int> median_ranks(int n) {
  double below = 0, term = std::pow(0.5, n);
  int k = 0;
  for (; below + term <= 0.025; ++k) {
    below += term;
    term *= static_cast<double>(n - k) / (k + 1);
  }
  return {std::max(k - 1, 0), std::min(n - k, n - 1)};
}

void run_survive(const SurviveOptions& options) {
  constexpr auto kText = Table::Align::left;
  Table table("`" + options.algorithm + "`, " + std::to_string(options.train) +
                  " iterations before the change; then steps until a cut tour is within " +
                  short_number(100 * options.within) + "% of the optimum, inf after " +
                  short_number(options.budget) + "; seed " + std::to_string(options.seed) + ".",
              {"map",
               {"change", kText},
               "optimum before",
               "after",
               "surviving, steps",
               "blank, steps",
               "ratio"},
              options.markdown);
  std::vector<double> ratios;
  for (int i = 0; i < options.worlds; ++i) {
    const Survival o = run_map(i, options);
    ratios.push_back(o.ratio());
    table.row({std::string(to_string(o.map.kind)) + " " + std::to_string(o.map.grid.width()),
               (o.blocks ? "block " : "open ") + size_text(o.map.part.width, o.map.part.height),
               short_number(o.before), short_number(o.after), short_number(o.surviving),
               short_number(o.blank), short_number(ratios.back())});
  }
  std::ranges::sort(ratios);
  const auto [low, high] = median_ranks(options.worlds);
  const auto worse = std::ranges::count_if(ratios, [](double r) { return r > 1; });
  table.close("Ratio, median " + short_number(median(ratios)) + " [" + short_number(ratios[low]) +
              ", " + short_number(ratios[high]) + "] (order statistics, 95%); worse on " +
              std::to_string(worse) + " of " + std::to_string(options.worlds) +
              ". Aim: at most 0.5, worse on at most 3.");
}

}  // namespace

void add_survive_command(CLI::App& app) {
  const auto [command, options] = add_command(
      app, "survive", "What a trail that survives a change of the map saves a colony", run_survive);
  add_number(command, "--worlds", options.worlds, "Generated worlds", 1, 10000);
  add_number(command, "--seed", options.seed, "Of worlds and ants", 1, 1e9);
  command.add_option("--algorithm", options.algorithm, "The colony")->capture_default_str();
  add_number(command, "--train", options.train, "Iterations before the change", 1, 1e6);
  add_number(command, "--budget", options.budget, "Steps after the change", 1, 1e12);
  add_number(command, "--within", options.within, "Of the optimum, as a fraction", 0, 10);
}

}  // namespace lasius::bench
