# Cortex-M3, on QEMU's mps2-an385.
set(board_cpu "-mcpu=cortex-m3 -mfloat-abi=soft")
set(board_machine mps2-an385)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
