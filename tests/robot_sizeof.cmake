# quarter_add_robot_sizeof(<test>): what the robot's structures take in builds of several array sizes, each compiled under its own.
include_guard()

set(sizeof_mcu QTR_PROFILE_MCU)
set(sizeof_least QTR_MAX_CELLS=1 QTR_MAX_PLACES=1 QTR_MAX_SEEKERS=1)
set(sizeof_odd QTR_MAX_CELLS=4095 QTR_MAX_PLACES=33 QTR_MAX_SEEKERS=7)
set(sizeof_words QTR_MAX_CELLS=4096 QTR_MAX_PLACES=64 QTR_MAX_SEEKERS=33)
set(sizeof_wide QTR_MAX_CELLS=65536 QTR_MAX_PLACES=1000 QTR_MAX_SEEKERS=64)

function(quarter_add_robot_sizeof test)
  foreach(build sizeof_mcu sizeof_least sizeof_odd sizeof_words sizeof_wide)
    add_library(${build} OBJECT ${PROJECT_SOURCE_DIR}/tests/support/robot_sizeof.c)
    quarter_defaults(${build} 11 TEST)
    target_include_directories(${build} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/include)
    target_compile_definitions(${build} PRIVATE ROBOT_SIZEOF=${build} ${${build}})
    target_sources(${test} PRIVATE $<TARGET_OBJECTS:${build}>)
  endforeach()
endfunction()
