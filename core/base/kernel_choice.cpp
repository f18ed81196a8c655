#include "core/base/kernel_choice.h"

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/invalid_parameter.h"

namespace lasius {

kernels::Isa chosen_isa() {
  const kernels::Isa best = kernels::supported_isa();
  const char* wanted = std::getenv("LASIUS_KERNELS");  // NOLINT(concurrency-mt-unsafe)
  if (wanted == nullptr || *wanted == '\0') return best;
  constexpr std::array<std::string_view, 3> kNames{"scalar", "avx2", "avx512"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] != wanted) continue;
    const auto isa = static_cast<kernels::Isa>(i);
    if (isa <= best) return isa;
    refuse("LASIUS_KERNELS asks for " + std::string(wanted) + ", which this CPU lacks",
           "unset it, or set it to scalar");
  }
  refuse("LASIUS_KERNELS is \"" + std::string(wanted) + "\", which names no kernels",
         "set it to scalar, avx2 or avx512, or unset it");
}

}  // namespace lasius
