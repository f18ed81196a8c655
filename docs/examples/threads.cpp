// The number of threads never changes an answer.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  Params params("mmas");
  params.iterations = 20;
  params.seed = 7;
  params.threads = 1;
  const Result alone = planner.plan({.start = {14, 14}, .goal = {380, 179}}, params);
  params.threads = 4;
  const Result together = planner.plan({.start = {14, 14}, .goal = {380, 179}}, params);
  std::cout << alone.length << ' ' << together.length << '\n';
  return alone.path == together.path ? 0 : 1;
}
