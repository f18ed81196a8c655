# lasius_mpi for Open MPI and for MPICH, as pkg-config finds them: lasius_mpi.openmpi and lasius_mpi.mpich,
# and lasius_mpi, which is the first of them.
pkg_check_modules(openmpi QUIET IMPORTED_TARGET ompi-c)
pkg_check_modules(mpich QUIET IMPORTED_TARGET mpich)
set(LASIUS_MPI "")
foreach(mpi IN ITEMS openmpi mpich)
  if(NOT TARGET PkgConfig::${mpi})
    continue()
  endif()
  list(APPEND LASIUS_MPI ${mpi})
  add_executable(lasius_mpi_${mpi} mpi/mpi_main.cpp mpi/mpi_crew.cpp mpi/letters.cpp
                 mpi/seats.cpp)
  set_target_properties(lasius_mpi_${mpi} PROPERTIES OUTPUT_NAME lasius_mpi.${mpi})
  # Its C interface only.
  target_compile_definitions(lasius_mpi_${mpi} PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  target_link_libraries(lasius_mpi_${mpi} PRIVATE lasius_commands PkgConfig::${mpi})
endforeach()
if(NOT LASIUS_MPI)
  message(FATAL_ERROR "lasius_mpi needs libopenmpi-dev or libmpich-dev: install one (tools/setup mpi), or set LASIUS_BUILD_MPI=OFF")
endif()
list(GET LASIUS_MPI 0 first)
add_custom_command(TARGET lasius_mpi_${first} POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E create_symlink lasius_mpi.${first} lasius_mpi
  WORKING_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} VERBATIM)
if(LASIUS_INSTALL)
  foreach(mpi IN LISTS LASIUS_MPI)
    install(TARGETS lasius_mpi_${mpi} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  endforeach()
  install(PROGRAMS ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/lasius_mpi DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
