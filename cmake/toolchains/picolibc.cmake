# A program over picolibc that talks to whoever emulates it. Included by the toolchain files, which set board_arch,
# board_memory and board_emulator.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY) # nothing can be linked before there is a memory layout
set(CMAKE_C_FLAGS_INIT "${board_arch} --specs=picolibc.specs -ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT} -fno-exceptions -fno-rtti")
list(TRANSFORM board_memory REPLACE "([0-9])K$" "\\1*1024")
list(TRANSFORM board_memory REPLACE "([0-9])M$" "\\1*1024*1024")
set(CMAKE_EXE_LINKER_FLAGS_INIT "--oslib=semihost --crt0=semihost -Wl,--gc-sections")
foreach(symbol IN LISTS board_memory)
  string(REGEX MATCH "^([a-z_]+)=(.*)$" symbol "${symbol}")
  math(EXPR value "${CMAKE_MATCH_2}" OUTPUT_FORMAT HEXADECIMAL)
  string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT ",--defsym=${CMAKE_MATCH_1}=${value}")
endforeach()
set(CMAKE_CROSSCOMPILING_EMULATOR ${board_emulator} -nographic -monitor none -serial none
  -semihosting-config enable=on,target=native -kernel)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
