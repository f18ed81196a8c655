# Headers that many files include, parsed once: they are half of the time of a small file. A file
# still names each header that it uses: CI builds with CMAKE_DISABLE_PRECOMPILE_HEADERS=ON, too.
set(LASIUS_STANDARD_HEADERS <algorithm> <array> <bit> <cmath> <cstdint> <filesystem> <functional>
  <limits> <memory> <optional> <span> <string> <string_view> <utility> <vector>)

# Without this ccache passes each such file by.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "(^|/)ccache$")
  set(CMAKE_CXX_COMPILER_LAUNCHER
    env CCACHE_SLOPPINESS=pch_defines,time_macros ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# lasius_precompile(TARGET [GROUP NAME] [HEADER...]): the standard headers, and those named. They are
# compiled once for a group of targets, whose options, definitions and headers are the same.
function(lasius_precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "GROUP" "")
  if(arg_GROUP)
    get_property(owner GLOBAL PROPERTY lasius_precompiled_${arg_GROUP})
    if(owner)
      target_precompile_headers(${target} REUSE_FROM ${owner})
      return()
    endif()
    set_property(GLOBAL PROPERTY lasius_precompiled_${arg_GROUP} ${target})
  endif()
  target_precompile_headers(${target} PRIVATE ${LASIUS_STANDARD_HEADERS}
    ${arg_UNPARSED_ARGUMENTS})
endfunction()
