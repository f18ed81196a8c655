#include "tools/console/kinds.h"

#include "tools/arm/arm_kind.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/drive/drive_kind.h"
#include "tools/polygon/polygon_kind.h"

namespace lasius::tool {

std::span<const ProblemKind* const> kinds() {
  static const ProblemKind* const kAll[] = {&bitmap_kind(), &drive_kind(), &arm_kind(),
                                            &polygon_kind()};
  return kAll;
}

}  // namespace lasius::tool
