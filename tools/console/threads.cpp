#include "tools/console/threads.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "tools/console/values.h"

namespace lasius::tool {

int thread_count(const std::string& option) {
  constexpr int kMost = 1024;
  if (!option.empty()) return static_cast<int>(integer_value("--threads", option, 1, kMost));
  const char* own = std::getenv("LASIUS_THREADS");
  if (own != nullptr && *own != '\0')
    return static_cast<int>(integer_value("LASIUS_THREADS", own, 1, kMost));
  // OpenMP's own variable may be a list by nesting level; what is no number of threads is not ours
  // to refuse, but it must go: libomp 14 warns of it, then aborts on the count that it never read.
  if (const char* openmp = std::getenv("OMP_NUM_THREADS")) {
    const std::string_view text = openmp;
    const auto first = parse_integer(text.substr(0, text.find(',')));
    if (first && *first >= 1 && *first <= kMost) return static_cast<int>(*first);
    unsetenv("OMP_NUM_THREADS");
  }
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMost);
}

}  // namespace lasius::tool
