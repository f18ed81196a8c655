// Results as JSON, CSV and plain text.
#pragma once

#include <string>

#include "answer.h"
#include "json_values.h"
#include "map_file.h"
#include "options.h"

namespace lasius::tool {

inline constexpr const char* kFormat = "lasius-plan/1";
inline constexpr const char* kArmFormat = "lasius-arm-plan/1";

/// How the search went: iterations, curves, bound and gap.
void add_search(Json& json, const Result& result);

/// One result, keys in the order of the contract, on one line where dumped.
Json result_json(const PreparedMap& map, const RunOptions& run, const Answer& answer);

/// Status, length and path, one vertex a line; in metres in the world frame.
std::string result_text(const PreparedMap& map, const RunOptions& run, const Answer& answer);

/// What --gap found, for people; empty without an optimum.
std::string gap_text(const Answer& answer);

/// A batch as a table: header, and a line a query.
std::string batch_csv_header();
std::string batch_csv_row(const Answer& answer, Frame frame);

/// The convergence by iteration, or the path for algorithms without iterations.
std::string result_csv(const Result& result);

}  // namespace lasius::tool
