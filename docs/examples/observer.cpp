// An observer sees every iteration of a colony, and may stop the run: here at the first path that
// is shorter than the first one.
#include <lasius/lasius.h>

#include <cmath>
#include <iostream>

int main() {
  using namespace lasius;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));

  double first = NAN;  // as best_length is until there is a path
  const auto watch = [&first](const GridProgress& progress) {
    std::cout << progress.iteration << ": best " << progress.best_length << ", " << progress.arrived
              << " ants arrived\n";
    if (std::isnan(first)) first = progress.best_length;
    return progress.best_length < first ? Go::stop : Go::on;
  };
  const Result result =
      planner.plan({.start = {14, 14}, .goal = {380, 179}}, Params("as"), {.observer = watch});
  return result.status == Status::interrupted && result.length < first ? 0 : 1;
}
