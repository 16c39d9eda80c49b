# find_package(quarter COMPONENTS robot learn) gives quarter::robot and quarter::learn, pkg-config quarter-robot and quarter-learn.
# `cmake --install BUILD --component robot` installs the robot side alone.
include(CMakePackageConfigHelpers)

# quarter_reached_headers(<result> <header>...): these public headers and those that they include, directly or not.
function(quarter_reached_headers result)
  set(reached "")
  set(left ${ARGN})
  while(left)
    list(POP_FRONT left header)
    if(NOT header IN_LIST reached)
      list(APPEND reached ${header})
      file(STRINGS ${PROJECT_SOURCE_DIR}/include/${header} lines REGEX "^#include \"quarter/")
      string(REGEX MATCHALL "quarter/[a-z_]+\\.h" lines "${lines}")
      list(APPEND left ${lines})
    endif()
  endwhile()
  set(${result} ${reached} PARENT_SCOPE)
endfunction()

# quarter_install_side(<side> <library needed>...): library, headers and package files of a side, as a component of its name.
function(quarter_install_side side)
  install(TARGETS quarter_${side} EXPORT quarter-${side}-targets COMPONENT ${side}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${side}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${side}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${side})
  install(EXPORT quarter-${side}-targets NAMESPACE quarter:: DESTINATION ${package_folder} COMPONENT ${side})
  set(side ${side})
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  list(TRANSFORM QUARTER_SIZES PREPEND " -D" OUTPUT_VARIABLE sizes)
  list(JOIN sizes "" sizes)
  if(NOT QUARTER_PROFILE STREQUAL "host")
    string(TOUPPER ${QUARTER_PROFILE} profile)
    string(PREPEND sizes " -DQTR_PROFILE_${profile}")
  endif()
  list(JOIN ARGN " " needs)
  if(needs)
    set(maths " -lm")
  else()
    set(maths "")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/quarter.pc.in ${PROJECT_BINARY_DIR}/quarter-${side}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/quarter-${side}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${side})
endfunction()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/quarter)
quarter_install_side(robot)
if(TARGET quarter_learn)
  quarter_install_side(learn quarter-robot)
endif()

quarter_reached_headers(robot_headers quarter/robot.h)
list(TRANSFORM robot_headers PREPEND ${PROJECT_SOURCE_DIR}/include/ OUTPUT_VARIABLE robot_paths)
install(FILES ${robot_paths} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/quarter COMPONENT robot)
file(GLOB learn_headers RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/quarter/*.h)
list(REMOVE_ITEM learn_headers ${robot_headers})
list(TRANSFORM learn_headers PREPEND ${PROJECT_SOURCE_DIR}/include/)
if(TARGET quarter_learn)
  install(FILES ${learn_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/quarter COMPONENT learn)
endif()

write_basic_package_version_file(quarter-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/quarter-config.cmake ${PROJECT_SOURCE_DIR}/cmake/policy.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/quarter-config-version.cmake DESTINATION ${package_folder} COMPONENT robot)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT robot)
if(TARGET quarter)
  install(TARGETS quarter RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
endif()
