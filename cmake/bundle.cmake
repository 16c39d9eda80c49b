# The target `bundle`: the robot side as two files, quarter_robot.h and quarter_robot.c in the build tree's folder bundle.
find_program(QUARTER_PYTHON python3)
if(QUARTER_PYTHON)
  set(QUARTER_BUNDLE ${PROJECT_BINARY_DIR}/bundle)
  file(GLOB bundled CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/quarter/*.h ${PROJECT_SOURCE_DIR}/lib/core/*.[ch]
    ${PROJECT_SOURCE_DIR}/lib/robot/*.[ch])
  add_custom_command(OUTPUT ${QUARTER_BUNDLE}/quarter_robot.c ${QUARTER_BUNDLE}/quarter_robot.h
    COMMAND ${QUARTER_PYTHON} -B ${PROJECT_SOURCE_DIR}/cmake/bundle.py ${PROJECT_SOURCE_DIR} ${QUARTER_BUNDLE}
    DEPENDS ${bundled} ${PROJECT_SOURCE_DIR}/cmake/bundle.py ${PROJECT_SOURCE_DIR}/LICENSE VERBATIM)
  add_custom_target(bundle DEPENDS ${QUARTER_BUNDLE}/quarter_robot.c)
endif()
