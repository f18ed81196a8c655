// The scratch memory behind lasius::Workspace.
#pragma once

#include <vector>

#include "exact.h"
#include "field.h"
#include "grid_ga_memory.h"
#include "lasius/planner.h"
#include "polish.h"
#include "prepared_search.h"
#include "update.h"
#include "walkers.h"

namespace lasius {

class Workspace::Impl {
 public:
  Field field;
  Walkers walkers;
  std::vector<Ant> ants;
  std::vector<Tour> tours;               // of the ants
  std::vector<int> ranking;              // of the ants
  std::vector<std::uint8_t> best_moves;  // of the best tour so far
  Ant answer;                            // of a colony whose ants only teach it
  std::vector<std::uint8_t> way;         // its moves, as they are found
  Polisher polisher;
  GridGaMemory grid_ga;
  ExactSearch exact;
  exact::PreparedSearch prepared;
  ExactAnswer exact_answer;
};

}  // namespace lasius
