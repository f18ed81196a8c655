# CMake's view of Debian's emscripten 3.1.6 (LLVM 14), for the playground alone: what that compiler's
# library lacks stands in this folder, which no other build sees.
set(ENV{NODE_PATH} /usr/share/nodejs)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)

set(here ${CMAKE_CURRENT_LIST_DIR})
list(PREPEND CMAKE_MODULE_PATH ${here})  # FindOpenMP

# Random123 alone of the machine's own headers, which are of another C library.
find_path(random123 Random123/philox.h PATHS /usr/include /usr/local/include
  NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
if(NOT random123)
  message(FATAL_ERROR "the playground needs librandom123-dev: tools/setup playground")
endif()
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/random123)
file(CREATE_LINK ${random123}/Random123 ${CMAKE_BINARY_DIR}/random123/Random123 SYMBOLIC)
set(LASIUS_RANDOM123_DIR ${CMAKE_BINARY_DIR}/random123 CACHE PATH "Where Random123's headers are")

# WebAssembly's own exceptions: those that emscripten makes of JavaScript cost a call each time that
# a function may throw.
string(JOIN " " CMAKE_CXX_FLAGS_INIT -fwasm-exceptions -isystem ${here}
  -isystem ${CMAKE_BINARY_DIR}/random123 -include ${here}/compatibility.h)
