#include "tools/console/values.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <filesystem>

#include "core/base/did_you_mean.h"
#include "core/base/number_text.h"
#include "tools/console/exit_code.h"

namespace lasius::tool {
namespace {

UsageError bad_value(std::string_view option, std::string_view text, const std::string& wanted) {
  return UsageError(std::string(option) + ": \"" + std::string(text) + "\" is not " + wanted);
}

}  // namespace

std::optional<std::int64_t> parse_integer(std::string_view text) {
  return number_of<std::int64_t>(text);
}

std::optional<double> parse_real(std::string_view text) {
  const auto value = number_of<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> parse_whole(std::string_view text) {
  if (const auto integer = parse_integer(text)) return static_cast<double>(*integer);
  const bool negative = text.starts_with('-');
  const auto digits = text.substr(negative ? 1 : 0);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  return parse_real(text).value_or(negative ? -kNoLimit : kNoLimit);
}

std::optional<std::pair<std::int64_t, std::int64_t>> parse_range(std::string_view text) {
  const auto dots = text.find("..");
  const auto between = dots == std::string_view::npos ? text.find('-', 1) : dots;
  const bool alone = between == std::string_view::npos;
  const auto first = alone ? 1 : parse_integer(text.substr(0, between));
  const auto last =
      parse_integer(alone ? text : text.substr(between + (dots == std::string_view::npos ? 1 : 2)));
  if (!first || !last || *first > *last) return std::nullopt;
  return std::pair{*first, *last};
}

std::int64_t integer_value(std::string_view option, std::string_view text, std::int64_t low,
                           std::int64_t high) {
  const auto value = parse_integer(text);
  if (!value || *value < low || *value > high)
    throw bad_value(option, text,
                    "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return *value;
}

double real_value(std::string_view option, std::string_view text, double low, double high) {
  const auto value = parse_real(text);
  if (value && *value >= low && *value <= high) return *value + 0.0;  // -0 is 0
  std::string wanted = "a number from " + to_text(low);
  wanted += high < kNoLimit ? " to " + to_text(high) : " up";
  throw bad_value(option, text, wanted);
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const auto to = std::min(text.find(at, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

std::size_t choice_value(std::string_view option, std::string_view text,
                         std::span<const std::string_view> known) {
  const auto found = std::find(known.begin(), known.end(), text);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  std::string wanted;
  for (const auto name : known) wanted.append(wanted.empty() ? "" : "|").append(name);
  if (nearest_name(text, known)) wanted.append("; ").append(did_you_mean(text, known));
  throw bad_value(option, text, wanted);
}

Point pair_value(std::string_view option, std::string_view text, bool whole) {
  const auto comma = text.find(',');
  if (comma != std::string_view::npos) {
    const auto x_text = text.substr(0, comma), y_text = text.substr(comma + 1);
    if (whole) {
      const auto x = parse_whole(x_text), y = parse_whole(y_text);
      if (x && y) return {*x, *y};
    } else {
      const auto x = parse_real(x_text), y = parse_real(y_text);
      if (x && y) return {*x, *y};
    }
  }
  throw bad_value(option, text,
                  whole ? "a cell X,Y (column and row, whole numbers, no blanks)"
                        : "a point X,Y (two numbers, no blanks)");
}

Cell size_value(std::string_view option, std::string_view text) {
  const auto cross = text.find('x');
  if (cross != std::string_view::npos) {
    const auto width = number_of<int>(text.substr(0, cross));
    const auto height = number_of<int>(text.substr(cross + 1));
    if (width && height) return {*width, *height};
  }
  throw bad_value(option, text, "a size WxH, as in 400x200");
}

std::vector<int> list_value(std::string_view option, std::string_view text) {
  const auto parts = split(text, ',');
  std::vector<int> values;
  for (const auto part : parts)
    if (const auto value = number_of<int>(part); value && *value >= 1) values.push_back(*value);
  constexpr std::size_t kMost = 20;
  if (values.size() < parts.size() || values.size() > kMost)
    throw bad_value(option, text, "a list of 1 to 20 whole numbers from 1, as in 10,50");
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::vector<double> reals_value(std::string_view option, std::string_view text, std::size_t least,
                                std::size_t most) {
  const auto parts = split(text, ',');
  std::vector<double> values;
  for (const auto part : parts)
    if (const auto value = parse_real(part)) values.push_back(*value);
  const bool good = values.size() == parts.size();
  if (good && values.size() >= least && values.size() <= most) return values;
  std::string count = std::to_string(least);
  if (most > least) count += " to " + std::to_string(most);
  throw bad_value(option, text, "a list of " + count + " numbers, commas between them, no blanks");
}

std::string to_text(double value) { return number_text(value); }

std::string finite_text(double value) { return std::isfinite(value) ? to_text(value) : ""; }

std::string yaml_real(double value) {
  std::string text = to_text(value);
  if (text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string whole_text(double value) {
  return std::abs(value) <= static_cast<double>(kMaxExactInteger)
             ? std::to_string(static_cast<std::int64_t>(value))
             : to_text(value);
}

std::string rounded_text(double value, int decimals, bool down) {
  const double scale = std::pow(10.0, decimals), scaled = value * scale;
  double rounded = (down ? std::floor(scaled) : std::round(scaled)) / scale;
  if (down && rounded > value) rounded = (std::floor(scaled) - 1) / scale;
  return to_text(std::isfinite(rounded) ? rounded : value);
}

std::string decimal_text(double value, int decimals) {
  constexpr double kMost = 1e100;  // results of 0.1.0 hold messages with nearly as many digits
  return std::abs(value) < kMost ? printed("%.*f", decimals, value) : to_text(value);
}

std::string printed(const char* format, ...) {
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  std::string text(std::max(0, std::vsnprintf(nullptr, 0, format, values)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  va_end(values);
  return text;
}

std::string row_text(std::string_view name, const std::string& value) {
  return printed("%-12.*s", static_cast<int>(name.size()), name.data()) + value + "\n";
}

std::string with_escapes(std::string_view text, std::span<const Escape> escapes) {
  std::string out;
  for (const char c : text) {
    const auto known = std::ranges::find(escapes, c, &Escape::first);
    if (known == escapes.end())
      out += c;
    else
      out += known->second;
  }
  return out;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  constexpr Escape kQuote[] = {{'"', "\"\""}};
  return '"' + with_escapes(text, kQuote) + '"';
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string counted(std::int64_t count, std::string_view thing) {
  std::string text = std::to_string(count);
  text.append(" ").append(thing);
  return count == 1 ? text : text.append("s");
}

}  // namespace lasius::tool
