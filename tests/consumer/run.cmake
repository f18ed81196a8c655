# Run by ctest with the variables that CMakeLists.txt sets. LIBRARY_DIR: a build to install from;
# empty: the library of this KIND (static or shared) is built here first.

# run(WHAT COMMAND...): its output in `output`; ends the test when the command fails. It is run in
# WORK_DIR: a stranger is not in the source tree.
function(run what)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE failed
    WORKING_DIRECTORY ${WORK_DIR})
  if(failed)
    message(FATAL_ERROR "${KIND}: ${what} failed (${failed})\n${out}\n${err}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

# expect_refusal(WHAT TEXT ARGUMENT...): configuring the consumer again fails and the reason holds TEXT.
function(expect_refusal what text)
  execute_process(COMMAND ${configure} -B ${build} ${ARGN}
    OUTPUT_QUIET ERROR_VARIABLE err RESULT_VARIABLE failed)
  string(REGEX REPLACE "[ \n]+" " " err "${err}")
  string(FIND "${err}" "${text}" position)
  if(NOT failed OR position EQUAL -1)
    message(FATAL_ERROR "${KIND}: ${what} should be refused with '${text}', not with:\n${err}")
  endif()
endfunction()

# expect_length(OUTPUT): the example's last line is the length of a path.
function(expect_length text)
  if(NOT text MATCHES "(^|\n)([0-9]+)(\\.[0-9]+)?\n$")
    message(FATAL_ERROR "${KIND}: the example should end with a length, not with:\n${text}")
  endif()
endfunction()

set(toolchain -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
  -DCMAKE_BUILD_TYPE=Release)
set(prefix ${WORK_DIR}/prefix)
set(build ${WORK_DIR}/build)
file(REMOVE_RECURSE ${prefix} ${build})
file(MAKE_DIRECTORY ${WORK_DIR})

if(NOT LIBRARY_DIR)
  set(LIBRARY_DIR ${WORK_DIR}/library)
  string(COMPARE EQUAL ${KIND} shared shared)
  # What is tested is the package: an unoptimised library is there sooner.
  run("configuring the library" ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${LIBRARY_DIR} ${toolchain}
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0
    -DBUILD_SHARED_LIBS=${shared} -DLASIUS_BUILD_IO=${BUILD_IO}
    -DLASIUS_BUILD_ARM=${BUILD_ARM} -DLASIUS_BUILD_POLYGON=${BUILD_POLYGON}
    -DLASIUS_BUILD_TOOLS=OFF -DLASIUS_UNITY=ON
    -DLASIUS_BUILD_TESTS=OFF -DLASIUS_BUILD_BENCH=OFF -DCMAKE_INSTALL_LIBDIR=${LIBDIR})
  run("building the library" ${CMAKE_COMMAND} --build ${LIBRARY_DIR})
endif()
run("installing" ${CMAKE_COMMAND} --install ${LIBRARY_DIR} --prefix ${prefix})
foreach(file IN ITEMS LICENSE README.md docs/library.md)
  if(NOT EXISTS ${prefix}/${DOCDIR}/${file})
    message(FATAL_ERROR "${KIND}: ${file} is not in ${DOCDIR}")
  endif()
endforeach()
run("checking the documents' links" ${PYTHON3} ${SOURCE_DIR}/.ci/check_links ${prefix}/${DOCDIR})

# README.md's first C++ block is the example, so that it cannot drift.
file(READ ${SOURCE_DIR}/README.md readme)
string(FIND "${readme}" "```cpp\n" begin)
if(begin EQUAL -1)
  message(FATAL_ERROR "README.md has no C++ block")
endif()
math(EXPR begin "${begin} + 7")
string(SUBSTRING "${readme}" ${begin} -1 readme)
string(FIND "${readme}" "```" end)
string(SUBSTRING "${readme}" 0 ${end} example)
file(WRITE ${WORK_DIR}/example.cpp "${example}")

set(components "")
if(BUILD_IO)
  set(components io)
endif()
if(BUILD_ARM)
  list(APPEND components arm)
endif()
if(BUILD_POLYGON)
  list(APPEND components polygon)
endif()
set(source_io ${CMAKE_CURRENT_LIST_DIR}/project/use_io.cpp)
set(source_arm ${prefix}/${DOCDIR}/docs/examples/arm.cpp)
set(source_polygon ${prefix}/${DOCDIR}/docs/examples/polygon.cpp)
set(configure ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project ${toolchain}
  -DCMAKE_PREFIX_PATH=${prefix} -DEXAMPLE=${WORK_DIR}/example.cpp -DSOURCE_IO=${source_io}
  -DSOURCE_ARM=${source_arm} -DSOURCE_POLYGON=${source_polygon})
list(JOIN components "," component_names)
run("configuring the consumer" ${configure} -B ${build} -DCOMPONENTS=${component_names}
  -DLASIUS_WANTED=${VERSION})
run("building the consumer" ${CMAKE_COMMAND} --build ${build})
run("the example" ${build}/example)
expect_length("${output}")
foreach(component IN LISTS components)
  run("use_${component}" ${build}/use_${component} ${WORK_DIR})
endforeach()

# What the config files refuse is the same for both kinds.
if(KIND STREQUAL "static")
  expect_refusal("an unknown component" "lasius has no component 'wings'" -DCOMPONENTS=wings -DLASIUS_WANTED=${VERSION})
  if(NOT EXISTS ${prefix}/${LIBDIR}/cmake/lasius/lasius-arm-targets.cmake)
    expect_refusal("a component that was not built" "built without its component 'arm'"
      -DCOMPONENTS=arm -DLASIUS_WANTED=${VERSION})
  endif()
  expect_refusal("another minor version" "compatible with requested version" -DCOMPONENTS= -DLASIUS_WANTED=0.0)
endif()

# The same through pkg-config.
set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
run("pkg-config for the maps" ${PKG_CONFIG} --variable=mapsdir lasius)
string(STRIP "${output}" maps)
if(NOT EXISTS ${maps}/fan400x200.map)
  message(FATAL_ERROR "${KIND}: pkg-config's mapsdir, '${maps}', holds no maps")
endif()
run("pkg-config" ${PKG_CONFIG} --cflags --libs "lasius = ${VERSION}")
separate_arguments(flags UNIX_COMMAND "${output}")
run("compiling with pkg-config" ${CXX} -std=c++20 ${WORK_DIR}/example.cpp -o ${WORK_DIR}/example
  ${flags} -Wl,-rpath,${prefix}/${LIBDIR})
run("the pkg-config example" ${WORK_DIR}/example)
expect_length("${output}")
foreach(component IN LISTS components)
  run("pkg-config for ${component}" ${PKG_CONFIG} --cflags --libs lasius-${component})
  separate_arguments(flags UNIX_COMMAND "${output}")
  # The standard comes last: Debian's urdfdom names an older one.
  run("compiling with pkg-config for ${component}" ${CXX}
    ${source_${component}} -o ${WORK_DIR}/use_${component} ${flags}
    -std=c++20 -Wl,-rpath,${prefix}/${LIBDIR})
  run("use_${component} by pkg-config" ${WORK_DIR}/use_${component} ${WORK_DIR})
  if(component STREQUAL "arm")
    # Memory that Eigen allocates with another alignment could not be freed: the linker refuses.
    file(WRITE ${WORK_DIR}/other_alignment.cpp "#include <lasius/arm/robot.h>\nint main() {}\n")
    execute_process(COMMAND ${CXX} ${WORK_DIR}/other_alignment.cpp
        -DEIGEN_MAX_ALIGN_BYTES=64 -o ${WORK_DIR}/other_alignment ${flags} -std=c++20
      ERROR_VARIABLE err RESULT_VARIABLE failed)
    if(NOT failed OR NOT err MATCHES "compile_with_the_Eigen_alignment_of_lasius<64, false>")
      message(FATAL_ERROR "${KIND}: another alignment of Eigen's should not link, but:\n${err}")
    endif()
  endif()
endforeach()

# A shared library is found by its versioned name, and shows public names only.
if(KIND STREQUAL "shared")
  string(REGEX MATCH "^[0-9]+\\.[0-9]+" soversion ${VERSION})
  if(NOT EXISTS ${prefix}/${LIBDIR}/liblasius.so.${soversion})
    message(FATAL_ERROR "liblasius.so.${soversion} is not installed")
  endif()
  run("nm" nm -DC --defined-only ${prefix}/${LIBDIR}/liblasius.so)
  if(output MATCHES "lasius::kernels::[^\n]*")
    message(FATAL_ERROR "liblasius.so exports an internal name: ${CMAKE_MATCH_0}")
  endif()
endif()
