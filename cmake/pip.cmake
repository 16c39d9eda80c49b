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

# quarter_pip_install(<folder> <requirements> [option...]): the wheels that the requirements pin, unpacked into the folder,
# unless they are there already. Nothing is compiled, no code of theirs runs.
function(quarter_pip_install folder requirements)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${requirements})
  file(SHA256 ${requirements} wanted)
  if(EXISTS ${folder}/pins.sha256)
    file(READ ${folder}/pins.sha256 found)
    if(found STREQUAL wanted)
      return()
    endif()
  endif()
  get_filename_component(name ${folder} NAME)
  quarter_find_pip(python)
  if(NOT python)
    message(FATAL_ERROR "What ${requirements} names must be downloaded, and there is no pip: install the packages "
      "python3 and python3-pip")
  endif()
  message(STATUS "Downloading ${name}")
  set(fresh ${PROJECT_BINARY_DIR}/download-${name})
  file(REMOVE_RECURSE ${fresh} ${folder})
  file(MAKE_DIRECTORY ${QUARTER_CACHE})
  execute_process(
    COMMAND ${python} -m pip install --quiet --disable-pip-version-check --no-input --no-deps --require-hashes
      --only-binary :all: --root-user-action ignore ${ARGN} --target ${fresh} -r ${requirements}
    RESULT_VARIABLE failed)
  if(NOT failed EQUAL 0)
    message(FATAL_ERROR "pip could not install what ${requirements} names, see above. Mend the network or pip's settings")
  endif()
  file(WRITE ${fresh}/pins.sha256 ${wanted})
  file(RENAME ${fresh} ${folder})
endfunction()
