# Libraries that single commands load when they run (lib/host/base/library.h): known at build time by header and name,
# never linked.
include_guard()

# quarter_find_loaded(<result> <header> <library> [suffix...]): sets <result> to the name by which the library is loaded (its
# SONAME) and <result>_INCLUDE_DIR to where its header is; <result> is empty where either is missing.
function(quarter_find_loaded result header library)
  set(${result} "" PARENT_SCOPE)
  find_path(${result}_INCLUDE_DIR ${header} PATH_SUFFIXES ${ARGN})
  find_library(${result}_LIBRARY ${library})
  if(NOT ${result}_INCLUDE_DIR OR NOT ${result}_LIBRARY)
    return()
  endif()
  execute_process(COMMAND ${CMAKE_READELF} -d ${${result}_LIBRARY} OUTPUT_VARIABLE told ERROR_QUIET)
  if(told MATCHES "SONAME[^\n]*\\[([^]\n]+)\\]")
    set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
  endif()
endfunction()
