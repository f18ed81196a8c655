// JSON as text, read and written in one file of the library: nlohmann's parser and writer are
// templates that take seconds to compile.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace lasius {

/// JsonPlace::parse: the document. @throws Error(file_broken) naming line and byte of `file`.
nlohmann::json read_json(std::string_view text, const std::string& file);
/// JsonPlace::line: where the value at `path` begins.
std::int64_t json_line(std::string_view text, std::string_view path);
/// A value on one line; bytes that are no UTF-8 are replaced.
std::string json_text(const nlohmann::json& value);

}  // namespace lasius
