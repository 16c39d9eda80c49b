# What the Cortex-M boards have in common: arm-none-eabi-gcc, picolibc, and QEMU's MPS2 boards by semihosting, so that programs
# print, and end with their exit status, as on a host. Included by a board's toolchain file, which sets board_cpu and
# board_machine.
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(board_arch "-mthumb ${board_cpu}")
set(board_memory __flash=0 __flash_size=4M __ram=0x20000000 __ram_size=4M __stack_size=32K)
set(board_emulator qemu-system-arm -M ${board_machine})
include(${CMAKE_CURRENT_LIST_DIR}/picolibc.cmake)
