# SPDX-License-Identifier: GPL-3.0-or-later
# headers_alone(<target> <folder> <library>...): an object library with one source per header under
# <folder>, a path from the top of the project, that includes this header first and nothing else, and
# twice: it must bring what it needs and stand being included again.
function(headers_alone target folder)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
       ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  if(NOT headers)
    message(FATAL_ERROR "headers_alone: no headers in ${folder}")
  endif()
  set(sources)
  foreach(header IN LISTS headers)
    string(REPLACE "/" "_" name ${header})
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${target}/${name}.cpp)
    # Written only if it changes, so that configuring again does not compile again.
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n#include \"${header}\"\n")
    list(APPEND sources ${source})
  endforeach()
  add_library(${target} OBJECT ${sources})
  flatland_target(${target})
  target_link_libraries(${target} PRIVATE ${ARGN})
endfunction()
