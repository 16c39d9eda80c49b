# What is downloaded through pip is pinned by hash, happens once, and is kept in QUARTER_CACHE.
include_guard()

set(QUARTER_CACHE ${PROJECT_SOURCE_DIR}/.cache CACHE PATH "Where downloads are kept")

# Sets <result> to a python3 that has pip, or to "".
function(quarter_find_pip result)
  set(${result} "" PARENT_SCOPE)
  foreach(python python3 /usr/bin/python3)
    execute_process(COMMAND ${python} -m pip --version RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(failed EQUAL 0)
      set(${result} ${python} PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()
