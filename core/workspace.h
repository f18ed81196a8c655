// The scratch memory behind lasius::Workspace.
#pragma once

#include <vector>

#include "field.h"
#include "lasius/planner.h"
#include "polish.h"
#include "walkers.h"

namespace lasius {

class Workspace::Impl {
 public:
  Field field;
  Walkers walkers;
  std::vector<Ant> ants;
  Polisher polisher;
};

}  // namespace lasius
