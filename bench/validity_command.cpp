// lasius_bench validity: every path of the colonies is checked, over many maps, by a rule that
// shares no code with the library.
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/output.h"
#include "lasius/base/error.h"
#include "lasius/grid/map_io.h"
#include "lasius/plan/planner.h"
#include "tests/oracle/whole_path.h"

namespace lasius::bench {
namespace {

namespace fs = std::filesystem;

struct ValidityOptions {
  std::vector<std::string> maps;
  std::vector<std::string> algorithms = {"fan2004", "as"};
  int random = 1000;
  int side = 256;
  int iterations = 3;
  int ants = 4;
  std::uint64_t seed = 1;
  std::string write;  // a folder for the answers
};

void write_text(const fs::path& file, const auto& write) {
  write_file(file.string(), [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    write(out);
  });
}

/// Writes into one folder, for each map NAME:
///   NAME.map              the file that was read, byte for byte, or the generated map
///   NAME.tsv              sx sy gx gy euclid; the exact any-angle length of each query
///   NAME.ALGORITHM.jsonl  an object a query, in order: status, length, path as [x, y] in cells
class AnswerFiles {
 public:
  /// Makes the folder. @throws Error(output_failed) when it is there and not empty.
  explicit AnswerFiles(std::string folder);

  /// `optima` stands in where a query has no length of its own.
  void write_map(const QuerySource& source, const QuerySet& set,
                 std::span<const double> optima) const;
  void write_answers(const std::string& name, const std::string& algorithm,
                     std::span<const Result> answers) const;

 private:
  std::string folder_;
};

AnswerFiles::AnswerFiles(std::string folder) : folder_(std::move(folder)) {
  fs::create_directories(folder_);
  if (!fs::is_empty(folder_)) {
    throw Error(ErrorCode::output_failed, {folder_}, "not an empty folder", "name a new one");
  }
}

void AnswerFiles::write_map(const QuerySource& source, const QuerySet& set,
                            std::span<const double> optima) const {
  const std::string name = (fs::path(folder_) / set.name).string();
  if (source.map.empty()) {
    lasius::write_map(set.grid, name + ".map");
  } else {
    fs::copy_file(source.map, name + ".map");  // throws where another map has that name
  }
  write_text(name + ".tsv", [&](std::ostream& out) {
    out << "sx\tsy\tgx\tgy\teuclid\n";
    for (std::size_t i = 0; i < set.queries.size(); ++i) {
      const Query& q = set.queries[i];
      out << q.start.x << '\t' << q.start.y << '\t' << q.goal.x << '\t' << q.goal.y << '\t'
          << (std::isnan(q.optimum) ? optima[i] : q.optimum) << '\n';
    }
  });
}

void AnswerFiles::write_answers(const std::string& name, const std::string& algorithm,
                                std::span<const Result> answers) const {
  write_text(fs::path(folder_) / (name + "." + algorithm + ".jsonl"), [&](std::ostream& out) {
    for (const Result& answer : answers) {
      nlohmann::json path = nlohmann::json::array();
      for (const Point p : answer.path) path.push_back({p.x, p.y});
      out << nlohmann::json{{"status", to_string(answer.status)},
                            {"length", answer.length},
                            {"path", std::move(path)}}
          << '\n';
    }
  });
}

std::string fault_of(const Grid& grid, const Query& query, const Result& result) {
  if (result.path.empty()) return result.status == Status::solved ? "solved without a path" : "";
  if (!std::isnan(query.optimum) && result.length < query.optimum - 1e-6 * query.optimum)
    return "shorter than the optimum";
  return rule::path_fault(grid, result.path, centre(query.start), centre(query.goal),
                          result.length);
}

struct Tally {
  int paths = 0, faults = 0;
  std::map<std::string, int> unsolved;  // by status
  std::vector<double> gaps;             // of the others, to the any-angle optimum
  double seconds = 0;
};
using Tallies = std::map<std::string, Tally>;  // by algorithm

void check(const QuerySource& source, const QuerySet& set, const ValidityOptions& options,
           const AnswerFiles* files, Tallies& tallies) {
  const Planner planner(set.grid);
  Workspace workspace;
  std::vector<double> optima;
  for (const Query& query : set.queries) {
    optima.push_back(planner.plan({query.start, query.goal}, {}, {.workspace = &workspace}).length);
  }
  if (files) files->write_map(source, set, optima);
  for (const std::string& algorithm : options.algorithms) {
    Tally& tally = tallies[algorithm];
    Params params(algorithm);
    params.iterations = options.iterations;
    params.ants = options.ants;
    params.threads = 1;
    std::vector<Result> answers;
    const Stopwatch watch;
    for (const Query& query : set.queries) {
      params.seed = options.seed + answers.size();
      answers.push_back(planner.plan({query.start, query.goal}, params, {.workspace = &workspace}));
    }
    tally.seconds += watch.seconds();
    for (std::size_t q = 0; q < answers.size(); ++q) {
      const Result& result = answers[q];
      ++tally.paths;
      if (result.status != Status::solved) {
        ++tally.unsolved[std::string(to_string(result.status))];
      } else if (optima[q] > 0) {
        tally.gaps.push_back(result.length / optima[q] - 1);
      }
      const std::string fault = fault_of(set.grid, set.queries[q], result);
      if (fault.empty()) continue;
      ++tally.faults;
      std::cout << set.name << ", query " << q << ", " << algorithm << ": " << fault << '\n';
    }
    if (files) files->write_answers(set.name, algorithm, answers);
  }
}

int unsolved(const Tally& tally) {
  int sum = 0;
  for (const auto& [status, count] : tally.unsolved) sum += count;
  return sum;
}

/// A row of the table, paths and median gap by algorithm; adds the map to the sums.
void report(const std::string& map, const ValidityOptions& options, const Tallies& here,
            Tallies& sums, Table& table) {
  std::vector<std::string> cells{map};
  for (const std::string& algorithm : options.algorithms) {
    const Tally& tally = here.at(algorithm);
    cells.push_back(
        std::to_string(tally.paths - unsolved(tally)) + " of " + std::to_string(tally.paths) +
        (tally.gaps.empty() ? "" : ", " + short_number(100 * median(tally.gaps)) + "%"));
    Tally& sum = sums[algorithm];
    sum.paths += tally.paths;
    sum.faults += tally.faults;
    sum.seconds += tally.seconds;
    for (const auto& [status, count] : tally.unsolved) sum.unsolved[status] += count;
  }
  table.row(cells);
}

void run_validity(const ValidityOptions& given) {
  ValidityOptions options = given;
  if (options.algorithms == std::vector<std::string>{"all"}) {
    options.algorithms.clear();
    for (const Algorithm& a : algorithms()) options.algorithms.emplace_back(a.name);
  }
  std::optional<AnswerFiles> folder;
  if (!options.write.empty()) folder.emplace(options.write);
  const AnswerFiles* files = folder ? &*folder : nullptr;
  std::vector<Table::Column> columns{"map"};
  for (const std::string& algorithm : options.algorithms) columns.emplace_back(algorithm);
  Table table("Paths found and median gap to the any-angle optimum; " +
                  std::to_string(options.iterations) + " iterations of " +
                  std::to_string(options.ants) + " ants.",
              columns);

  Tallies tallies;
  for (const QuerySource& source : find_sources(options.maps)) {
    Tallies here;
    const QuerySet set = load(source, 0);
    check(source, set, options, files, here);
    report(set.name, options, here, tallies, table);
  }
  Tallies random;
  // Ten queries a map, the kinds in turn, a new seed each time around.
  for (int done = 0; done < options.random;) {
    const auto seed = options.seed + static_cast<std::uint64_t>(done);
    for (const QuerySource& source : generated_sources({options.side}, seed)) {
      if (done >= options.random) break;
      const auto count = std::min(10, options.random - done);
      QuerySet set = load(source, static_cast<std::size_t>(count));
      set.name.append("-").append(std::to_string(seed));
      check(source, set, options, files, random);
      done += count;
    }
  }
  if (!random.empty()) report("generated", options, random, tallies, table);
  std::cout << '\n';
  int faults = 0;
  for (const auto& [algorithm, tally] : tallies) {
    std::cout << algorithm << ": " << tally.paths << " queries, " << tally.faults << " faults";
    for (const auto& [status, count] : tally.unsolved) std::cout << ", " << count << ' ' << status;
    std::cout << ", " << tally.seconds << " s\n";
    faults += tally.faults;
  }
  if (faults != 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_validity_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "validity", "Checks every path of the colonies", run_validity);
  command.add_option("--maps", options.maps, "Folders or files, as for queries; all their queries");
  command.add_option("--algorithms", options.algorithms, "Which; all")
      ->delimiter(',')
      ->capture_default_str();
  add_number(command, "--random", options.random, "Queries on generated maps of all kinds");
  add_number(command, "--side", options.side, "Of generated maps");
  add_number(command, "--iterations", options.iterations, "Of each plan");
  add_number(command, "--ants", options.ants, "Of each iteration");
  add_number(command, "--seed", options.seed, "The first one");
  command.add_option("--write", options.write,
                     "A new folder for maps, queries and answers, for another checker");
}

}  // namespace lasius::bench
