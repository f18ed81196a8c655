// Results as JSON, CSV and plain text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "answer.h"
#include "map_file.h"
#include "options.h"

namespace lasius::tool {

using Json = nlohmann::ordered_json;

inline constexpr const char* kFormat = "lasius-plan/1";

/// The number, or null where it is not finite.
Json number(double value);

/// The text of a parameter as JSON: a number where it is one, else a string. And back.
Json parameter_json(const std::string& text);
std::string parameter_text(const Json& value);

/// The hash as results give it: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

/// One result, keys in the order of the contract, on one line where dumped.
Json result_json(const PreparedMap& map, const RunOptions& run, const Answer& answer);

/// A value on one line; text that is not UTF-8 has its bad bytes replaced.
std::string line(const Json& value);

/// Status, length and path, one vertex a line; in metres in the world frame.
std::string result_text(const PreparedMap& map, const RunOptions& run, const Answer& answer);

/// What --gap found, for people; empty without an optimum.
std::string gap_text(const Answer& answer);

/// A batch as a table: header, and a line a query.
std::string batch_csv_header();
std::string batch_csv_row(const Answer& answer);

/// Type and range of a parameter: {"type", "minimum", "maximum"} or {"type", "values"}.
Json range_json(const Parameter& parameter);

/// The convergence by iteration, or the path for algorithms without iterations.
std::string result_csv(const Result& result);

}  // namespace lasius::tool
