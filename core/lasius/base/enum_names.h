// Names of the values of an enumeration, as to_string gives them and options take them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace lasius {

/// The name of a value whose enumeration counts from 0; empty for what is none of its values.
template <class Enum, std::size_t kCount>
constexpr std::string_view name_of(Enum value,
                                   const std::array<std::string_view, kCount>& names) noexcept {
  const auto i = static_cast<std::size_t>(value);
  return i < kCount ? names[i] : std::string_view();
}

}  // namespace lasius
