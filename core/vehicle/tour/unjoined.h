// Which place a vehicle's tour is to leave out, where some are not joined by plans.
#pragma once

#include <set>
#include <vector>

#include "core/vehicle/tour/leg_prices.h"

namespace lasius::vehicle {

/// A place that is to be left out.
struct Unjoined {
  int place = -1;                 // -1: none
  std::vector<PosePair> untried;  // to be planned first: they may join it all the same
};

/// The places of a tour.
struct TourPlaces {
  std::vector<std::vector<int>> at;  ///< poses of each
  std::vector<char> needs_leg[2];    ///< whether each tour over it has a leg away from it, to it
  std::vector<char> end;             ///< where a tour begins or ends
  std::set<int> left_out;
};

/// A place that no way leads away from, or none to, where each tour needs one, or neither; as told
/// by legs to several of those that others are joined to. Where there is none: of the places of
/// few, or of the legs of `order` without plans, the one without a way to, or from, most others.
/// Ends come last; ties go to the first, where places have several poses to the first of such legs.
/// @param order  legs of a tour, all known; some without plans, as there is none without. Or empty
Unjoined unjoined(const LegPrices& legs, const TourPlaces& places,
                  const std::vector<PosePair>& order);

/// Of the ends of legs without a way the pose at the place with the most legs without, of all that
/// are known; -1: all are where tours begin or end.
int most_lost(const LegPrices& legs, const TourPlaces& places, const std::vector<PosePair>& lost);

}  // namespace lasius::vehicle
