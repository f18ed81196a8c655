// What the C++ library of emscripten 3.1.6 lacks of C++20, as far as lasius uses it. Included
// before every file of the WebAssembly build, and of no other.
#pragma once

#ifdef __cplusplus

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <type_traits>

// Random123 refuses machines that are not on its list, and WebAssembly is not. It is told of one
// for which it has plain C alone; the headers that it includes are above.
#define __s390x__ 1
#include <Random123/features/compilerfeatures.h>
#undef __s390x__

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

template <class Array>
unique_ptr<Array> make_unique_for_overwrite(size_t count) {
  return unique_ptr<Array>(new remove_extent_t<Array>[count]);
}

/// The first of "%.1g" to "%.17g" that reads back as the same number; a whole number plainly where
/// that is as short.
inline to_chars_result to_chars(char* first, char* last, double value) {
  const auto room = static_cast<size_t>(last - first);
  int length = 0;
  for (int digits = 1; digits <= 17; ++digits) {
    length = snprintf(first, room, "%.*g", digits, value);
    if (length < 0 || static_cast<size_t>(length) >= room) return {last, errc::value_too_large};
    if (strtod(first, nullptr) == value) break;
  }
  if (trunc(value) == value && fabs(value) < 1e17) {
    array<char, 32> plain;
    const int digits = snprintf(plain.data(), plain.size(), "%.0f", value);
    if (digits <= length)
      length = static_cast<int>(std::copy_n(plain.data(), digits, first) - first);
  }
  return {first + length, errc()};
}

/// The first of "%.0f" or "%.0e" on that reads back as the same number.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  const char* const text = format == chars_format::fixed ? "%.*f" : "%.*e";
  const auto room = static_cast<size_t>(last - first);
  int length = 0;
  for (int digits = 0; digits <= 17; ++digits) {
    length = snprintf(first, room, text, digits, value);
    if (length < 0 || static_cast<size_t>(length) >= room) return {last, errc::value_too_large};
    if (strtod(first, nullptr) == value) break;
  }
  return {first + length, errc()};
}

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);  // strtod steps over blanks and a plus sign, from_chars does not
  if (text.empty() || !(text[0] == '-' || text[0] == '.' || (text[0] >= '0' && text[0] <= '9'))) {
    return {first, errc::invalid_argument};
  }
  char* end = nullptr;
  value = strtod(text.c_str(), &end);
  return {first + (end - text.c_str()), end == text.c_str() ? errc::invalid_argument : errc()};
}

namespace ranges {

template <class Range, class Value, class Projection = identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& each) { return std::invoke(projection, each) == value; });
}

template <class Range, class Predicate>
constexpr auto find_if(Range&& range, Predicate predicate) {
  return std::find_if(std::begin(range), std::end(range), std::ref(predicate));
}

template <class Range, class Predicate>
constexpr auto find_if_not(Range&& range, Predicate predicate) {
  return std::find_if_not(std::begin(range), std::end(range), std::ref(predicate));
}

template <class Range, class Predicate>
constexpr bool all_of(Range&& range, Predicate predicate) {
  return std::all_of(std::begin(range), std::end(range), std::ref(predicate));
}

template <class Range, class Predicate>
constexpr bool any_of(Range&& range, Predicate predicate) {
  return std::any_of(std::begin(range), std::end(range), std::ref(predicate));
}

template <class Range, class Predicate>
constexpr bool none_of(Range&& range, Predicate predicate) {
  return std::none_of(std::begin(range), std::end(range), std::ref(predicate));
}

template <class Range, class Other>
constexpr bool equal(Range&& range, Other&& other) {
  return std::equal(std::begin(range), std::end(range), std::begin(other), std::end(other));
}

template <class Range, class Value>
constexpr void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}

template <class Range, class Out>
constexpr void copy(Range&& range, Out out) {
  std::copy(std::begin(range), std::end(range), out);
}

template <class Range, class Out, class Function, class Projection = identity>
constexpr void transform(Range&& range, Out out, Function function, Projection projection = {}) {
  for (const auto& each : range) *out++ = std::invoke(function, std::invoke(projection, each));
}

template <class Range>
constexpr void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}

template <class Range, class Predicate>
constexpr auto count_if(Range&& range, Predicate predicate) {
  return std::count_if(std::begin(range), std::end(range), std::ref(predicate));
}

/// Whether what the projection makes of one comes before what it makes of another.
template <class Less, class Projection>
constexpr auto lasius_order(Less& less, Projection& projection) {
  return [&](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
  };
}

template <class Range, class Less = std::less<>, class Projection = identity>
constexpr auto min_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::min_element(std::begin(range), std::end(range), lasius_order(less, projection));
}

template <class Range, class Less = std::less<>, class Projection = identity>
constexpr auto max_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), lasius_order(less, projection));
}

template <class Range, class Less = std::less<>, class Projection = identity>
constexpr void sort(Range&& range, Less less = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), lasius_order(less, projection));
}

template <class Range, class Less = std::less<>, class Projection = identity>
void stable_sort(Range&& range, Less less = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), lasius_order(less, projection));
}

}  // namespace ranges
}  // namespace std

#endif
