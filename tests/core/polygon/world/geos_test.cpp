#include "core/polygon/world/geos.h"

#include <gtest/gtest.h>

#include "lasius/base/error.h"

namespace lasius::polygon {
namespace {

TEST(Geos, WhatFailsIsAnErrorAndLeavesNothingBehind) {
  const Geos geos;
  const Ring square{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole{{1, 1}, {2, 1}, {2, 2}};
  EXPECT_NO_THROW(geos.polygon({square, {hole}}));
  EXPECT_THROW(geos.polygon({square, {hole, {{3, 3}}}}), Error);
  EXPECT_THROW(geos.own(nullptr), Error);
}

}  // namespace
}  // namespace lasius::polygon
