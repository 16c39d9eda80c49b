# quarter_add_policy(<target> <mission> [NAME <name>] [OPTIONS <option>...]): learn the mission at build time and link its table into
# the target, as the constants <name>[] and <name>_size; <name> is the mission file's own, if it is not given. OPTIONS are
# those of `quarter learn`.
#
# The host command is QUARTER_COMMAND if that is set, else the one that this build makes, else an installed one; a cross build
# of the sources makes one for the host.
include_guard()

function(quarter_make_native_command)
  if(TARGET quarter_native)
    return()
  endif()
  include(ExternalProject)
  set(folder ${PROJECT_BINARY_DIR}/quarter-native)
  ExternalProject_Add(quarter_native
    SOURCE_DIR ${QUARTER_SOURCES} BINARY_DIR ${folder} PREFIX ${folder}-steps INSTALL_COMMAND "" BUILD_ALWAYS ON
    CMAKE_ARGS -DCMAKE_BUILD_TYPE=Release -DQUARTER_BUILD_TESTS=OFF -DQUARTER_BUILD_DEMO=OFF -DQUARTER_BUILD_PAPER=OFF
      -DQUARTER_INSTALL=OFF
    BUILD_COMMAND ${CMAKE_COMMAND} --build ${folder} --target quarter
    BUILD_BYPRODUCTS ${folder}/quarter EXCLUDE_FROM_ALL ON)
endfunction()

# Sets <command> to the host command, and <needs> to what a rule that runs it depends on.
function(quarter_find_command command needs)
  if(QUARTER_COMMAND)
    set(found ${QUARTER_COMMAND})
    set(depends ${QUARTER_COMMAND})
  elseif(TARGET quarter AND NOT CMAKE_CROSSCOMPILING)
    set(found $<TARGET_FILE:quarter>)
    set(depends quarter)
  elseif(QUARTER_SOURCES)
    quarter_make_native_command()
    set(found ${PROJECT_BINARY_DIR}/quarter-native/quarter)
    set(depends quarter_native ${found})
  else()
    get_filename_component(prefix ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../.. ABSOLUTE)
    find_program(QUARTER_PROGRAM quarter REQUIRED HINTS ${prefix}/bin ${prefix}/../bin)
    set(found ${QUARTER_PROGRAM})
    set(depends ${QUARTER_PROGRAM})
  endif()
  set(${command} ${found} PARENT_SCOPE)
  set(${needs} ${depends} PARENT_SCOPE)
endfunction()

function(quarter_add_policy target mission)
  cmake_parse_arguments(PARSE_ARGV 2 POLICY "" "NAME" "OPTIONS")
  get_filename_component(mission ${mission} ABSOLUTE)
  if(NOT POLICY_NAME)
    get_filename_component(POLICY_NAME ${mission} NAME_WE)
  endif()
  quarter_find_command(command needs)
  set(table ${CMAKE_CURRENT_BINARY_DIR}/${POLICY_NAME})
  get_filename_component(folder ${mission} DIRECTORY)
  file(GLOB beside CONFIGURE_DEPENDS ${folder}/*.yaml ${folder}/*.pgm ${folder}/*.png ${folder}/*.bmp ${folder}/*.csv
    ${folder}/*.map ${folder}/*.txt)
  add_custom_command(OUTPUT ${table}.c BYPRODUCTS ${table}.qtr
    COMMAND ${command} learn ${mission} -q ${POLICY_OPTIONS} -o ${table}.qtr --c ${table}.c
    DEPENDS ${mission} ${beside} ${needs} COMMENT "Learning ${POLICY_NAME}" VERBATIM)
  target_sources(${target} PRIVATE ${table}.c)
endfunction()
