// The instruction sets that kernels are tested on.
#pragma once

#include <vector>

#include "kernels/base/cpu.h"

namespace lasius::kernels {

/// Those of this CPU, the reference first.
inline std::vector<Isa> supported_isas() {
  std::vector<Isa> isas;
  for (const Isa isa : {Isa::scalar, Isa::avx2, Isa::avx512}) {
    if (isa <= supported_isa()) isas.push_back(isa);
  }
  return isas;
}

}  // namespace lasius::kernels
