// lasius_bench nav2: plans over costs between all nodes of Nav2's depot.
#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/pose_pairs.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/special_values.h"
#include "core/io/grey_image.h"
#include "lasius/base/error.h"
#include "lasius/cost/planner.h"
#include "lasius/io.h"

namespace lasius::bench {
namespace {

struct Nav2Options : Reported {
  std::string folder;
  double target_gap = 1;            // %
  double radius = 0;                // m
  double reach = 0.7, scaling = 3;  // of inflation: m, 1/m
  double speed = 3;                 // factor of the speed mask
  std::size_t slowest = 3;
};

/// A map with its weights, and places on it in cells.
struct Depot {
  Grid grid;
  CostField costs;
  double resolution;
  std::vector<Point> nodes = {};
};

/// Adds the occupancy of a mask as large as the map, over 100, and blocks its cells of 100.
void add_mask(const std::string& file, double factor, Depot& depot) {
  const OccupancyImage mask = read_occupancy(file);
  if (mask.width != depot.grid.width() || mask.height != depot.grid.height())
    throw Error(ErrorCode::file_broken, {.file = file}, "its size is not the map's",
                "take the masks of that map");
  std::vector<double> values;
  values.reserve(mask.levels.size());
  for (std::size_t i = 0; i < mask.levels.size(); ++i) {
    const int x = static_cast<int>(i) % mask.width, y = static_cast<int>(i) / mask.width;
    if (mask.levels[i] == 100) depot.grid.set_blocked({x, y});
    values.push_back(mask.levels[i] == OccupancyImage::kUnknown ? 0 : mask.levels[i] / 100.0);
  }
  depot.costs.add(values, factor);
}

Depot load_depot(const Nav2Options& options) {
  const std::string base = options.folder + "/depot";
  const Map map = read_any_map(base + ".yaml");
  const double cell = map.frame->resolution;
  Depot depot{map.grid, CostField(map.grid.width(), map.grid.height()), cell};
  add_mask(base + "_keepout.yaml", 1, depot);
  add_mask(base + "_speed.yaml", options.speed, depot);
  depot.costs.add(depot.grid, Inflation{.radius = options.reach / cell,
                                        .scaling = options.scaling * cell,
                                        .weight = 2,
                                        .inscribed = std::max(1.0, options.radius / cell)});
  depot.nodes = nodes_of_graph(base + "_graph.geojson", *map.frame, depot.grid.height());
  return depot;
}

struct PairOfNodes {
  double milliseconds = 0;
  std::string name = {};  // "from-to"
};

struct Nav2Figures {
  std::vector<PairOfNodes> answered = {};
  std::vector<double> gaps = {};  // %
  std::string without = {};
};

Nav2Figures plan_all(const Depot& depot, const Nav2Options& options) {
  const Planner planner(depot.grid, Disc{options.radius / depot.resolution});
  const CostPlanner costs(planner, depot.costs);
  const auto cell = [](Point at) { return Cell{static_cast<int>(at.x), static_cast<int>(at.y)}; };
  Nav2Figures figures;
  for (std::size_t from = 0; from < depot.nodes.size(); ++from) {
    for (std::size_t to = from + 1; to < depot.nodes.size(); ++to) {
      const Point a = depot.nodes[from], b = depot.nodes[to];
      const Request request{.start = cell(a),
                            .goal = cell(b),
                            .target_gap = options.target_gap / 100,
                            .start_point = a,
                            .goal_point = b};
      const ThreadStopwatch watch;
      const CostResult found = costs.plan(request);
      const double milliseconds = 1e3 * watch.seconds();
      const std::string name = std::to_string(from) + '-' + std::to_string(to);
      if (found.path.empty()) {
        figures.without += (figures.without.empty() ? "" : " ") + name;
        continue;
      }
      figures.answered.push_back({milliseconds, name});
      figures.gaps.push_back(100 * found.gap().value_or(kInfinity));
    }
  }
  return figures;
}

void run_nav2(const Nav2Options& options) {
  const Depot depot = load_depot(options);
  Table table = Table::of_figures("Nav2's depot, " + std::to_string(depot.nodes.size()) +
                                      " nodes; processor time of one thread.",
                                  options.markdown);
  Nav2Figures figures = plan_all(depot, options);
  auto& answered = figures.answered;
  const std::size_t pairs = depot.nodes.size() * (depot.nodes.size() - 1) / 2;
  std::string text = "No path: " + (figures.without.empty() ? "none" : figures.without) + '.';
  if (!answered.empty()) {
    std::vector<double> times;
    for (const PairOfNodes& pair : answered) times.push_back(pair.milliseconds);
    const auto met = std::ranges::count_if(
        figures.gaps, [&](double gap) { return gap <= options.target_gap * (1 + 1e-9); });
    table.add({{"answered", std::to_string(answered.size()) + " of " + std::to_string(pairs), ""},
               {"gap met", std::to_string(met), "all"},
               {"ms, median", short_number(median(times)), "50"},
               {"ms, 90%", short_number(quantile(times, 0.9)), ""},
               {"ms, worst", short_number(largest(times)), "300"}});
    std::ranges::sort(answered, std::greater<>(), &PairOfNodes::milliseconds);
    text += " Slowest, ms:";
    for (const PairOfNodes& pair :
         std::span(answered).first(std::min(options.slowest, answered.size())))
      text += ' ' + pair.name + ' ' + short_number(pair.milliseconds);
  }
  table.close(text);
}

}  // namespace

void add_nav2_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "nav2", "Paths over costs between the nodes of Nav2's depot", run_nav2);
  command.add_option("folder", options.folder, "Folder with depot.yaml, its masks and its graph")
      ->required()
      ->check(CLI::ExistingDirectory);
  add_number(command, "--target-gap", options.target_gap, "Gap to end at, percent");
  add_number(command, "--radius", options.radius, "Radius of the robot, metres; 0: a point");
  add_number(command, "--inflation", options.reach, "Inflation radius, metres");
  add_number(command, "--scaling", options.scaling, "Scaling of the inflation");
  add_number(command, "--speed", options.speed, "Factor of the speed mask");
  add_number(command, "--slowest", options.slowest, "Slowest pairs to name");
}

}  // namespace lasius::bench
