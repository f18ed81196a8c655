# WebAssembly has one thread here: OpenMP's pragmas are passed over, its calls are in omp.h.
add_library(OpenMP::OpenMP_CXX INTERFACE IMPORTED)
set(OpenMP_FOUND TRUE)
