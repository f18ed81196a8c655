// Results as JSON, CSV and plain text.
#pragma once

#include <string>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/options/options.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

inline constexpr const char* kFormat = "lasius-plan/1";
inline constexpr const char* kArmFormat = "lasius-arm-plan/1";

/// How the search went: iterations, curves, bound and gap.
void add_search(Json& json, const SearchResult& result);

/// One result, keys in the order of the contract, on one line where dumped.
Json result_json(const PreparedMap& map, const RunOptions& run, const Answer& answer);

/// A result with lengths and path as `frame` gives them: in cells, or in metres of the map's frame.
Result in_frame(const PreparedMap& map, Frame frame, const Result& result);

/// Status, length and path, one vertex a line; in metres in the world frame.
std::string result_text(const PreparedMap& map, const RunOptions& run, const Answer& answer);

/// What --gap found, for people; empty without an optimum.
std::string gap_text(const PreparedMap& map, const RunOptions& run, const Answer& answer);

/// A batch as a table: header, and a line a query. Columns in metres end in _m.
std::string batch_csv_header(Frame frame);
std::string batch_csv_row(const PreparedMap& map, Frame frame, const Answer& answer);

/// The convergence by iteration, or the path for algorithms without iterations, of a result that is
/// in `frame`. Columns in metres end in _m.
std::string result_csv(const SearchResult& result, const std::vector<Point>& path, bool iterates,
                       Frame frame);

}  // namespace lasius::tool
