// lasius_bench costs: paths over weights, how soon and how good, against planners that are in use.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/cost_queries.h"
#include "bench/peers/bucket_astar.h"
#include "bench/peers/cost_peers.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/cost/cost_search.h"

namespace lasius::bench {
namespace {

constexpr double kProvenGaps[] = {0.01, 0.001, 0.0007};
constexpr double kRounding = 1e-9;

struct CostsOptions : Reported {
  MapOptions maps;
  std::vector<std::string> weights = kWeightKinds;
  std::size_t count = 6;
  int rounds = 3;
  bool no_peers = false;
};

/// Measurements of many queries; a query that never comes to a gap has an infinite time there.
struct CostSample {
  std::vector<double> first, above;                 // s, %
  std::vector<double> gap[std::size(kProvenGaps)];  // s
  std::vector<double> moves, ratio;                 // ms, to plain A* in buckets
};

struct CostPeerSample {
  std::vector<double> times, dearer;  // ms, % above our path
  int without = 0, cheaper = 0;
};

struct CostFigures {
  std::map<int, CostSample> by_side;
  std::map<std::string, CostPeerSample> peers;
  int queries = 0, faults = 0;
};

std::string three(const std::vector<double>& values, double unit = 1) {
  return short_number(unit * median(values)) + " / " + short_number(unit * quantile(values, 0.9)) +
         " / " + short_number(unit * largest(values));
}

/// All that runs on one map and its weights, made ready.
class CostContest {
 public:
  CostContest(const Grid& grid, const CostField& field)
      : terrain_(grid, field), map_(grid, field), integral_(map_), plain_(grid) {
    peers_.emplace_back("8 moves, heap", peers::cost_heap_astar(map_));
    peers_.emplace_back("8 moves, buckets", peers::cost_bucket_astar(map_));
    peers_.emplace_back("Theta*", peers::cost_theta_star(map_));
    peers_.emplace_back("Field D*", peers::field_dstar(map_));
    peers_.emplace_back("fast marching", peers::fast_marching(map_));
  }

  void run(const Query& query, const CostsOptions& options, CostSample& sample,
           CostFigures& costs) {
    // Each gap is asked for by itself: a search makes use of what it need not prove.
    bool good = true;
    double ours = kInfinity, lower = 0;
    for (std::size_t i = 0; i < std::size(kProvenGaps); ++i) {
      cost::CostAnswer answer;
      const ThreadStopwatch watch;
      search_.search(terrain_, {query.start, query.goal}, {.target_gap = kProvenGaps[i]}, {},
                     answer);
      const double seconds = watch.seconds();
      const bool proven = answer.length - answer.lower_bound <= kProvenGaps[i] * answer.lower_bound;
      sample.gap[i].push_back(proven ? seconds : kInfinity);
      const double cost = integral_.of(answer.path);
      good = good && std::abs(cost - answer.length) <= kRounding * cost;
      ours = std::min(ours, cost);
      lower = std::max(lower, answer.lower_bound);
    }
    double best = ours;
    if (!options.no_peers) {
      const auto judge = [&](const std::string& name, double milliseconds,
                             const std::vector<Point>& path) {
        CostPeerSample& peer = costs.peers[name];
        peer.times.push_back(milliseconds);
        const double cost = path.empty() ? kInfinity : integral_.of(path);
        if (cost == kInfinity) {
          ++peer.without;
          return;
        }
        peer.dearer.push_back(100 * (cost / ours - 1));
        peer.cheaper += cost < ours * (1 - kRounding) ? 1 : 0;
        best = std::min(best, cost);
      };
      std::vector<Point> path;
      for (const auto& [name, planner] : peers_) {
        const ThreadStopwatch watch;
        planner->plan(query.start, query.goal, path);
        judge(name, 1e3 * watch.seconds(), path);
      }
      Poller poller(never_);
      const ThreadStopwatch watch;
      const auto walk =
          moves_.search(terrain_, query.start, query.goal, Corners::one_side, poller, false);
      cost::Polish polish(terrain_);
      path = polish.polish(centre(query.start), cost::legs_of(walk), poller);
      judge("8 moves, polished", 1e3 * watch.seconds(), path);
    }
    good = good && lower <= best * (1 + kRounding);
    costs.faults += good ? 0 : 1;
    ++costs.queries;
    const auto& levels = search_.levels();
    sample.first.push_back(levels.front().seconds);
    sample.above.push_back(100 * std::max(0.0, levels.front().upper / best - 1));
    time_moves(query, options.rounds, sample);
  }

 private:
  void time_moves(const Query& query, int rounds, CostSample& sample) {
    std::vector<Point> path;
    const double plain =
        median_microseconds(rounds, [&] { plain_.plan(query.start, query.goal, path); });
    const double weighted = median_microseconds(rounds, [&] {
      Poller poller(never_);
      moves_.search(terrain_, query.start, query.goal, Corners::forbid, poller, false);
    });
    sample.moves.push_back(weighted / 1000);
    sample.ratio.push_back(weighted / plain);
  }

  cost::Terrain terrain_;
  peers::WeightedMap map_;
  peers::PathIntegral integral_;
  peers::BucketAStar plain_;
  std::vector<std::pair<std::string, std::unique_ptr<peers::QueryPlanner>>> peers_;
  StopCondition never_;
  cost::EightMoves moves_;
  cost::CostSearch search_;
};

void append(const CostSample& from, CostSample& to) {
  const auto add = [](const std::vector<double>& values, std::vector<double>& all) {
    all.insert(all.end(), values.begin(), values.end());
  };
  add(from.first, to.first);
  add(from.above, to.above);
  for (std::size_t i = 0; i < std::size(kProvenGaps); ++i) add(from.gap[i], to.gap[i]);
  add(from.moves, to.moves);
  add(from.ratio, to.ratio);
}

std::vector<std::string> row_of(const std::string& name, const CostSample& sample) {
  return {name,
          std::to_string(sample.first.size()),
          three(sample.first, 1e3),
          three(sample.above),
          three(sample.gap[0], 1e3),
          three(sample.gap[1], 1e3),
          three(sample.gap[2], 1e3),
          three(sample.moves),
          three(sample.ratio)};
}

void write_peers(const std::string& text, const CostFigures& costs, Table& table) {
  table.next(text,
             {"peer", "ms", "no path", "% dearer than ours, mean", "worst", "cheaper than ours"});
  for (const auto& [name, peer] : costs.peers) {
    double sum = 0;
    for (const double dearer : peer.dearer) sum += dearer;
    const bool any = !peer.dearer.empty();
    table.row({name, three(peer.times), std::to_string(peer.without),
               any ? short_number(sum / static_cast<double>(peer.dearer.size())) : "",
               any ? short_number(largest(peer.dearer)) : "", std::to_string(peer.cheaper)});
  }
  table.close("");
}

void run_costs(const CostsOptions& options) {
  const MapOptions maps = or_generated(options.maps, {512, 256}, {"blobs"});
  Table table("Paths over weights, " + std::to_string(options.count) +
                  " long queries a map and kind of weight, seed " +
                  std::to_string(options.maps.seed) +
                  "; median / 90% / worst; milliseconds of processor time of one thread.",
              {"map, weights", "queries", "first answer", "above the best, %", "gap 1%", "gap 0.1%",
               "gap 0.07%", "8 moves", "/ plain A*"},
              options.markdown);
  CostFigures costs;
  for (const QuerySource& source : sources_of(maps, {options.markdown})) {
    const Grid grid = load(source, 1).grid;
    const auto queries = long_queries(grid, options.count, options.maps.seed);
    for (const std::string& kind : options.weights) {
      CostContest contest(grid, make_weights(grid, kind));
      CostSample sample;
      for (const Query& query : queries) contest.run(query, options, sample, costs);
      table.row(row_of(source.name + ' ' + kind, sample));
      append(sample, costs.by_side[std::max(grid.width(), grid.height())]);
    }
  }
  for (const auto& [side, sample] : costs.by_side)
    table.row(row_of("all of side " + std::to_string(side), sample));
  const std::string faults =
      "Answers whose cost the judge does not confirm, or whose bound is above a path's cost: " +
      std::to_string(costs.faults) + " of " + std::to_string(costs.queries) + ".";
  if (options.no_peers)
    table.close(faults);
  else
    write_peers(faults, costs, table);
  if (costs.faults > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_costs_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "costs", "Paths over weights, with peers", run_costs);
  add_map_options(command, options.maps);
  command.add_option("--weights", options.weights, "Kinds of weight")
      ->delimiter(',')
      ->check(CLI::IsMember(kWeightKinds));
  add_number(command, "--queries", options.count, "Queries a map and kind of weight", 1);
  add_number(command, "--rounds", options.rounds, "Rounds of each query by 8 moves", 1, 1000);
  command.add_flag("--no-peers", options.no_peers, "Without the peers' paths");
}

}  // namespace lasius::bench
