"""run_board.py --toolchain FILE | --cc COMPILER [--flags=FLAGS] --source FOLDER --work FOLDER [--cmake WHERE]
[--define NAME=VALUE...]: a build by a toolchain file or by a compiler under flags, and its tests by plain ctest. Ends with 77
where its compiler, C library or emulator is not there, or this processor does not run what it makes.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(77)


def settings_of(toolchain):
    """The text of a toolchain file with all that it includes."""
    text = toolchain.read_text(encoding="utf-8")
    for name in re.findall(r"^include\(\$\{CMAKE_CURRENT_LIST_DIR\}/([\w-]+\.cmake)\)", text, re.MULTILINE):
        text += settings_of(toolchain.parent / name)
    return text


def look_for_tools(toolchain):
    text = settings_of(toolchain)
    compiler = re.search(r"set\(CMAKE_C_COMPILER (\S+)\)", text).group(1)
    emulator = re.search(r"set\((?:board_emulator|CMAKE_CROSSCOMPILING_EMULATOR) (qemu-[\w-]+|simavr)", text).group(1)
    for program in (compiler, emulator):
        if not shutil.which(program):
            skip(f"there is no {program}")
    if compiler == "avr-gcc":
        probe = [compiler, "-mmcu=atmega1284p", "-x", "c", "-E", "-o", "/dev/null", "-"]
        if subprocess.run(probe, input="#include <avr/io.h>\n", encoding="utf-8", stderr=subprocess.DEVNULL).returncode != 0:
            skip("avr-gcc has no avr-libc")
    if "--specs=picolibc.specs" in text:
        probe = [compiler, "--specs=picolibc.specs", "-x", "c", "-E", "-o", "/dev/null", "-"]
        if subprocess.run(probe, input="#include <stdio.h>\n", encoding="utf-8", stderr=subprocess.DEVNULL).returncode != 0:
            skip(f"{compiler} has no picolibc")


# With what is learnt from the flags: gcc's and clang's question to the processor.
TRIAL = """#include <math.h>
int main(void) {
#ifdef __AVX2__
  return !__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") || !__builtin_cpu_supports("bmi2");
#endif
  return 0;
}
"""


def runs_here(program):
    try:
        return subprocess.run([program.resolve()]).returncode == 0
    except OSError:  # made for another processor, as the system sees at once
        return False


def look_for_compiler(compiler, flags, folder):
    """That it makes programs under these flags, and that they run here."""
    if not shutil.which(compiler):
        skip(f"there is no {compiler}")
    folder.mkdir(parents=True, exist_ok=True)
    trial = folder / "trial"
    command = [compiler, *flags.split(), "-x", "c", "-", "-o", str(trial)]
    if subprocess.run(command, input=TRIAL, encoding="utf-8", stderr=subprocess.DEVNULL).returncode != 0:
        skip(f"{compiler} {flags} makes no program")
    if not runs_here(trial):
        skip(f"this processor does not run what {compiler} {flags} makes")


def run(*command):
    print("$", *command, flush=True)
    done = subprocess.run([str(word) for word in command])
    if done.returncode != 0:
        sys.exit(f"{command[0]} ended with {done.returncode}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--toolchain", type=pathlib.Path)
    parser.add_argument("--cc")
    parser.add_argument("--flags", default="")
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--ctest", default="ctest")
    parser.add_argument("--generator", default="Ninja")
    parser.add_argument("--define", action="append", default=[])
    options = parser.parse_args()
    definitions = [f"-D{definition}" for definition in options.define]
    if options.toolchain:
        look_for_tools(options.toolchain)
        definitions += [f"-DCMAKE_TOOLCHAIN_FILE={options.toolchain}", "-DCMAKE_BUILD_TYPE=Release"]
    else:
        look_for_compiler(options.cc, options.flags, options.work)
        definitions += [f"-DCMAKE_C_COMPILER={options.cc}", f"-DCMAKE_C_FLAGS={options.flags}"]
    run(options.cmake, "-S", options.source, "-B", options.work, "-G", options.generator, *definitions)
    run(options.cmake, "--build", options.work)
    run(options.ctest, "--test-dir", options.work, "--output-on-failure", "--no-tests=error")


main()
