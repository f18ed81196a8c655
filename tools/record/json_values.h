// What results hold beside the library's JSON: gaps to an optimum, hashes, ranges.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/io/json_values.h"

namespace lasius::tool {

using namespace json;

/// (length - optimum) / optimum; 0 at length 0; nothing where either is missing.
std::optional<double> gap_to(const std::optional<double>& optimum, double length);

/// Type and range of a parameter: {"type", "minimum", "maximum"} or {"type", "values"}.
Json range_json(const Parameter& parameter);

/// The hash as results give it: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

/// FNV-1a over bytes, from the hash before.
std::uint64_t bytes_hash(std::string_view bytes, std::uint64_t hash = 0xcbf29ce484222325) noexcept;

/// The same of the bytes of a file that was just read; of a pipe, which can be read but
/// once, that of nothing. Of several files, one behind another: each from the hash before.
std::uint64_t file_hash(const std::string& file, std::uint64_t hash = 0xcbf29ce484222325);

}  // namespace lasius::tool
