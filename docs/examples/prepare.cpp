// Preparation: the visibility graph, made once for many queries. Time limits and certified gaps.
#include <lasius/lasius.h>

#include <chrono>
#include <iostream>

int main() {
  using namespace lasius;
  using namespace std::chrono_literals;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}),
                        PrepareOptions{.threads = 2});
  const Preparation& graph = planner.preparation();
  std::cout << to_string(graph.state) << ": " << graph.vertices << " vertices, " << graph.edges
            << " edges, " << planner.footprint().visibility_graph << " bytes\n";

  Workspace workspace;  // memory that is kept from one plan to the next, one for each thread
  const Result quick = planner.plan({.start = {14, 14},
                                     .goal = {380, 179},
                                     .stop = {.deadline = deadline_in(100ms)},
                                     .target_gap = 0.03},
                                    Params(), {.workspace = &workspace});
  if (quick.gap()) std::cout << quick.length << ", certified gap " << *quick.gap() << '\n';
  return graph.state == Preparation::State::ready && !quick.path.empty() ? 0 : 1;
}
