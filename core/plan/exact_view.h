// What an observer sees of a search that has no ants: one more path, better than those before.
#pragma once

#include <vector>

#include "lasius/plan/progress.h"

namespace lasius {

class ExactView final : public GridProgress {
 public:
  ExactView(const std::vector<Point>& path, int number, double length, double bound) : path_(path) {
    iteration = number;
    best_length = length;
    lower_bound = bound;
  }
  std::vector<Point> path() const override { return path_; }

 private:
  const std::vector<Point>& path_;
};

}  // namespace lasius
