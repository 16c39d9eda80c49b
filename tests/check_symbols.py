"""check_symbols.py --nm NM [--sanitized] ROBOT.a LEARN.a: what the core's objects need and what they keep.

The robot side needs nothing but itself and the four memory functions; the learner side the robot side too, and some
mathematics. Neither allocates, prints, or keeps anything writable.
"""

import argparse
import re
import subprocess

from check_source import report, self_test

MEMORY = {"memcpy", "memmove", "memset", "memcmp"}
MATHS = {"ceil", "exp", "exp2", "expm1", "fabs", "floor", "fmax", "fmin", "fmod", "frexp", "ldexp", "log", "log1p"}
MATHS |= {"log2", "nextafter", "pow", "round", "sqrt", "trunc"}
MATHS |= {name + "f" for name in MATHS}
# What compilers call on their own account: stack protector, memory functions that check (Ubuntu's by default), position-
# independent code, integer arithmetic.
COMPILER = re.compile(r"__mem(?:cpy|move|set)_chk|__stack_chk_\w+|_GLOBAL_OFFSET_TABLE_|__aeabi_\w+|__(?:u|)(?:div|mod|mul|ashl|ashr|lshr)\w*[dt]i\d")
SANITIZER = re.compile(r"__(?:asan|ubsan|lsan)_\w+")
WRITABLE = re.compile(r"\.(?:data|bss|tdata|tbss)(?!\.rel\.ro)|\*COM\*")


def parse(listing):
    """(name, class, section) of every symbol in the output of nm --format=sysv."""
    symbols = []
    for line in listing.splitlines():
        fields = [field.strip() for field in line.split("|")]
        if len(fields) == 7 and fields[0] != "Name":
            symbols.append((fields[0], fields[2], fields[6]))
    return symbols


def defined(symbols):
    return {name for name, kind, _ in symbols if kind.isupper() and kind != "U"}


def is_compilers(name, sanitized):
    return bool(COMPILER.fullmatch(name) or (sanitized and SANITIZER.fullmatch(name)))


def find_kept(symbols):
    return [(name, section) for name, kind, section in symbols if kind == "C" or WRITABLE.match(section)]


def check_library(side, symbols, below, sanitized):
    """Faults of one library; `below` are the names that it may use from the library under it."""
    allowed = defined(symbols) | below | MEMORY | (MATHS if side == "learn" else set())
    needed = {name for name, kind, _ in symbols if kind in "Uwv" and not is_compilers(name, sanitized)} - allowed
    kept = [] if sanitized else find_kept(symbols)
    return [f"{side} side: needs {name}" for name in sorted(needed)] + [
        f"{side} side: {name} is writable and global, in {section}" for name, section in kept
    ]


def prove_that_it_fails():
    def listing(*rows):
        return parse("Name|Value|Class|Type|Size|Line|Section\n" + "\n".join("|0|".join(row) for row in rows))

    def symbol(name, kind, section):
        return (name, f"{kind}|FUNC|0||{section}")

    own = symbol("qtr_own", "T", ".text")
    self_test(
        [
            ("nothing", ("robot", listing(own, symbol("memcpy", "U", "*UND*")), set(), False), 0),
            ("a table of pointers", ("robot", listing(symbol("names", "d", ".data.rel.ro.local")), set(), False), 0),
            ("a memory function that checks", ("robot", listing(own, symbol("__memcpy_chk", "U", "*UND*")), set(), False), 0),
            ("output that checks", ("learn", listing(own, symbol("__printf_chk", "U", "*UND*")), set(), False), 1),
            ("the heap", ("robot", listing(own, symbol("malloc", "U", "*UND*")), set(), False), 1),
            ("the learner side", ("robot", listing(own, symbol("qtr_learn", "U", "*UND*")), set(), False), 1),
            ("mathematics on the robot side", ("robot", listing(symbol("sqrt", "U", "*UND*")), set(), False), 1),
            ("mathematics on the learner side", ("learn", listing(symbol("sqrt", "U", "*UND*")), set(), False), 0),
            ("software floating point", ("robot", listing(symbol("__muldf3", "U", "*UND*")), set(), False), 1),
            ("the side below", ("learn", listing(symbol("qtr_own", "U", "*UND*")), {"qtr_own"}, False), 0),
            ("output", ("learn", listing(symbol("printf", "U", "*UND*")), set(), False), 1),
            ("a static variable", ("robot", listing(symbol("count", "b", ".bss")), set(), False), 1),
            ("an initialised variable", ("learn", listing(symbol("count", "D", ".data")), set(), False), 1),
            ("a sanitizer unasked for", ("robot", listing(symbol("__asan_load4", "U", "*UND*")), set(), False), 1),
            ("a sanitizer", ("robot", listing(symbol("__asan_load4", "U", "*UND*")), set(), True), 0),
        ],
        check_library,
    )


def main():
    prove_that_it_fails()
    parser = argparse.ArgumentParser()
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--sanitized", action="store_true")
    parser.add_argument("robot")
    parser.add_argument("learn")
    options = parser.parse_args()

    def symbols(library):
        command = [options.nm, "--format=sysv", library]
        return parse(subprocess.run(command, check=True, capture_output=True, encoding="utf-8").stdout)

    robot, learn = symbols(options.robot), symbols(options.learn)
    if not defined(robot) or not defined(learn):
        raise SystemExit("nm lists no symbols: are these the libraries?")
    faults = check_library("robot", robot, set(), options.sanitized)
    faults += check_library("learn", learn, defined(robot), options.sanitized)
    report(faults, f"{len(defined(robot))} functions on the robot side, {len(defined(learn))} on the learner side")


main()
