// What the ranks that share a colony's islands tell each other.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/special_values.h"
#include "core/base/stored_arrays.h"
#include "lasius/grid/geometry.h"
#include "lasius/plan/request.h"

namespace lasius {

/// @throws Error(invalid_parameter) for ranks that cannot be; `passing`: who pass texts on, too
void require_ranks(const Ranks& ranks, bool passing);

/// What each has handed in, by number. @throws Error(invalid_parameter) where these are not all
std::vector<std::string> gather(const Ranks& ranks, const std::string& own);

/// Reads what a rank, or one that is not known, has told. @throws Error(file_broken) where it is no
/// such thing.
ArrayReader told_by(std::string_view text, std::optional<int> rank);

/// A path that an island has found, or none; of equal ones the first island's is the better one.
struct FoundPath {
  struct Rank {
    double length = kInfinity;  ///< as the colony measures it
    int island = 0, none = 0;
    auto operator<=>(const Rank&) const = default;
  };
  Rank rank = {};
  std::vector<Point> points = {};
};
/// The best of what all ranks have; null: of this one.
std::vector<Point> best_of(const Ranks* ranks, FoundPath own);

}  // namespace lasius
