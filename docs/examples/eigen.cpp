// A path as an Eigen matrix, a column a vertex, without a copy.
#include <lasius/eigen.h>
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  const Result result = planner.plan({.start = {14, 14}, .goal = {380, 179}});
  const auto path = as_matrix(result.path);  // Eigen::Map<const Eigen::Matrix2Xd>
  const auto steps = path.rightCols(path.cols() - 1) - path.leftCols(path.cols() - 1);
  std::cout << steps.colwise().norm().sum() << '\n';
  return path.cols() == static_cast<Eigen::Index>(result.path.size()) ? 0 : 1;
}
