// The scratch memory of a colony on a bitmap.
#pragma once

#include <cstdint>
#include <list>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/colony/best_tour.h"
#include "core/colony/field.h"
#include "core/colony/own_update.h"
#include "core/colony/polish.h"
#include "core/colony/update.h"
#include "core/colony/walk_cutter.h"
#include "core/colony/walkers.h"

namespace lasius {

struct ColonyMemory {
  Field field;
  Walkers walkers;
  std::vector<Ant> ants;            // perhaps more than are sent
  std::vector<Tour> tours;          // of the ants, cut if tours are
  std::vector<double> raw_lengths;  // of the ants' tours, not cut
  std::vector<WalkCutter> cutters;  // by thread
  std::vector<int> ranking;         // of the ants
  std::vector<EarlierTau> earlier;  // before an iteration's local updates
  BestTour best;                    // so far
  BestTour guest;                   // another island's, to learn by
  Ant answer;                       // of a colony whose ants only teach it
  std::vector<std::uint8_t> way;    // its moves, as they are found
  Polisher polisher;
  NumberedTours numbered;           // for an own update
  std::list<ColonyMemory> islands;  // perhaps more than there are

  std::int64_t bytes() const noexcept {
    std::int64_t others = 0;
    for (const ColonyMemory& island : islands) others += island.bytes();
    return others + field.bytes() + walkers.bytes() + held_bytes_of_all(ants) + answer.bytes() +
           held_bytes(tours, raw_lengths, ranking, earlier, way) + best.bytes() + guest.bytes() +
           polisher.bytes() + numbered.bytes() + held_bytes_of_all(cutters);
  }
};

}  // namespace lasius
