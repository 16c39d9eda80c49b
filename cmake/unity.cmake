# Gives the target quarter_unity: Unity 2.7, the tests' framework. One that find_package finds will do; otherwise it
# comes from the source distribution pinned in requirements.txt, which pip checks by hash. The download is kept in
# QUARTER_CACHE, so that this happens once, and only that download touches the network.
include(CheckCSourceCompiles)
include(${CMAKE_CURRENT_LIST_DIR}/pip.cmake)

# Download the source distribution named in requirements.txt to <archive>, without running any code that it holds.
function(quarter_download archive)
  quarter_find_pip(python)
  if(NOT python)
    message(FATAL_ERROR "Unity must be downloaded, and there is no pip: install the packages python3 and python3-pip")
  endif()
  get_filename_component(name ${archive} NAME)
  set(folder ${PROJECT_BINARY_DIR}/download)
  file(REMOVE_RECURSE ${folder})
  file(MAKE_DIRECTORY ${folder} ${QUARTER_CACHE})
  message(STATUS "Downloading ${name}")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/no_build:$ENV{PYTHONPATH} PYTHONDONTWRITEBYTECODE=1
      ${python} -m pip download --quiet --disable-pip-version-check --no-input --no-deps --require-hashes
      --no-binary :all: --no-build-isolation --dest ${folder} -r ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/requirements.txt
    WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed)
  if(NOT failed EQUAL 0 OR NOT EXISTS ${folder}/${name})
    message(FATAL_ERROR "pip could not download ${name}, see above. Mend the network or pip's settings, put that file "
      "into ${QUARTER_CACHE} by hand, or install Unity 2.7 where find_package finds it")
  endif()
  file(RENAME ${folder}/${name} ${archive})
endfunction()

function(quarter_fetch_unity)
  file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/requirements.txt pin REGEX "^pytest-unity==")
  string(REGEX MATCH "==([0-9.]+) --hash=sha256:([0-9a-f]+)" pin "${pin}")
  set(name pytest_unity-${CMAKE_MATCH_1})
  set(hash ${CMAKE_MATCH_2})
  set(archive ${QUARTER_CACHE}/${name}.tar.gz)
  if(NOT EXISTS ${archive})
    quarter_download(${archive})
  endif()
  file(SHA256 ${archive} found)
  if(NOT found STREQUAL hash)
    message(FATAL_ERROR "${archive} is not the pinned file (sha256 ${found}): delete it, and configure again")
  endif()
  set(folder ${PROJECT_BINARY_DIR}/unity)
  if(NOT EXISTS ${folder}/${name}/vendor/unity/CMakeLists.txt)
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${folder} PATTERNS "${name}/vendor/unity/*")
  endif()
  add_subdirectory(${folder}/${name}/vendor/unity ${folder}/build EXCLUDE_FROM_ALL)
  target_compile_options(unity PRIVATE -Wno-error)
  target_compile_definitions(unity PUBLIC UNITY_INCLUDE_DOUBLE UNITY_SUPPORT_64)
endfunction()

find_package(unity 2.6 CONFIG QUIET)
if(TARGET unity::framework)
  set(CMAKE_REQUIRED_LIBRARIES unity::framework)
  set(CMAKE_REQUIRED_DEFINITIONS -DUNITY_INCLUDE_DOUBLE -DUNITY_SUPPORT_64)
  check_c_source_compiles("#include <unity.h>
    void setUp(void) {}
    void tearDown(void) {}
    int main(void) { TEST_ASSERT_EQUAL_DOUBLE(1.0, 1.0); return 0; }" QUARTER_UNITY_HAS_DOUBLES)
  if(NOT QUARTER_UNITY_HAS_DOUBLES)
    message(FATAL_ERROR "The Unity in ${unity_DIR} was built without doubles or 64-bit integers: build it with "
      "UNITY_INCLUDE_DOUBLE and UNITY_SUPPORT_64, or give -DCMAKE_DISABLE_FIND_PACKAGE_unity=ON to download another")
  endif()
else()
  quarter_fetch_unity()
endif()

add_library(quarter_unity INTERFACE)
target_link_libraries(quarter_unity INTERFACE unity::framework)
# tests/support/unity/unity_config.h: one test function by itself.
target_compile_definitions(quarter_unity INTERFACE UNITY_INCLUDE_DOUBLE UNITY_SUPPORT_64 UNITY_INCLUDE_CONFIG_H)
target_include_directories(quarter_unity INTERFACE ${CMAKE_CURRENT_LIST_DIR}/../tests/support/unity)
target_include_directories(quarter_unity SYSTEM INTERFACE
  $<TARGET_PROPERTY:unity::framework,INTERFACE_INCLUDE_DIRECTORIES>)
