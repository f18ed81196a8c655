// Paths of a disc: where they may begin and end, and the check of what a search found.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/base/poller.h"
#include "core/plan/answer.h"

namespace lasius {

/// The cell whose clear centre is nearest to a spot, of those from which a disc can go to `other`,
/// if given; order and ends as of nearest_free().
std::optional<Cell> nearest_clear(const disc::DiscSpace& space, Spot spot, Poller& poller,
                                  const std::optional<Point>& other = {});

/// Why a disc's path, or its curve if there is one, is none, or comes nearer than the radius (up to
/// twice disc::kSlack), or nothing. Shares nothing with the search but what bits of a row say.
std::optional<std::string> disc_path_fault(const Grid& map, double radius,
                                           std::span<const Point> path,
                                           std::span<const CurvePiece> curve);

}  // namespace lasius
