// The instruction sets that kernels are tested on.
#pragma once

#include <string>
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

/// The name of a test by its parameter, an instruction set.
inline constexpr auto by_isa = [](const auto& test) {
  return std::string(test.param == Isa::scalar ? "scalar"
                     : test.param == Isa::avx2 ? "avx2"
                                               : "avx512");
};

}  // namespace lasius::kernels
