#include "tools/console/crew.h"

namespace lasius::tool {
namespace {

Crew* the_crew = nullptr;

}  // namespace

Crew* crew() noexcept { return the_crew; }
void set_crew(Crew* one) noexcept { the_crew = one; }

bool follows() noexcept { return the_crew != nullptr && !the_crew->leads(); }
void leave_to_leader() {
  if (follows()) throw Dismissed{};
}

}  // namespace lasius::tool
