// Where a document is refused, and how.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lasius/base/error.h"

namespace lasius {

/// "LINE: PROBLEM; REMEDY" of what reading throws; empty where it throws nothing. `file`: the one
/// that it names.
template <class Read>
std::string fault_line(const Read& read, const std::string& file) {
  try {
    (void)read();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::file_broken) << error.what();
    EXPECT_EQ(error.place().file, file);
    return std::to_string(error.place().line) + ": " + error.problem() + "; " + error.remedy();
  }
  return {};
}

}  // namespace lasius
