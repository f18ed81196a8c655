// Problems for tests of whole plans.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/grid/generate.h"
#include "lasius/plan/planner.h"

namespace lasius {

/// Every algorithm that runs the colony's loop.
inline std::vector<const char*> colonies() {
  std::vector<const char*> names;
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.kind == Algorithm::Kind::colony) names.push_back(algorithm.name.data());
  }
  return names;
}

/// The name of a test by its parameter's, an algorithm.
inline constexpr auto by_algorithm = [](const auto& test) {
  std::string name(test.param);
  std::ranges::replace(name, '-', '_');
  return name;
};

inline Grid blobs(int width = 120, int height = 80, std::uint64_t seed = 3) {
  return generate(MapKind::blobs, {.width = width, .height = height, .seed = seed});
}

/// Free cells far apart in one component.
inline Request far_apart(const Planner& planner) {
  const Grid& grid = planner.grid();
  for (int i = 1; i < grid.width(); ++i) {
    const Cell start = planner.nearest_free({i, 1}).value();
    for (int j = 1; j < grid.width() / 2; ++j) {
      const Cell goal = planner.nearest_free({grid.width() - 1 - j, grid.height() - 2}).value();
      if (planner.connected(start, goal)) return {.start = start, .goal = goal};
    }
  }
  ADD_FAILURE() << "no far goal";
  return {};
}

/// The usual question: from one end of a map of blobs to the other.
struct FarApart {
  Planner planner{blobs()};
  Request request = far_apart(planner);

  Result plan(const Params& params = {}, const PlanOptions& options = {}) const {
    return planner.plan(request, params, options);
  }
};

inline Params quick(std::string_view algorithm) {
  Params p(algorithm);
  if (find_algorithm(algorithm).has("iterations")) p.iterations = 15;
  p.threads = 1;
  p.dead_end = DeadEnd::backtrack;           // mortal ants seldom arrive on such maps
  if (algorithm == "cong2009") p.ants = 10;  // where they walk alone
  return p;
}

}  // namespace lasius
