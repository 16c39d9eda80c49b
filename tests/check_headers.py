"""check_headers.py --cc CC [--cxx CXX] INCLUDE: each public header compiles alone, first and without a warning, as C99, C11,
and where there is a compiler for it as C++11 and C++17; and what it declares, C++ links as C.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from check_source import blanked, report, self_test

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wundef", "-Werror"]


def faults_of(compiler, language, standard, include, header):
    """What the compiler says of a source that includes this header alone, twice."""
    source = f'#include "{header}"\n#include "{header}"\nint main(void);\n'
    command = [compiler, "-x", language, f"-std={standard}", *WARNINGS, "-fsyntax-only", "-I", str(include), "-"]
    done = subprocess.run(command, input=source, capture_output=True, encoding="utf-8", errors="replace")
    return [f"{header} as {standard}: {done.stderr}"] if done.returncode != 0 else []


def unlinked(header, text):
    """A header that declares anything does so between QTR_C_BEGIN and QTR_C_END."""
    declares = re.search(r"^[a-z].*[;{]$", blanked(text), re.MULTILINE)
    wrapped = re.search(r"^QTR_C_BEGIN\n(.*\n)QTR_C_END\n\n#endif\n$", text, re.MULTILINE | re.DOTALL)
    return [f"{header}: declares something outside of QTR_C_BEGIN and QTR_C_END"] if declares and not wrapped else []


def prove_that_it_fails(cc, cxx):
    with tempfile.TemporaryDirectory() as folder:
        planted = pathlib.Path(folder)

        def plant(name, text):
            (planted / name).write_text(text, encoding="utf-8")
            return name

        cases = [
            ("nothing", (cc, "c", "c99", planted, plant("good.h", "#pragma once\ntypedef int good;\n")), 0),
            ("NULL of nowhere", (cc, "c", "c99", planted, plant("null.h", "static inline void *none(void) { return NULL; }\n")), 1),
            ("no guard", (cc, "c", "c99", planted, plant("twice.h", "struct twice { int a; };\n")), 1),
        ]
        if cxx:
            text = "#pragma once\nstatic inline char *sure(void *p) { return p; }\n"
            cases.append(("no C++", (cxx, "c++", "c++11", planted, plant("conversion.h", text)), 1))
        self_test(cases, faults_of)
    wrapped = "QTR_C_BEGIN\n\nint qtr_a(int b);\n\nQTR_C_END\n\n#endif\n"
    cases = [
        ("nothing", ("a.h", wrapped), 0),
        ("C++ linkage", ("a.h", "int qtr_a(int b);\n\n#endif\n"), 1),
        ("no declaration", ("a.h", '#include "b.h"\n#endif\n'), 0),
    ]
    self_test(cases, unlinked)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--cxx", default=shutil.which("c++"))
    parser.add_argument("include", type=pathlib.Path)
    options = parser.parse_args()
    prove_that_it_fails(options.cc, options.cxx)
    ways = [(options.cc, "c", "c99"), (options.cc, "c", "c11")]
    if options.cxx:
        ways += [(options.cxx, "c++", "c++11"), (options.cxx, "c++", "c++17")]
    headers = sorted(path.relative_to(options.include) for path in options.include.rglob("*.h"))
    if not headers:
        sys.exit(f"no header in {options.include}")
    faults = [fault for header in headers for way in ways for fault in faults_of(*way, options.include, header)]
    for header in headers:
        if header.name != "config.h":  # where the two macros are defined; it has types alone
            faults += unlinked(header, (options.include / header).read_text(encoding="utf-8"))
    report(faults, f"{len(headers)} headers as {', '.join(standard for _, _, standard in ways)}")


main()
