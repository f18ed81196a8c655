// Values on the command line and in files, read strictly: all of the text, or an error.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/grid/geometry.h"

namespace lasius::tool {

/// The largest integer that every JSON reader keeps exactly, and so the largest seed: 2^53 - 1.
inline constexpr std::int64_t kMaxExactInteger = (std::int64_t{1} << 53) - 1;

/// An upper bound for numbers that have none.
inline constexpr double kNoLimit = std::numeric_limits<double>::max();

/// All of `text` as a number, or nothing. Reals are finite.
std::optional<std::int64_t> parse_integer(std::string_view text);
std::optional<double> parse_real(std::string_view text);

/// A whole number of any number of digits, as near as a double comes.
std::optional<double> parse_whole(std::string_view text);

/// "N": 1 to N; "A..B" or "A-B": A to B. Nothing for other texts, or where A is beyond B.
std::optional<std::pair<std::int64_t, std::int64_t>> parse_range(std::string_view text);

/// The same for an option's value. @throws UsageError naming option, value and range.
std::int64_t integer_value(std::string_view option, std::string_view text, std::int64_t low,
                           std::int64_t high);
double real_value(std::string_view option, std::string_view text, double low, double high);

/// The parameter that a word sets: "evaporation" is 1 less persistence, others are their own.
template <class Text>
Text parameter_meant_by(Text word) {
  return word == "evaporation" ? Text("persistence") : word;
}

/// The parts of a text between `at`: one more than there are of these.
std::vector<std::string_view> split(std::string_view text, char at);

/// Index of `text` in `known`. @throws UsageError naming the nearest known value.
std::size_t choice_value(std::string_view option, std::string_view text,
                         std::span<const std::string_view> known);

/// "X,Y": whole numbers where `whole`, else finite ones. @throws UsageError.
Point pair_value(std::string_view option, std::string_view text, bool whole);

/// Has a coordinate a decimal point or an exponent, which makes it one of a point and not a cell?
inline bool is_point(std::string_view coordinates) {
  return coordinates.find_first_of(".eE") != std::string_view::npos;
}

/// "WxH". @throws UsageError.
Cell size_value(std::string_view option, std::string_view text);

/// "a,b,c": at most 20 whole numbers from 1, in rising order without repeats. @throws UsageError.
std::vector<int> list_value(std::string_view option, std::string_view text);

/// "a,b,c": `least` to `most` finite numbers. @throws UsageError.
std::vector<double> reals_value(std::string_view option, std::string_view text, std::size_t least,
                                std::size_t most);

/// The shortest text that reads back as the same number.
std::string to_text(double value);
/// The same; empty where the value is not finite.
std::string finite_text(double value);

/// The same of a whole number, in digits where they are exact.
std::string whole_text(double value);

/// A number that every YAML reader takes for a real one: with a point, also before an exponent.
std::string yaml_real(double value);

/// The shortest text of a number rounded to so many decimals, downwards where `down`.
std::string rounded_text(double value, int decimals, bool down = false);

/// A number with so many decimals; the shortest text where it has too many digits before them.
std::string decimal_text(double value, int decimals);

/// What printf would print.
[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...);

/// A line of a table: the name in a column of its own, then the value.
std::string row_text(std::string_view name, const std::string& value);

/// A character and what stands in its place.
using Escape = std::pair<char, std::string_view>;
std::string with_escapes(std::string_view text, std::span<const Escape> escapes);

/// A field of CSV: in quotes where it needs them.
std::string csv_field(const std::string& text);

/// The last part of a file's path.
std::string file_name(const std::string& path);

/// "1 joint", "2 joints".
std::string counted(std::int64_t count, std::string_view thing);

}  // namespace lasius::tool
