// Numbers in messages and files.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace lasius {

/// The shortest text that reads back as the same number.
template <class Number>
std::string number_text(Number value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// A length in a sentence: to three decimals.
inline std::string rounded_text(double length) {
  const double rounded = std::round(1e3 * length) / 1e3;
  return number_text(rounded < 1e12 ? rounded : length);
}

/// The number that all of a text is; nothing where it is none or does not fit.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "(3, 4.5)": a cell, a point, a direction.
template <class Number>
std::string pair_text(Number x, Number y) {
  return '(' + number_text(x) + ", " + number_text(y) + ')';
}

/// "30 x 20".
inline std::string size_text(std::int64_t width, std::int64_t height) {
  return number_text(width) + " x " + number_text(height);
}

}  // namespace lasius
