// What the library says where it refuses something.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/base/special_values.h"
#include "lasius/error.h"

namespace lasius {

/// What a call is refused with.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_parameter);
    return error.what();
  }
  return "accepted";
}

inline void expect_says(const std::string& text, const std::string& part) {
  EXPECT_PRED_FORMAT2(testing::IsSubstring, part, text);
}

}  // namespace lasius
