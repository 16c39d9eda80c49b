"""The boards of docs/sizes.md, built and measured."""

import re
import shutil
import subprocess
from collections import namedtuple

import call_graph

Board = namedtuple("Board", "name title prefix")
BOARDS = [
    Board("cortex-m0plus", "Cortex-M0+", "arm-none-eabi-"),
    Board("cortex-m3", "Cortex-M3", "arm-none-eabi-"),
    Board("cortex-m4f", "Cortex-M4F", "arm-none-eabi-"),
    Board("rv32imac", "RV32IMAC", "riscv64-unknown-elf-"),
]
COUNTED = BOARDS[:2]
EMULATORS = {"arm-none-eabi-": "qemu-system-arm", "riscv64-unknown-elf-": "qemu-system-riscv32"}


class Missing(Exception):
    """What this machine has not got."""


def output_of(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, encoding="utf-8", **options).stdout


def compiler_of(board):
    return board.prefix + "gcc"


def look_for_tools():
    for board in BOARDS:
        for program in (compiler_of(board), EMULATORS[board.prefix]):
            if not shutil.which(program):
                raise Missing(f"there is no {program}")


def picolibc_version(board):
    probe = [compiler_of(board), "--specs=picolibc.specs", "-E", "-dM", "-x", "c", "-"]
    done = subprocess.run(probe, input="#include <picolibc.h>\n", capture_output=True, encoding="utf-8")
    found = re.search(r'#define _*PICOLIBC_VERSION_* "([^"]+)"', done.stdout)
    if not found:
        raise Missing(f"{compiler_of(board)} has no picolibc")
    return found.group(1)


def versions():
    """What numbers depend on, in words."""
    told = []
    for board in {board.prefix: board for board in BOARDS}.values():
        compiler = compiler_of(board)
        told.append(f"{compiler} {output_of(compiler, '-dumpfullversion').strip()} (picolibc {picolibc_version(board)})")
    return ", ".join(told)


def build(board, project, cmake, generator, work, tables):
    folder = work / board.name
    toolchain = project / "cmake" / "toolchains" / f"{board.name}.cmake"
    output_of(cmake, "-S", project / "tests" / "sizes", "-B", folder, "-G", generator,
              f"-DCMAKE_TOOLCHAIN_FILE={toolchain}", f"-DTABLES={tables}")
    done = subprocess.run([cmake, "--build", str(folder)], capture_output=True, encoding="utf-8")
    if done.returncode != 0:
        raise SystemExit(done.stdout + done.stderr)
    return folder


def flash_of(board, image):
    """Bytes of code and constants, and of data that begins with a value."""
    text, data = output_of(board.prefix + "size", image).splitlines()[1].split()[:2]
    return int(text) + int(data)


def symbols_of(board, image):
    """{name: bytes}; a variable of a function goes by its name there."""
    sizes = {}
    for line in output_of(board.prefix + "nm", "-S", image).splitlines():
        words = line.split()
        if len(words) == 4:
            sizes[words[3].split(".")[0]] = int(words[1], 16)
    return sizes


def emulate(folder, program, *options):
    """What a program prints, {name: number}. QEMU has no word for a program's output: it is on standard error."""
    emulator = (folder / "emulator").read_text(encoding="utf-8").split(";")
    command = [*emulator[:-1], *options, emulator[-1], str(folder / program)]
    done = subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          encoding="utf-8")
    return {name: int(number) for name, number in (line.split() for line in done.stdout.splitlines())}


def image_measures(board, folder, terms):
    """Of the images with or without the field's terms, as tests/sizes/CMakeLists.txt names them."""
    kind = "terms" if terms else "plain"
    flash = {name: flash_of(board, folder / f"{kind}_{name}") for name in ("loop", "loop_lto", "whole", "whole_lto")}
    whole = f"{kind}_whole"
    symbols = symbols_of(board, folder / whole)
    stack, way = call_graph.worst_stack(board.prefix + "objdump", folder / whole, folder / "CMakeFiles" / f"{whole}.dir", "loop")
    painted = emulate(folder, f"{kind}_painted")["painted"]
    if painted > stack:
        raise SystemExit(f"{board.title}: the loop went {painted} B deep, and its calls take {stack} B at most")
    return {
        **flash,
        "restart": flash["whole"] - flash["loop"],
        "restart_lto": flash["whole_lto"] - flash["loop_lto"],
        "divides": any("div" in name and name.startswith("__") for name in symbols),
        "stack": stack,
        "way": way,
        "painted": painted,
        "policy": symbols["policy"],
        "seeker": symbols["seeker"],
        "field": symbols["field"],
        "ram": symbols["policy"] + symbols["seeker"] + symbols["field"],
    }


def counts_of(folder):
    return emulate(folder, "counts", "-icount", "shift=7")
