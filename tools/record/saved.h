// Saved results, one or several in a file.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/json_values.h"

namespace lasius::tool {

/// A result, and the byte of its file at which it begins.
struct Saved {
  json::Json json;
  std::int64_t offset;
};

/// The objects of a file: one result, or one a line, or none.
/// @throws Error(file_missing, file_broken)
std::vector<Saved> read_results(const std::string& file);

/// A result among several, counted from 0, as messages name it.
std::string nth_result(const std::string& file, std::size_t i);

}  // namespace lasius::tool
