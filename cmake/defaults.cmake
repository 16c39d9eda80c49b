# quarter_defaults(<target> <C standard> CORE|TOOL|TEST): the warnings and the floating-point rule that all of Quarter's
# own code is built under. All compilers give the same bits: no fused multiply-add, no -ffast-math.
set(quarter_warnings -Wall -Wextra -Wpedantic -Wundef -Wvla -Wpointer-arith -Wwrite-strings -Wformat=2
  -Wstrict-prototypes -Wold-style-definition)
set(quarter_warnings_CORE -Wshadow -Wdouble-promotion)
# Not for tests: Unity's macros convert on their own account, and a test has no header of its own.
set(quarter_warnings_product -Wconversion -Wsign-conversion -Wfloat-conversion -Wcast-align -Wcast-qual
  -Wmissing-prototypes -Wredundant-decls)
# In tools and tests a variable may be named as its type: `fault *fault`. avr-gcc is a GCC 5 here, and cannot tell.
if(NOT CMAKE_C_COMPILER_ID STREQUAL "GNU")
  set(quarter_warnings_TOOL -Wshadow)
elseif(CMAKE_C_COMPILER_VERSION VERSION_LESS 7)
  list(APPEND quarter_warnings_product -Wlogical-op)
else()
  set(quarter_warnings_TOOL -Wshadow=local)
  list(APPEND quarter_warnings_product -Wlogical-op -Wduplicated-cond)
endif()
set(quarter_warnings_TEST ${quarter_warnings_TOOL})

function(quarter_defaults target standard kind)
  set_target_properties(${target} PROPERTIES C_STANDARD ${standard} C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
  if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -ffp-contract=off ${quarter_warnings} ${quarter_warnings_${kind}}
      $<$<BOOL:${QUARTER_WERROR}>:-Werror>)
    if(NOT kind STREQUAL "TEST")
      target_compile_options(${target} PRIVATE ${quarter_warnings_product})
    endif()
  endif()
endfunction()
