# Sets QUARTER_CHARTS to a folder for PYTHONPATH that holds the chart library of docs/paper.md, pinned in
# requirements-charts.txt: wheels of pure Python, installed there and nowhere else.
include(${CMAKE_CURRENT_LIST_DIR}/pip.cmake)

set(QUARTER_CHARTS ${QUARTER_CACHE}/charts)

function(quarter_fetch_charts)
  set(pins ${PROJECT_SOURCE_DIR}/cmake/requirements-charts.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${pins})
  file(SHA256 ${pins} wanted)
  set(stamp ${QUARTER_CHARTS}/pins.sha256)
  if(EXISTS ${stamp})
    file(READ ${stamp} found)
    if(found STREQUAL wanted)
      return()
    endif()
  endif()
  quarter_find_pip(python)
  if(NOT python)
    message(FATAL_ERROR "The charts' library must be downloaded, and there is no pip: install the packages python3 and "
      "python3-pip")
  endif()
  message(STATUS "Downloading the charts' library")
  set(folder ${PROJECT_BINARY_DIR}/charts)
  file(REMOVE_RECURSE ${folder} ${QUARTER_CHARTS})
  file(MAKE_DIRECTORY ${QUARTER_CACHE})
  execute_process(
    COMMAND ${python} -m pip install --quiet --disable-pip-version-check --no-input --no-deps --require-hashes
      --only-binary :all: --root-user-action ignore --target ${folder} -r ${pins}
    RESULT_VARIABLE failed)
  if(NOT failed EQUAL 0)
    message(FATAL_ERROR "pip could not install what ${pins} names, see above. Mend the network or pip's settings")
  endif()
  file(WRITE ${folder}/pins.sha256 ${wanted})
  file(RENAME ${folder} ${QUARTER_CHARTS})
endfunction()

quarter_fetch_charts()
