// A run as a value, whatever the kind of problem, and what is written of it.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/params/params.h"
#include "lasius/plan/search_result.h"
#include "tools/options/options.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

inline constexpr const char* kPlanFormat = "lasius-plan/1";
inline constexpr const char* kArmFormat = "lasius-arm-plan/1";
inline constexpr const char* kDriveFormat = "lasius-drive/1";

/// What was asked, what came of it, and how it is shown.
struct Record {
  const SearchOptions& options;
  const Algorithm& algorithm;
  const char* format = kPlanFormat;
  std::optional<std::size_t> index = {};             ///< of a query of a batch
  std::uint64_t seed = options.seed;                 ///< of this run
  std::optional<std::int64_t> most_iterations = {};  ///< nothing: it has none
  Json inputs = {};                                  ///< files by role, each with its name and hash
  Json start = {}, goal = {};
  Json parameters = {};  ///< all that decides the result

  SearchResult result = {};
  std::optional<double> gap = result.gap();  ///< certified
  std::optional<double> cost = {};           ///< over costs, NaN without a path: the bound's
  std::string error = result.error;
  std::optional<double> optimum = {};  ///< found for --gap
  Json answer = {};                    ///< what came of it, from "length" on
  double elapsed_ms = 0;
  bool arrived = true;       ///< of a path that there is: it is what was asked for
  std::string reached = {};  ///< how far a run came that something ended; empty: see explain

  std::string unit = {};          ///< of lengths; empty: cells, or the world's
  double scale = 1;               ///< how many units a length of the result's is
  std::vector<double> path = {};  ///< as it is shown, point by point
  struct Other {
    double length;             ///< as the result's
    std::vector<double> path;  ///< as `path`
  };
  std::vector<Other> others = {};         ///< ways beside it
  std::size_t axes = 2;                   ///< numbers a point
  std::vector<std::size_t> parts = {};    ///< points at which another path begins
  std::vector<std::string> remarks = {};  ///< what else people are to know

  bool has_path() const;
  bool found() const { return has_path() && arrived; }
};

/// Record::most_iterations, where the parameters say so many.
std::optional<std::int64_t> most_iterations(const Algorithm& algorithm, std::int64_t asked);

/// Coordinates as Record::path has them.
std::vector<double> coordinates(const std::vector<Point>& points);

/// All parameters of an algorithm by name, as they were asked for.
Json parameters_json(const Algorithm& algorithm, const SearchOptions& options);
/// Of the parameters: what ends a run.
void add_limits(Json& json, const SearchOptions& options);

/// True where the JSON of a result is asked for, which may be large.
bool wants_json(const SearchOptions& options);

/// An answer's keys in the order of the contract, with those of a kind: "path" and what goes with
/// it; what the search took; what else was found.
Json answer_json(const Record& run, Json path, Json effort = Json::object(),
                 Json findings = Json::object());

/// A result, keys in the order of the contract; and as a line of text.
Json result_json(Record run);
std::string json_line(Record run);

/// Status, length and path, a point a line; of other ways an empty line, length and path.
std::string plain_text(const Record& run);
/// The convergence by iteration; the path of algorithms without iterations.
void write_csv(std::ostream& out, const Record& run);

int exit_code(const Record& run);
/// One sentence for people: why a run has no path, or is not final; empty for `solved`.
std::string explain(const Record& run);
/// "best 12.345 m", or that there is no path yet. A length as it is shown; not finite: none.
std::string best_text(double length, const std::string& unit);
/// What -v says of what plans, and from which seed; with its threads where they matter.
std::string algorithm_text(const SearchOptions& options, const Algorithm& algorithm,
                           bool with_threads);

}  // namespace lasius::tool
