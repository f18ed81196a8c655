# Headers that many files include, parsed once: half of the time of a small file. A file still names
# each header that it uses: CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, as CI does once.
set(LASIUS_STANDARD_HEADERS <algorithm> <array> <atomic> <bit> <chrono> <cmath> <cstdint> <cstdlib>
  <filesystem> <fstream> <functional> <limits> <memory> <numbers> <optional> <random> <span>
  <sstream> <stop_token> <string> <string_view> <utility> <vector>)

# lasius_precompile(TARGET [HEADER...]): the standard headers, and those named.
function(lasius_precompile target)
  target_precompile_headers(${target} PRIVATE ${LASIUS_STANDARD_HEADERS} ${ARGN})
endfunction()
