#include "tools/study/study.h"

namespace lasius::study {

std::span<const Entry> catalogue() {
  static constexpr Entry kStudies[] = {
      {"fan2004", fan2004},           {"terminal-index", terminal_index}, {"cong2009", cong2009},
      {"lecture-grid", lecture_grid}, {"neighbourhoods", neighbourhoods}, {"families", families},
  };
  return kStudies;
}

Contender tenfold(const Contender& contender) {
  Contender more = contender;
  more.name += "-x10";
  more.label += " x10";
  more.budget = 10;
  return more;
}

}  // namespace lasius::study
