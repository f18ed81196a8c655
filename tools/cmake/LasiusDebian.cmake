# CPack: the source as a tarball, and with LASIUS_DEBIAN packages of the install components.
# tools/package calls it with what it needs: shared libraries, hardening flags, prefix /usr.
set(LASIUS_MAINTAINER "The lasius authors <lasius@lasius.invalid>" CACHE STRING "Of the packages")
set(LASIUS_DEBIAN_REVISION 1 CACHE STRING "Of the packages, behind the version")

# lasius_debian_package(COMPONENT NAME SECTION SUMMARY DETAIL [VARIABLE VALUE]...): one package and its
# fields; copyright and changelog are installed with it.
function(lasius_debian_package component name section summary detail)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${detail}" PARENT_SCOPE)
  while(ARGN)
    list(POP_FRONT ARGN field value)
    set(CPACK_DEBIAN_${key}_PACKAGE_${field} "${value}" PARENT_SCOPE)
  endwhile()
  set(overrides ${LASIUS_CMAKE_DIR}/debian/${component}.overrides)
  install(FILES ${PROJECT_BINARY_DIR}/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz
    DESTINATION share/doc/${name} COMPONENT ${component})
  if(EXISTS ${overrides})
    configure_file(${overrides} ${PROJECT_BINARY_DIR}/debian/${name} @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/debian/${name} DESTINATION share/lintian/overrides
      COMPONENT ${component})
  endif()
endfunction()

# What every package has in its folder of documents.
function(lasius_debian_documents)
  file(STRINGS ${PROJECT_SOURCE_DIR}/LICENSE license)
  list(POP_FRONT license title)
  list(FILTER license EXCLUDE REGEX "^Copyright")
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE text)
  string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" found "${text}")
  set(holder "${CMAKE_MATCH_1}")
  string(REGEX REPLACE "^.*authors\n\n" "" text "${text}")
  string(REGEX REPLACE "\n\n" "\n.\n" text "${text}")
  string(REGEX REPLACE "\n$" "" text "${text}")
  string(REGEX REPLACE "\n" "\n " license "\n${text}")
  configure_file(${LASIUS_CMAKE_DIR}/debian/copyright.in ${PROJECT_BINARY_DIR}/debian/copyright @ONLY)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH, if that is set
  configure_file(${LASIUS_CMAKE_DIR}/debian/changelog.in
    ${PROJECT_BINARY_DIR}/debian/changelog.Debian @ONLY)
  execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/debian/changelog.Debian
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# A macro: CPack reads the variables of the top folder.
macro(lasius_debian_packages)
  set(CPACK_PACKAGE_CONTACT "${LASIUS_MAINTAINER}")
  set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
  set(CPACK_SOURCE_GENERATOR TGZ)
  set(CPACK_SOURCE_PACKAGE_FILE_NAME lasius-${PROJECT_VERSION})
  set(CPACK_SOURCE_IGNORE_FILES "/\\\\.git(/|$)" "^${PROJECT_SOURCE_DIR}/build" "^${PROJECT_SOURCE_DIR}/out/"
    "/__pycache__/" "/\\\\.cache/" "/CMakeUserPresets.json" "/compile_commands.json")
  set(CPACK_GENERATOR "")
  if(LASIUS_DEBIAN)
    if(NOT BUILD_SHARED_LIBS OR NOT LASIUS_BUILD_TOOLS)
      message(FATAL_ERROR "Debian packages need BUILD_SHARED_LIBS=ON and LASIUS_BUILD_TOOLS=ON; tools/package makes them")
    endif()
    lasius_debian_documents()
    lasius_describe_packages()
  endif()
  include(CPack)
endmacro()

macro(lasius_describe_packages)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING IGNORE)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_RELEASE ${LASIUS_DEBIAN_REVISION})
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  # The packages need each other's libraries, before any is installed.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/core
    ${PROJECT_BINARY_DIR}/core/io ${PROJECT_BINARY_DIR}/core/arm ${PROJECT_BINARY_DIR}/core/polygon)

  # The package is named after its libraries, as Debian's policy 8.1 asks: what links one of them asks
  # for liblasius.so.MAJOR.MINOR, since before 1.0 every minor version may break the interface.
  set(lasius_runtime liblasius${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(lasius_same "(= ${PROJECT_VERSION}-${LASIUS_DEBIAN_REVISION})")
  set(CPACK_COMPONENTS_ALL program runtime dev)
  set(lasius_what "Published ant-colony planners, implemented from their papers and runnable
on real maps, and an exact any-angle planner to measure them against.
Worlds are bitmaps, polygons, and robot arms among obstacles.")
  lasius_debian_package(program lasius science "ant-colony and exact motion planning on maps"
    "${lasius_what}\n\nThis package has the program, its documents and example maps."
    DEPENDS "${lasius_runtime} ${lasius_same}")
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
  lasius_debian_package(runtime ${lasius_runtime} libs "motion planning - shared libraries"
    "${lasius_what}\n\nThis package has the shared libraries."
    CONTROL_EXTRA ${LASIUS_CMAKE_DIR}/debian/triggers)
  lasius_debian_package(dev liblasius-dev libdevel "motion planning - headers"
    "${lasius_what}\n\nThis package has what programs are built with: C++20 headers, a CMake
package and pkg-config files. Example maps are in the package lasius."
    DEPENDS "${lasius_runtime} ${lasius_same}, libeigen3-dev" SUGGESTS lasius SHLIBDEPS OFF)
  if(LASIUS_BUILD_PYTHON)
    lasius_describe_python_package()
  endif()
endmacro()

# The extension module is that of one minor version of Python.
macro(lasius_describe_python_package)
  set(modules lib/python3/dist-packages)
  install(TARGETS lasius_python LIBRARY DESTINATION ${modules}/lasius COMPONENT python)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/lasius DESTINATION ${modules} COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
  file(CONFIGURE OUTPUT debian/egg-info @ONLY
    CONTENT "Metadata-Version: 2.1\nName: lasius\nVersion: @PROJECT_VERSION@\nSummary: @PROJECT_DESCRIPTION@\n")
  install(FILES ${PROJECT_BINARY_DIR}/debian/egg-info DESTINATION ${modules}
    RENAME lasius-${PROJECT_VERSION}.egg-info COMPONENT python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR lasius_next_python "${Python_VERSION_MINOR} + 1")
  set(lasius_python "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${lasius_next_python})")
  lasius_debian_package(python python3-lasius python "motion planning - Python package"
    "${lasius_what}\n\nThis package has the Python package: maps and results as numpy arrays."
    DEPENDS "${lasius_runtime} ${lasius_same}, ${lasius_python}, python3-numpy"
    SUGGESTS "python3-matplotlib, python3-shapely")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${LASIUS_CMAKE_DIR}/debian/python/postinst ${LASIUS_CMAKE_DIR}/debian/python/prerm)
endmacro()
