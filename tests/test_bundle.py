"""test_bundle.py --bundle FOLDER --source FOLDER --library ROBOT.a --cc CC [--cxx CXX] [--nm NM]: the robot side in two files compiles alone
as C and as C++, without a warning, and holds what the library holds.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

from check_source import report, self_test

STRICT = ["-Wall", "-Wextra", "-Wshadow", "-Wundef", "-Werror"]
C_ONLY = ["-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wcast-qual", "-Wstrict-prototypes"]
PROFILES = [[], ["-DQTR_PROFILE_MCU"], ["-DQTR_PROFILE_MCU", "-DQTR_READ_FORMAT_1=1"], ["-DQTR_ASSERTIONS=1"]]


def ways(cc, cxx):
    """Compiler, language and flags: each profile as C99 and C++11, the first one in other ways too."""
    c = [cc, "-x", "c", *STRICT, *C_ONLY]
    found = [[*c, "-std=c99", *profile] for profile in PROFILES]
    found += [[*c, "-std=c11"], [*c, "-std=c99", "-ffreestanding", "-fno-builtin"]]
    if cxx:
        found += [[cxx, "-x", "c++", *STRICT, "-std=c++11", *profile] for profile in PROFILES]
        found += [[cxx, "-x", "c++", *STRICT, "-std=c++17"]]
    return found


def compile_all(folder, cc, cxx):
    faults = []
    for way in ways(cc, cxx):
        command = [*way, "-O1", "-c", "quarter_robot.c", "-o", "/dev/null"]
        done = subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", errors="replace")
        if done.returncode != 0:
            faults.append(" ".join(command) + "\n" + done.stderr)
    return faults


# Compilers call these on their own account, whatever the source says.
COMPILERS = {"memcpy", "memmove", "memset", "memcmp"}


def compile_without_library(folder, cc, nm):
    """As on a bare board: no headers but the compiler's own, no function of a C library."""
    headers = subprocess.run([cc, "-print-file-name=include"], check=True, capture_output=True, encoding="utf-8").stdout.strip()
    command = [cc, "-std=c99", "-Os", "-ffreestanding", "-fno-builtin", "-fno-stack-protector", "-fno-pic", "-nostdinc"]
    command += ["-isystem", headers, "-DQTR_PROFILE_MCU", "-c", "quarter_robot.c", "-o", str(pathlib.Path("bare.o").absolute())]
    done = subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", errors="replace")
    if done.returncode != 0:
        return [" ".join(command) + "\n" + done.stderr]
    listing = subprocess.run([nm, "--format=posix", "-u", "bare.o"], check=True, capture_output=True, encoding="utf-8").stdout
    needed = {line.split()[0] for line in listing.splitlines()}
    return [f"needs {name} of a C library" for name in sorted(needed - COMPILERS)]


def functions(nm, objects):
    listing = subprocess.run([nm, "--format=posix", str(objects)], check=True, capture_output=True, encoding="utf-8").stdout
    rows = [line.split() for line in listing.splitlines()]
    return {row[0] for row in rows if len(row) >= 2 and row[1] in "TRD"}


def compare_names(bundle, library):
    missing = [f"not in the bundle: {name}" for name in sorted(library - bundle)]
    return missing + [f"not in the library: {name}" for name in sorted(bundle - library)]


def check_collisions(source):
    """Names that two files keep for themselves are told apart, and nothing else is touched."""
    sys.path.insert(0, str(source / "cmake"))
    import bundle

    def told_apart(wanted, **files):
        made = bundle.without_collisions({f"lib/{name}.c": text for name, text in files.items()})
        return [] if list(made.values()) == wanted else [f"{made}"]

    same = "static int size(int a) {\n  return a;\n}\n"
    use = 'int qtr_x(struct b *b) {\n  return b->size + size(1) + "size"[0]; /* size */\n}\n'
    other = "static int other(void) {\n  return 0;\n}\n"
    apart_a = "static int a_size(int a) {\n  return a;\n}\n" + use.replace("size(1)", "a_size(1)")
    apart_b = "static int b_size(int a) {\n  return a;\n}\n"
    faults = told_apart([apart_a, apart_b], a=same + use, b=same)
    faults += told_apart([other, same], a=other, b=same)
    faults += told_apart(["enum { a_FORMAT = 1 };\n", "enum { b_FORMAT = 2 };\n"], a="enum { FORMAT = 1 };\n", b="enum { FORMAT = 2 };\n")
    return faults


def main():
    self_test([("a name too few", ({"a"}, {"a", "b"}), 1), ("a name too many", ({"a", "b"}, {"a"}), 1)], compare_names)
    parser = argparse.ArgumentParser()
    parser.add_argument("--bundle", type=pathlib.Path, required=True)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--library", type=pathlib.Path, required=True)
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--cxx", default=shutil.which("c++"))
    parser.add_argument("--nm", default="nm")
    options = parser.parse_args()
    faults = check_collisions(options.source) + compile_all(options.bundle, options.cc, options.cxx)
    faults += compile_without_library(options.bundle, options.cc, options.nm)
    if not faults:
        command = [options.cc, "-std=c99", "-O2", "-c", str(options.bundle / "quarter_robot.c"), "-o", "quarter_robot.o"]
        subprocess.run(command, check=True)
        faults = compare_names(functions(options.nm, "quarter_robot.o"), functions(options.nm, options.library))
    report(faults, f"two files, {len(ways(options.cc, options.cxx))} ways to compile them")


main()
