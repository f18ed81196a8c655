// What a planner on a bitmap answers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lasius/export.h"
#include "lasius/geometry.h"
#include "lasius/status.h"

namespace lasius {

/// One answer. Without a path `path` is empty and `length` is not a number.
struct LASIUS_EXPORT Result {
  Status status = Status::no_path;
  std::string error;         ///< why the status is invalid or unreachable; else empty
  std::vector<Point> path;   ///< start and goal at cell centres; one point where they are the same
  double length;             ///< in cells
  int iterations = 0;        ///< iterations done
  std::vector<double> best;  ///< by iteration: shortest final path up to then; NaN if none
  std::vector<double> mean;  ///< by iteration: mean raw tour of the arrived ants; NaN if none
  std::vector<int> arrived;  ///< by iteration: ants that reached the goal
  std::optional<double> lower_bound;  ///< certified: no path is shorter
  /// Certified (length - lower_bound) / lower_bound; 0 at length 0; nothing where not certified.
  std::optional<double> gap() const;
  bool optimal = false;  ///< proven shortest

  Result();
};

}  // namespace lasius
