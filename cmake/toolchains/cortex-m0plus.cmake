# Cortex-M0+. QEMU has no board with one that is large enough: its code runs on a Cortex-M3, which knows all its instructions.
set(board_cpu "-mcpu=cortex-m0plus -mfloat-abi=soft")
set(board_machine mps2-an385)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
