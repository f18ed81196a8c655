# The installed package: one CMake package with components, a pkg-config file for each library.
# Install components, which LasiusDebian.cmake makes packages of: program, runtime (shared libraries),
# dev, and python.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(LASIUS_COMPONENTS io polygon arm)  # beside lasius::lasius, which is always there
set(LASIUS_MAPS_DESTINATION share/lasius/maps)
set(LASIUS_CMAKE_DIR ${CMAKE_CURRENT_LIST_DIR})

# lasius_package_library(TARGET [COMPONENT NAME] [PC_REQUIRES MODULE...] [PC_PUBLIC_REQUIRES MODULE...])
# Alias, version and install rules of one library. A component's own public headers are lasius/NAME.h and those in
# lasius/NAME/; all others belong to the main library. PC_REQUIRES are the pkg-config modules that a static archive
# needs, PC_PUBLIC_REQUIRES those of the headers. A component's pkg-config file names lasius itself.
function(lasius_package_library target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "COMPONENT" "PC_REQUIRES;PC_PUBLIC_REQUIRES")
  set(name lasius)
  set(pc lasius)
  if(arg_COMPONENT)
    set(name ${arg_COMPONENT})
    set(pc lasius-${arg_COMPONENT})
  endif()
  add_library(lasius::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    OUTPUT_NAME ${pc}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  if(BUILD_SHARED_LIBS AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_link_options(${target} PRIVATE LINKER:--no-undefined)
  endif()
  if(NOT LASIUS_INSTALL)
    return()
  endif()

  if(arg_COMPONENT AND BUILD_SHARED_LIBS)
    # A program that uses a component only need not link the main library itself.
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN")
  endif()
  install(TARGETS ${target} EXPORT ${pc}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
  install(EXPORT ${pc}-targets NAMESPACE lasius::
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lasius COMPONENT dev)
  if(arg_COMPONENT)
    set(headers ${PROJECT_SOURCE_DIR}/core/lasius/${name})
    install(FILES ${headers}.h ${PROJECT_BINARY_DIR}/core/lasius/${name}_export.h
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lasius COMPONENT dev)
    install(DIRECTORY ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lasius COMPONENT dev)
  endif()
  lasius_pc_file(${pc} "${arg_COMPONENT}" "${arg_PC_REQUIRES}" "${arg_PC_PUBLIC_REQUIRES}")
endfunction()

function(lasius_pc_file pc component static_requires requires)
  # Paths relative to the file itself, so that the installed tree can be moved.
  file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" pc_prefix ${pc_prefix})
  file(RELATIVE_PATH pc_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
  file(RELATIVE_PATH pc_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
  set(pc_description "${PROJECT_DESCRIPTION}")
  set(pc_requires ${requires})
  set(pc_libs "-l${pc}")
  if(component)
    string(APPEND pc_description ", component ${component}")
    list(PREPEND pc_requires "lasius = ${PROJECT_VERSION}")
  endif()
  if(NOT BUILD_SHARED_LIBS)
    foreach(name IN LISTS OpenMP_CXX_LIB_NAMES)
      get_filename_component(folder ${OpenMP_${name}_LIBRARY} DIRECTORY)
      if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)  # clang's own
        string(APPEND pc_libs " -L${folder}")
      endif()
      string(APPEND pc_libs " -l${name}")
    endforeach()
    list(APPEND pc_requires ${static_requires})
  endif()
  list(JOIN pc_requires ", " pc_requires)
  configure_file(${LASIUS_CMAKE_DIR}/lasius.pc.in ${PROJECT_BINARY_DIR}/${pc}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT dev)
endfunction()

# Headers, generated headers and the package's config files; called once, after all libraries.
function(lasius_install_package)
  list(JOIN LASIUS_COMPONENTS "|" components)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/lasius DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
    REGEX "/lasius/(${components})(\\.h)?$" EXCLUDE)
  install(FILES ${PROJECT_BINARY_DIR}/core/lasius/export.h ${PROJECT_BINARY_DIR}/core/lasius/version.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lasius COMPONENT dev)

  set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/lasius)
  configure_package_config_file(${LASIUS_CMAKE_DIR}/lasius-config.cmake.in
    ${PROJECT_BINARY_DIR}/lasius-config.cmake INSTALL_DESTINATION ${destination}
    PATH_VARS LASIUS_MAPS_DESTINATION NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/lasius-config-version.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/lasius-config.cmake
    ${PROJECT_BINARY_DIR}/lasius-config-version.cmake
    DESTINATION ${destination} COMPONENT dev)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/maps/ DESTINATION ${LASIUS_MAPS_DESTINATION}
    COMPONENT program
    FILES_MATCHING PATTERN "*.map" PATTERN "*.pbm" PATTERN "*.geojson" PATTERN "arms/*.json"
    PATTERN "README.md")
  # The documents, with all that they link to, as they stand to each other in the repository.
  file(GLOB documents CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.md)
  install(FILES ${documents} ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
    DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
    FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.cpp" PATTERN "*.py" PATTERN "*.yaml" PATTERN "Doxyfile")
  install(FILES ${PROJECT_SOURCE_DIR}/maps/README.md ${PROJECT_SOURCE_DIR}/maps/fan400x200.png
    DESTINATION ${CMAKE_INSTALL_DOCDIR}/maps COMPONENT program)
  if(LASIUS_BUILD_ARM)
    install(FILES ${LASIUS_CMAKE_DIR}/LasiusArmLibraries.cmake DESTINATION ${destination}
      COMPONENT dev)
  endif()
endfunction()
