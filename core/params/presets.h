// The published algorithms: one function a source, each a value of Params.
#pragma once

#include <span>

#include "lasius/params.h"

namespace lasius {

/// The parameters that every grid colony reads.
std::span<const Parameter> colony_parameters() noexcept;
/// Those of the genetic comparator.
std::span<const Parameter> genetic_parameters() noexcept;

}  // namespace lasius
