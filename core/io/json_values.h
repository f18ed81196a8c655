// Numbers, points, parameters and results as JSON: what the library and the program share.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/io_export.h"
#include "lasius/params/params.h"
#include "lasius/plan/search_result.h"

namespace lasius::json {

using Json = nlohmann::ordered_json;

/// The number, or null where it is missing or not finite.
LASIUS_IO_EXPORT Json number(double value);
LASIUS_IO_EXPORT Json optional_number(const std::optional<double>& value);
LASIUS_IO_EXPORT Json numbers(const std::vector<double>& values);

/// [x, y], and a list of such; null for no points.
LASIUS_IO_EXPORT Json point(Point p);
LASIUS_IO_EXPORT Json points(const std::vector<Point>& path);

/// An empty object with room for the members of an answer: one that grows copies all that it has,
/// paths among them.
LASIUS_IO_EXPORT Json roomy_object();
/// Moves the members of an object to the end of another, over those of the same names.
LASIUS_IO_EXPORT void append(Json& to, Json&& members);

/// The text, or null where it is empty.
LASIUS_IO_EXPORT Json text_or_null(const std::string& text);

/// The text of a parameter as JSON: a number where it is one, else a string. And back.
LASIUS_IO_EXPORT Json parameter(const std::string& text);
LASIUS_IO_EXPORT std::string parameter_text(const Json& value);

/// All parameters of an algorithm by name; `text` gives the value of a name.
LASIUS_IO_EXPORT Json parameters(const Algorithm& algorithm,
                                 const std::function<std::string(std::string_view name)>& text);

/// How the search went: iterations and curves; and what it proved: bound, gap, optimal.
LASIUS_IO_EXPORT void add_convergence(Json& json, const Convergence& run);
LASIUS_IO_EXPORT void add_proof(Json& json, const SearchResult& result);

/// The document that begins at byte `from` of a file's text. @throws Error(file_broken) naming line
/// and byte of `file`, by the rule of all our files (core/base/json_place.h).
LASIUS_IO_EXPORT Json read(std::string_view text, const std::string& file, std::size_t from = 0);
/// Likewise of CBOR (RFC 8949), one object in all of `bytes`; typed arrays are binary values with
/// their tag.
LASIUS_IO_EXPORT Json read_cbor(std::string_view bytes, const std::string& file);
LASIUS_IO_EXPORT std::string cbor(const Json& value);
/// A value as text, in which bytes that are no UTF-8 are replaced: names of files hold what they
/// like. The writer is compiled here alone, since that takes long; the parser, too.
LASIUS_IO_EXPORT std::string dumped(const Json& value);
/// dumped() with a line end behind it.
LASIUS_IO_EXPORT std::string line(const Json& value);

}  // namespace lasius::json
