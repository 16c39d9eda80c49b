# quarter_cut_readme_loop(<file>): README.md's robot loop, cut out word for word.
include_guard()

function(quarter_cut_readme_loop file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../README.md)
  file(READ ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../README.md loop)
  string(FIND "${loop}" "```c\n" begin)
  string(SUBSTRING "${loop}" ${begin} -1 loop)
  string(SUBSTRING "${loop}" 5 -1 loop)
  string(FIND "${loop}" "```" end)
  string(SUBSTRING "${loop}" 0 ${end} loop)
  file(CONFIGURE OUTPUT ${file} CONTENT "${loop}" @ONLY)
endfunction()
