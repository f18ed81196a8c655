// An observer sees every improvement, and may stop the run.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  const Request request{.start = {14, 14}, .goal = {380, 179}};

  const Result result =
      planner.plan(request, Params("as"), nullptr, [](const GridProgress& progress) {
        std::cout << progress.iteration << ": best " << progress.best_length << ", "
                  << progress.arrived << " ants arrived\n";
        if (progress.iteration == 4) progress.stop();
      });
  return result.status == Status::interrupted && result.iterations == 5 ? 0 : 1;
}
