# Gives the demo LCM (target lcm, the program lcm-gen) and Box2D (target box2d::box2d): copies that
# find_package finds, or else the wheels pinned in requirements-demo.txt.
include(${CMAKE_CURRENT_LIST_DIR}/pip.cmake)

set(QUARTER_DEMO_WHEELS ${QUARTER_CACHE}/demo)

function(quarter_fetch_demo_wheels)
  if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|aarch64|arm64)$")
    message(FATAL_ERROR "There are no LCM and Box2D wheels for ${CMAKE_SYSTEM_PROCESSOR}: install LCM 1.5.3 and Box2D 3.1 "
      "where find_package finds them, or give -DQUARTER_BUILD_DEMO=OFF")
  endif()
  string(REGEX REPLACE "AMD64" "x86_64" machine "${CMAKE_SYSTEM_PROCESSOR}")
  string(REGEX REPLACE "arm64" "aarch64" machine "${machine}")
  quarter_pip_install(${QUARTER_DEMO_WHEELS} ${PROJECT_SOURCE_DIR}/cmake/requirements-demo.txt
    --python-version 3.11 --implementation cp --platform manylinux_2_28_${machine} --platform manylinux_2_27_${machine})
endfunction()

find_package(lcm 1.5.3 CONFIG QUIET)
find_package(box2d 3.1 CONFIG QUIET)
if(NOT lcm_FOUND OR NOT box2d_FOUND)
  quarter_fetch_demo_wheels()
  # pip leaves the programs of a wheel without their mark of being programs.
  file(GLOB programs ${QUARTER_DEMO_WHEELS}/bin/*)
  file(CHMOD ${programs} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endif()
if(NOT lcm_FOUND)
  find_package(lcm 1.5.3 CONFIG REQUIRED PATHS ${QUARTER_DEMO_WHEELS}/lib/lcm/cmake NO_DEFAULT_PATH)
endif()
if(NOT box2d_FOUND)
  find_package(box2d CONFIG REQUIRED PATHS ${QUARTER_DEMO_WHEELS}/lib64/cmake/box2d NO_DEFAULT_PATH)
endif()

# Where LCM's programs lie: lcm-logger, lcm-logplayer and others.
get_target_property(programs lcm-gen LOCATION)
get_filename_component(programs ${programs} DIRECTORY)
set(QUARTER_LCM_PROGRAMS ${programs} CACHE INTERNAL "Folder of LCM's programs")
