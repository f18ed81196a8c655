// What readers of polygon worlds refuse, and how they say it.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lasius/base/error.h"
#include "lasius/polygon/world.h"
#include "tests/core/base/refusal.h"

namespace lasius::polygon {

/// What reading says; fails where it says nothing.
inline std::string refusal(const std::string& text, bool wkt = false) {
  const Error error =
      error_of([&] { return wkt ? parse_wkt(text, "w", {}) : parse_geojson(text, "w", {}); }, text);
  EXPECT_EQ(error.code(), ErrorCode::file_broken);
  EXPECT_EQ(error.place().file, "w");
  EXPECT_FALSE(error.remedy().empty());
  return error.what();
}

inline void expect_refusal(const std::string& text, const std::string& part, bool wkt = false) {
  expect_says(refusal(text, wkt), part);
}

}  // namespace lasius::polygon
