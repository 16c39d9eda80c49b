# Installs the build tree BUILD into WORK, builds the project SOURCE with nothing but what was installed, and runs it.
function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
set(sanitize "")
if(SANITIZE)
  set(sanitize -DCMAKE_C_FLAGS=-fsanitize=address,undefined -DCMAKE_CXX_FLAGS=-fsanitize=address,undefined)
endif()
step(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/prefix)
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_C_COMPILER=${CC}
  -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF ${sanitize})
step(${CMAKE_COMMAND} --build ${WORK}/build)
step(${WORK}/build/consumer_robot)
step(${WORK}/build/consumer_planner)
if(EXISTS ${WORK}/build/consumer_headers)
  step(${WORK}/build/consumer_headers)
endif()
