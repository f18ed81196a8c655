// A rule of your own: the rank-based ant system's update, written outside the library.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  const Request request{.start = {14, 14}, .goal = {380, 179}};
  Params params("ras");
  params.iterations = 50;

  OwnRules own;
  own.update = [](Pheromone& trail, const IterationTours& tours) {
    constexpr int kRanks = 6;
    trail.persist(0.9);
    for (int r = 1; r < kRanks && r <= std::ssize(tours.ranked); ++r) {
      const int ant = tours.ranked[r - 1];
      trail.add(tours.places_of(ant), (kRanks - r) / tours.lengths[ant]);
    }
    if (tours.best_length > 0) trail.add(tours.best_places(), kRanks / tours.best_length);
  };
  const Result mine = planner.plan(request, params, {.own_rules = own});
  const Result built_in = planner.plan(request, params);
  std::cout << "own " << mine.length << ", built-in " << built_in.length << '\n';
  return mine.own_rules && mine.path == built_in.path ? 0 : 1;
}
