# RISC-V, RV32IMAC, on QEMU's virt.
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(board_arch "-march=rv32imac -mabi=ilp32")
set(board_memory __flash=0x80000000 __flash_size=4M __ram=0x80400000 __ram_size=8M __stack_size=32K)
set(board_emulator qemu-system-riscv32 -M virt -bios none)
include(${CMAKE_CURRENT_LIST_DIR}/picolibc.cmake)
