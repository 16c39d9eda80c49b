"""check_rounding.py --cc CC PROJECT: no result depends on a compiler flag that others will not set. Each source of the learner
that computes with floating point includes model/rounding.h; what does so does not compile under -ffast-math, or where doubles
are kept in x87 registers; and where a processor could fuse products and sums, none does so, though it is asked to.
"""

import argparse
import pathlib
import re
import subprocess

from check_source import blanked, report, self_test

FOLDERS = ("model", "aggregate", "search", "learn", "table")
FLOATING = re.compile(r"\b(?:float|double)\b|<math\.h>")
INCLUDE = '#include "model/rounding.h"'
FUSED = re.compile(r"^\s*(vfn?m(?:add|sub)\w*)", re.MULTILINE)
FUSING = ["-O2", "-march=haswell", "-std=gnu99"]


def computes(text):
    return FLOATING.search(blanked(text))


def unguarded(name, text):
    return [f"{name}: computes with floating point, and does not include model/rounding.h"] if computes(text) and INCLUDE not in text else []


def compiled(cc, project, flags, source):
    """Assembly of a source, and what the compiler said where there is none."""
    command = [cc, "-x", "c", *flags, f"-I{project}/include", f"-I{project}/lib", "-S", "-", "-o", "-"]
    return subprocess.run(command, input=source, capture_output=True, encoding="utf-8", errors="replace")


def not_refused(cc, project, flags, source):
    done = compiled(cc, project, flags, source)
    refused = done.returncode != 0 and "Quarter's learner needs" in done.stderr
    return [] if refused else [f"a source that includes model/rounding.h compiles under {' '.join(flags)}"]


def fused(cc, project, flags, name, source):
    done = compiled(cc, project, flags, source)
    if done.returncode != 0:
        return [f"{name}: does not compile under {' '.join(flags)}:\n{done.stderr}"]
    return [f"{name}: {instruction} under {' '.join(flags)}" for instruction in FUSED.findall(done.stdout)]


def makes(cc, project, flags):
    """Whether there are such flags on this machine."""
    return compiled(cc, project, flags, "double sum(double a) { return a + a; }\n").returncode == 0


def is_clang(cc):
    return "clang" in subprocess.run([cc, "--version"], capture_output=True, encoding="utf-8").stdout


def fusing_flags(cc, project):
    """clang's own fast goes over what sources say: it is asked for what it does by default."""
    flags = FUSING + ([] if is_clang(cc) else ["-ffp-contract=fast"])
    return flags if makes(cc, project, flags) else None


def refused_ways(cc, project):
    """clang tells a source less of what it is asked for."""
    ways = [["-ffast-math"], ["-ffinite-math-only"], ["-mfpmath=387"]]
    ways += [] if is_clang(cc) else [["-funsafe-math-optimizations"]]
    return [flags for flags in ways if makes(cc, project, flags)]


def prove_that_it_fails(cc, project, fusing):
    sum_of = "double sum(double a, double b) {\n  return a * b + 1.0;\n}\n"
    cases = [
        ("a double", ("a.c", sum_of), 1),
        ("a double, guarded", ("a.c", INCLUDE + "\n" + sum_of), 0),
        ("a word in a comment", ("a.c", "/* double */\nint a;\n"), 0),
    ]
    self_test(cases, unguarded)
    self_test([("fast", (cc, project, ["-ffast-math"], sum_of), 1)], not_refused)
    if fusing:
        sources = [("fused", sum_of, 1), ("guarded", INCLUDE + "\n" + sum_of, 0), ("no source", "double sum(", 1)]
        cases = [(name, (cc, project, fusing, "a.c", source), count) for name, source, count in sources]
        self_test(cases, fused)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cc", default="cc")
    parser.add_argument("project", type=pathlib.Path)
    options = parser.parse_args()
    cc, project, fusing = options.cc, options.project, fusing_flags(options.cc, options.project)
    prove_that_it_fails(cc, project, fusing)
    faults = [fault for flags in refused_ways(cc, project) for fault in not_refused(cc, project, flags, INCLUDE + "\n")]
    sources = [path for folder in FOLDERS for path in sorted((project / "lib" / folder).glob("*.c"))]
    for path in sources:
        name, text = str(path.relative_to(project)), path.read_text(encoding="utf-8")
        faults += unguarded(name, text)
        faults += fused(cc, project, fusing, name, text) if fusing and computes(text) else []
    report(faults, f"{len(sources)} sources round alike")


main()
