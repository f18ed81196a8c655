// Numbers, points and parameters as JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/geometry.h"
#include "lasius/params.h"

namespace lasius::tool {

using Json = nlohmann::ordered_json;

/// The number, or null where it is missing or not finite.
Json number(double value);
Json optional_number(const std::optional<double>& value);
Json numbers(const std::vector<double>& values);

/// [x, y], and a list of such; null for no points.
Json point(Point p);
Json points(const std::vector<Point>& path);

/// (length - optimum) / optimum; 0 at length 0; null where either is missing.
Json gap_to(const std::optional<double>& optimum, double length);

/// The text of a parameter as JSON: a number where it is one, else a string. And back.
Json parameter_json(const std::string& text);
std::string parameter_text(const Json& value);

/// All parameters of an algorithm by name; `text` gives the value of a name.
Json parameters_json(const Algorithm& algorithm,
                     const std::function<std::string(std::string_view name)>& text);

/// Type and range of a parameter: {"type", "minimum", "maximum"} or {"type", "values"}.
Json range_json(const Parameter& parameter);

/// The hash as results give it: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

/// @throws Error(file_broken) with this remedy where a file's hash is not the one that a result
/// records.
void check_hash(const std::string& file, std::uint64_t hash, const std::string& recorded,
                const char* remedy);

/// A value on one line; text that is not UTF-8 has its bad bytes replaced.
std::string line(const Json& value);

}  // namespace lasius::tool
