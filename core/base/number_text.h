// Numbers in messages and files.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace lasius {

/// The shortest text that reads back as the same number.
template <class Number>
std::string number_text(Number value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

}  // namespace lasius
