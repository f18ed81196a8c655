// Answers that must be the same, bit for bit.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lasius/plan/result.h"

namespace lasius {

/// The same bits, or both no number.
inline void expect_same(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) {
    EXPECT_TRUE(std::isnan(a) && std::isnan(b)) << a << ", " << b;
    return;
  }
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << a << ", " << b;
}

inline void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
}

inline void expect_same(const std::vector<Point>& a, const std::vector<Point>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    expect_same(a[i].x, b[i].x);
    expect_same(a[i].y, b[i].y);
  }
}

inline void expect_same(const SearchResult& a, const SearchResult& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.fault, b.fault);
  EXPECT_EQ(a.error, b.error);
  EXPECT_EQ(a.curves.iterations, b.curves.iterations);
  EXPECT_EQ(a.curves.arrived, b.curves.arrived);
  EXPECT_EQ(a.optimal, b.optimal);
  EXPECT_EQ(a.curves.steps, b.curves.steps);
  expect_same(a.length, b.length);
  expect_same(a.lower_bound.value_or(NAN), b.lower_bound.value_or(NAN));
  expect_same(a.gap().value_or(NAN), b.gap().value_or(NAN));
  for (const auto curve :
       {&Convergence::best, &Convergence::mean, &Convergence::raw_best, &Convergence::cut_mean,
        &Convergence::cut_best, &Convergence::iteration_best, &Convergence::band,
        &Convergence::trail_entropy})
    expect_same(a.curves.*curve, b.curves.*curve);
}

/// All of two answers, but for whose rules took part.
inline void expect_same(const Result& a, const Result& b) {
  expect_same(static_cast<const SearchResult&>(a), b);
  EXPECT_EQ(a.nearest_free, b.nearest_free);
  EXPECT_EQ(a.nearest_reachable, b.nearest_reachable);
  EXPECT_EQ(a.way_out, b.way_out);
  EXPECT_EQ(a.goal_reached, b.goal_reached);
  expect_same(a.path, b.path);
}

}  // namespace lasius
