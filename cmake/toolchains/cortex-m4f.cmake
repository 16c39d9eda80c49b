# Cortex-M4 with its floating point unit, which knows singles alone: doubles are software's. On QEMU's mps2-an386.
set(board_cpu "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16")
set(board_machine mps2-an386)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
