// A field as a level of a proof.
#pragma once

#include "core/cost/edge_field.h"
#include "core/cost/terrain.h"
#include "lasius/cost/proof.h"

namespace lasius::cost {

/// The marched cells of a field over a terrain, and their values.
CostProof::Level proof_level(const Terrain& terrain, const EdgeField& field, bool from_start,
                             int block);

}  // namespace lasius::cost
