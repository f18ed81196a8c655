// The scratch memory behind lasius::Workspace.
#pragma once

#include "core/base/held_bytes.h"
#include "core/colony/colony_memory.h"
#include "core/disc/disc_search.h"
#include "core/exact/anytime.h"
#include "core/exact/exact.h"
#include "core/exact/labels/label_search.h"
#include "core/exact/prepared_search.h"
#include "core/genetic/grid_ga_memory.h"
#include "lasius/plan/planner.h"

namespace lasius {

struct WorkspaceMemory {
  ColonyMemory colony;
  GridGaMemory genetic;
  ExactSearch exact;
  exact::PreparedSearch prepared;
  exact::LabelSearch labels;
  exact::Anytime::Memory bounding;  ///< beside one of these
  ExactAnswer exact_answer;
  disc::DiscSearch disc;
  disc::DiscAnswer disc_answer;

  std::int64_t bytes() const noexcept {
    return static_cast<std::int64_t>(sizeof *this) + colony.bytes() + genetic.bytes() +
           exact.bytes() + prepared.bytes() + labels.bytes() + bounding.bytes() + disc.bytes() +
           held_bytes(exact_answer.path, disc_answer.path, disc_answer.curve);
  }
  static WorkspaceMemory& of(Workspace& workspace) noexcept { return *workspace.memory_; }
};

}  // namespace lasius
