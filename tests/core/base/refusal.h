// What the library says where it refuses something.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "lasius/base/error.h"

namespace lasius {

/// The error that a call ends with. Fails where it ends with none, and says that of `what`.
template <class Call>
Error error_of(const Call& call, const std::string& what = "the call") {
  try {
    (void)call();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << what << " was not refused";
  return {ErrorCode::invalid_parameter, "nothing was refused", {}};
}

/// What reads a text refuses it at a line, and says why.
template <class Read>
void expect_refused_at(const Read& read, const std::string& text, std::int64_t line,
                       const std::string& words) {
  const Error error = error_of([&] { return read(text); }, text);
  EXPECT_EQ(error.place().line, line) << error.what();
  EXPECT_PRED_FORMAT2(testing::IsSubstring, words, std::string(error.what()));
}

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
inline void expect_says(const Error& error, const std::string& part) {
  expect_says(std::string(error.what()), part);
}

}  // namespace lasius
