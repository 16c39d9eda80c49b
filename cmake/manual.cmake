# The manual: quarter(1), a page a command, quarter-mission(5) and quarter-policy(5), made of what the command itself prints.
find_program(SCDOC scdoc)
find_program(MANUAL_PYTHON python3)
if(SCDOC AND MANUAL_PYTHON)
  set(QUARTER_MANUAL ${PROJECT_BINARY_DIR}/manual CACHE INTERNAL "Where the manual's pages are made; empty: they are not")
  file(GLOB manual_makers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/manual/*.py)
  add_custom_command(OUTPUT ${QUARTER_MANUAL}/quarter.1
    COMMAND ${MANUAL_PYTHON} -B ${PROJECT_SOURCE_DIR}/tools/manual/make_pages.py --quarter $<TARGET_FILE:quarter>
      --source ${PROJECT_SOURCE_DIR} --scdoc ${SCDOC} ${QUARTER_MANUAL}
    DEPENDS quarter ${manual_makers} ${PROJECT_SOURCE_DIR}/docs/policy-format.md VERBATIM)
  add_custom_target(manual ALL DEPENDS ${QUARTER_MANUAL}/quarter.1)
  foreach(section 1 5)
    if(QUARTER_INSTALL)
      install(DIRECTORY ${QUARTER_MANUAL}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT tools
        FILES_MATCHING PATTERN "*.${section}")
    endif()
  endforeach()
else()
  set(QUARTER_MANUAL "" CACHE INTERNAL "Where the manual's pages are made; empty: they are not")
  message(STATUS "Quarter makes no man pages: scdoc or python3 is missing (packages scdoc, python3)")
endif()
