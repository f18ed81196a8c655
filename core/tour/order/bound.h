// What no tour can be cheaper than: the bound of Held & Karp (1970), by ascent over 1-trees, with
// combs.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/poller.h"
#include "core/tour/order/candidates.h"
#include "core/tour/order/costs.h"

namespace lasius::tour {

/// A whole number that no tour with these ends is cheaper than; `upper` is the cost of one. The
/// ascent is over 6 candidates a stop, each tree that is asserted over all legs, at their lower
/// bounds where they are not priced. Legs that such a tree takes are let in (and priced); of costs
/// at hand all that would make a tree over the candidates cheaper, and the nearest to that. Combs
/// that the mean of the last trees exceeds get prices as stops have (Lagrange's), and the ascent
/// goes on, at most `rounds` times, until stopped, or until the bound meets `upper` or gains
/// little. Stopped before the first such tree, it is 0. Deterministic but for that.
/// `alike`: what every tour costs for sure and is no length; what a gap is worth is told by the
/// rest of `upper`.
std::int64_t tour_bound(const Costs& costs, const Ends& ends, std::span<const Point> places,
                        std::int64_t upper, int rounds, Poller& poller, std::int64_t alike = 0);

}  // namespace lasius::tour
