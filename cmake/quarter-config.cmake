include(${CMAKE_CURRENT_LIST_DIR}/quarter-targets.cmake)
