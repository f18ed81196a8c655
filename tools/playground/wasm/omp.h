// OpenMP on one thread, as far as lasius asks for it.
#pragma once

inline int omp_get_max_threads() noexcept { return 1; }
inline int omp_get_thread_num() noexcept { return 0; }
