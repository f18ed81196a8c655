// How many threads to use.
#pragma once

#include <string>

namespace lasius::tool {

/// The value of --threads (empty: not given), else LASIUS_THREADS, else OMP_NUM_THREADS, else one
/// a core. @throws UsageError naming option or variable.
int thread_count(const std::string& option);

}  // namespace lasius::tool
