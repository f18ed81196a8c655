# The manual pages, of what the program says when it is linked, and the shells' completion.
if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
  set(manual ${PROJECT_BINARY_DIR}/man)
  add_custom_command(TARGET lasius_program POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${manual}
    COMMAND ${LASIUS_MAKE_MANUAL} pages $<TARGET_FILE:lasius_program> ${manual}
    COMMAND sh -c "gzip -9nf man/*.1"
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR} VERBATIM)
  set(others "")
  if(NOT LASIUS_BUILD_MPI)
    set(others PATTERN lasius_mpi.1* EXCLUDE)
  endif()
  install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program ${others})
endif()

set(shells ${CMAKE_CURRENT_SOURCE_DIR}/manual/shells)
set(programs lasius)
if(LASIUS_BUILD_MPI)
  list(APPEND programs lasius_mpi)
endif()
foreach(name IN LISTS programs)  # bash and fish look for a file of the command's name
  install(FILES ${shells}/lasius.bash DESTINATION share/bash-completion/completions RENAME ${name}
    COMPONENT program)
  install(FILES ${shells}/lasius.fish DESTINATION share/fish/vendor_completions.d RENAME ${name}.fish
    COMPONENT program)
endforeach()
set(zsh_functions share/zsh/site-functions)
if(LASIUS_DEBIAN)
  set(zsh_functions share/zsh/vendor-completions)
endif()
install(FILES ${shells}/_lasius DESTINATION ${zsh_functions} COMPONENT program)
