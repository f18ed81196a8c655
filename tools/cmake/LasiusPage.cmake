# The page of reports as one script: the modules of tools/report/page in an order in which each
# follows those that it imports, without their import lines and the word export. So names at the top
# of modules are unique, an import is one line, and nothing is renamed or exported as default.
function(lasius_bundle_page folder result)
  set(script "")
  foreach(name IN ITEMS ${ARGN})
    set(file ${folder}/${name}.js)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(REGEX REPLACE "(^|\n)import [^\n]*" "\\1" text "${text}")
    string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
    string(APPEND script "${text}\n")
  endforeach()
  set(${result} "${script}" PARENT_SCOPE)
endfunction()
