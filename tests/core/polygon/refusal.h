// What readers of polygon worlds refuse, and how they say it.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lasius/error.h"
#include "lasius/polygon_world.h"

namespace lasius::polygon {

/// What reading says; fails where it says nothing.
inline std::string refusal(const std::string& text, bool wkt = false) {
  try {
    wkt ? parse_wkt(text, "w", {}) : parse_geojson(text, "w", {});
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::file_broken);
    EXPECT_EQ(e.place().file, "w");
    EXPECT_FALSE(e.remedy().empty());
    return e.what();
  }
  ADD_FAILURE() << "was read: " << text;
  return {};
}

inline void expect_refusal(const std::string& text, const std::string& part, bool wkt = false) {
  const std::string what = refusal(text, wkt);
  EXPECT_NE(what.find(part), std::string::npos) << what << "\nshould say: " << part;
}

}  // namespace lasius::polygon
