# Most of a small file's time goes into the templates of headers, which files that are compiled together
# share. With LASIUS_UNITY not walks, sight, exact searches and orders of stops: what is inlined there is
# measured. With LASIUS_SHORT_BUILD all of them, several modules at a time: for sanitizers and for clang-tidy, which
# looks through all headers once more for each.

# lasius_unite_modules(TARGET REGEX): the sources in each folder that the expression matches are compiled as one.
function(lasius_unite_modules target regex)
  if(NOT LASIUS_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(module ${source} DIRECTORY)
    if(module MATCHES "${regex}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${module})
    endif()
  endforeach()
endfunction()

# lasius_unite(TARGET [GROUP SOURCE...]): with LASIUS_UNITY the sources of a group are compiled as one;
# without a group all sources of the target, several at a time in the order of its list.
function(lasius_unite target)
  if(NOT LASIUS_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  # Given for unnamed namespaces in every file that is included, be it no header.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  if(ARGC EQUAL 1)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  list(POP_FRONT ARGN group)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
endfunction()

# lasius_unite_for_short_build(TARGET GROUP...): with LASIUS_SHORT_BUILD the modules (folders) that each GROUP names, "a b/c",
# are compiled as one, whatever else is united.
function(lasius_unite_for_short_build target)
  if(NOT LASIUS_UNITY OR NOT LASIUS_SHORT_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(group IN LISTS ARGN)
    separate_arguments(modules UNIX_COMMAND "${group}")
    list(GET modules 0 name)
    foreach(source IN LISTS sources)
      get_filename_component(module ${source} DIRECTORY)
      if(module IN_LIST modules)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP "with_${name}")
      endif()
    endforeach()
  endforeach()
endfunction()
