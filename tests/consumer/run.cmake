# A project of its own, SOURCE, that has nothing but what is installed: from the build tree BUILD all, then the robot side alone;
# from a build of the core alone under sizes of its own (ROOT), shared libraries. Each is built in WORK and run.
function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(expect_failure)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    message(FATAL_ERROR "It went well: ${ARGV}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(settings -G ${GENERATOR} -DCMAKE_C_COMPILER=${CC} -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
if(SANITIZE)
  list(APPEND settings -DCMAKE_C_FLAGS=-fsanitize=address,undefined -DCMAKE_CXX_FLAGS=-fsanitize=address,undefined)
endif()

# build_and_run(<name> <option>...): the project against what was installed to WORK/<name>.
function(build_and_run name)
  step(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/${name}-build ${settings} -DCMAKE_PREFIX_PATH=${WORK}/${name} ${ARGN})
  step(${CMAKE_COMMAND} --build ${WORK}/${name}-build)
  foreach(program robot planner headers)
    if(EXISTS ${WORK}/${name}-build/consumer_${program})
      step(${WORK}/${name}-build/consumer_${program})
    endif()
  endforeach()
endfunction()

# By pkg-config, where it is: the robot's program without CMake.
function(build_by_pkg_config name)
  find_program(PKG_CONFIG pkg-config)
  file(GLOB_RECURSE description ${WORK}/${name}/quarter-robot.pc)
  if(NOT PKG_CONFIG OR SANITIZE)
    return()
  endif()
  get_filename_component(folder ${description} DIRECTORY)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} ${PKG_CONFIG} --cflags --libs quarter-robot
    OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY OUTPUT_STRIP_TRAILING_WHITESPACE)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  get_filename_component(libraries ${folder} DIRECTORY)
  step(${CC} -std=c99 ${SOURCE}/robot.c -o ${WORK}/${name}-by-hand ${flags} -Wl,-rpath,${libraries})
  step(${WORK}/${name}-by-hand)
endfunction()

step(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/all)
build_and_run(all)
build_by_pkg_config(all)

step(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/robot --component robot)
build_and_run(robot -DSIDES=robot)
expect_failure(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/no-learner ${settings} -DCMAKE_PREFIX_PATH=${WORK}/robot)
file(GLOB_RECURSE of_the_learner ${WORK}/robot/*learn*)
if(of_the_learner)
  message(FATAL_ERROR "The robot side alone brings ${of_the_learner}")
endif()
file(GLOB_RECURSE licence ${WORK}/robot/*LICENSE)
if(NOT licence)
  message(FATAL_ERROR "The licence is not installed")
endif()

step(${CMAKE_COMMAND} -S ${ROOT} -B ${WORK}/core ${settings} -DBUILD_SHARED_LIBS=ON -DQUARTER_BUILD_TOOLS=OFF
  -DQUARTER_BUILD_TESTS=OFF -DQUARTER_BUILD_DEMO=OFF -DQUARTER_BUILD_PAPER=OFF -DQUARTER_PROFILE=mcu
  "-DQUARTER_SIZES=QTR_MAX_CELLS=400\;QTR_MAX_PLACES=9")
step(${CMAKE_COMMAND} --build ${WORK}/core)
step(${CMAKE_COMMAND} --install ${WORK}/core --config ${CONFIG} --prefix ${WORK}/shared)
build_and_run(shared -DQUARTER_COMMAND=${TOOL})
build_by_pkg_config(shared)
