# The robot side as a component of an ESP-IDF project; single sizes by idf_build_set_property(COMPILE_DEFINITIONS ... APPEND) in
# the project, for application and library must agree on them.
set(quarter ${CMAKE_CURRENT_LIST_DIR}/..)
file(GLOB quarter_sources ${quarter}/lib/core/*.c ${quarter}/lib/robot/*.c)
idf_component_register(SRCS ${quarter_sources} INCLUDE_DIRS include PRIV_INCLUDE_DIRS lib)
