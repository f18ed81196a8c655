// Parameters: published values first, then what you change.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  Params params("mmas");
  params.neighbours = Neighbours::sixteen_knight;
  params.polish = Polish::taut;
  params.iterations = 40;
  set_parameter(params, "persistence", "0.9");  // by name, as in lasius algorithms
  validate(params);                             // throws where something does not fit

  const Planner planner(generate(MapKind::rooms, {.width = 200, .height = 200}));
  const auto start = planner.nearest_free({5, 5}), goal = planner.nearest_free({190, 190});
  const Result result = planner.plan({.start = *start, .goal = *goal}, params);
  std::cout << params.algorithm() << ' ' << to_string(result.status) << ' ' << result.length
            << '\n';
  return result.path.empty() ? 1 : 0;
}
