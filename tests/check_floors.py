"""check_floors.py PROJECT: the core's files include only what their floor allows.

The floors are those of the table in docs/DESIGN.md. A file includes headers of lower floors, and `config`, which lies
under all; the robot side only its own column. From outside it includes the headers below and nothing else. The robot
side names no floating-point type and holds no floating-point constant. In the demo, each library is included by one file.
"""

import pathlib
import re
import sys

from check_source import blanked, report, self_test

SYSTEM = {
    "robot": {"stdint.h", "stdbool.h", "stddef.h", "limits.h", "string.h"},
    "learn": {"stdint.h", "stdbool.h", "stddef.h", "limits.h", "string.h", "float.h", "math.h"},
}
ROW = re.compile(r"^\|\s*(\d+)\s*\|([^|]*)\|([^|]*)\|", re.MULTILINE)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:<([^>]+)>|"([^"]+)"|(\S+))', re.MULTILINE)
FLOATING = re.compile(r"\b(?:float|double)\b|(?<![\w.])(?:\d+\.\d*|\.\d+|\d+[eE][+-]?\d+)")
UMBRELLAS = {"robot", "learn"}
# The demo's libraries, and the one file that knows of each.
HOMES = {
    "box2d/": "demo/world/world.c",
    "lcm/": "demo/bus/bus.c",
    "civetweb.h": "demo/live/live.c",
    "spng.h": "tools/reader/png.c",
    "stb_image.h": "tools/reader/bmp.c",
}


def read_floors(document):
    """The table as {module: (floor, side)}."""
    floors = {}
    for floor, robot, learn in ROW.findall(document):
        for side, cell in (("robot", robot), ("learn", learn)):
            for module in re.findall(r"`(\w+)`", cell):
                floors[module] = (int(floor), side)
    return floors


def check_include(module, system, quoted, floors):
    """The fault of one #include in a module's file, or None."""
    floor, side = floors[module]
    if system is not None:
        return None if system in SYSTEM[side] else f"<{system}> is not allowed on the {side} side"
    other = pathlib.PurePosixPath(quoted).stem
    if other == module or (other == "config" and module != "config"):
        return None
    if other in UMBRELLAS or other not in floors:
        return f'"{quoted}" has no floor'
    other_floor, other_side = floors[other]
    if side == "robot" and other_side == "learn":
        return f'"{quoted}" is of the learner side'
    if other_floor >= floor:
        return f'"{quoted}" is of floor {other_floor}, not below {floor}'
    return None


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_file(name, text, floors):
    """All faults of one file; `name` is its path in the project."""
    module = pathlib.PurePosixPath(name).stem
    if module not in floors:
        return [f"{name}: module `{module}` is not in the floor table of docs/DESIGN.md"]
    faults = []
    if name.startswith("lib/") and floors[module][1] != name.split("/")[1]:
        faults.append(f"{name}: the floor table has it on the other side")
    for match in INCLUDE.finditer(blanked(text, keep_strings=True)):
        system, quoted, macro = match.groups()
        if macro is not None:
            fault = None if (module, macro) == ("config", "QTR_CONFIG_HEADER") else f"{macro} is not a file"
        else:
            fault = check_include(module, system, quoted, floors)
        if fault:
            faults.append(f"{name}:{line_of(text, match.start())}: includes a header it must not: {fault}")
    if floors[module][1] == "robot":
        code = blanked(text)
        for match in FLOATING.finditer(code):
            faults.append(f"{name}:{line_of(code, match.start())}: floating point on the robot side: {match.group(0)}")
    return faults


def check_umbrella(side, text, public, floors):
    """An umbrella header includes every public header of its side, and learn.h includes robot.h."""
    wanted = {module for module in public if floors.get(module, (0, ""))[1] == side}
    if side == "learn":
        wanted.add("robot")
    found = {pathlib.PurePosixPath(quoted).stem for _, quoted, _ in INCLUDE.findall(text)}
    name = f"include/quarter/{side}.h"
    return [f"{name}: {module}.h is missing" for module in sorted(wanted - found)] + [
        f"{name}: {module}.h does not belong here" for module in sorted(found - wanted)
    ]


def check_home(name, text):
    faults = []
    for match in INCLUDE.finditer(text):
        header = match.group(1) or match.group(2) or ""
        for library, home in HOMES.items():
            if header.startswith(library) and name != home:
                faults.append(f"{name}:{line_of(text, match.start())}: {header} is for {home} alone")
    return faults


def prove_that_it_fails():
    floors = read_floors(
        "| floor | robot | learn | what |\n| 0 | `config` (private: `bytes`) | | |\n"
        "| 1 | `grid`, `twin` | | `grid` |\n| 2 | `travel` | `game` | |\n"
    )
    assert floors["travel"] == (2, "robot") and floors["game"] == (2, "learn") and floors["bytes"] == (0, "robot")
    fine = '#include "quarter/grid.h"\n#include "bytes.h"\n#include <string.h>\n/* 1.5 double */ int x = 0x1E5;\n'
    self_test(
        [
            ("nothing", ("lib/robot/travel.c", fine, floors), 0),
            ("a higher floor", ("lib/robot/grid.c", '#include "quarter/travel.h"\n', floors), 1),
            ("the same floor", ("lib/robot/grid.c", '#include "quarter/twin.h"\n', floors), 1),
            ("the learner side", ("lib/robot/travel.c", ' # include "quarter/game.h"\n', floors), 1),
            ("an umbrella", ("lib/learn/game.c", '#include "quarter/robot.h"\n', floors), 1),
            ("a host header", ("lib/learn/game.c", "#include <stdlib.h>\n", floors), 1),
            ("mathematics on the learner side", ("lib/learn/game.c", "#include <math.h>\ndouble x = 1.5;", floors), 0),
            ("mathematics on the robot side", ("include/quarter/grid.h", "#include <math.h>\n", floors), 1),
            ("a floating type", ("lib/robot/grid.c", "static double x;\n", floors), 1),
            ("a floating constant", ("lib/robot/grid.c", "int x = (int)(2 * 1.5);\n", floors), 1),
            ("a macro as a header", ("lib/robot/grid.c", "#include HEADER\n", floors), 1),
            ("a module without a floor", ("lib/robot/attic.c", "", floors), 1),
            ("a file on the wrong side", ("lib/learn/grid.c", "", floors), 1),
        ],
        check_file,
    )
    self_test(
        [
            ("a library at home", ("demo/bus/bus.c", "#include <lcm/lcm.h>\n"), 0),
            ("a library abroad", ("demo/robot/robot.c", "#include <lcm/lcm.h>\n"), 1),
        ],
        check_home,
    )
    public = ["config", "grid", "game"]
    whole = '#include "quarter/config.h"\n#include "quarter/grid.h"\n'
    self_test(
        [
            ("a whole umbrella", ("robot", whole, public, floors), 0),
            ("a hole in the umbrella", ("robot", '#include "quarter/grid.h"\n', public, floors), 1),
            ("too wide an umbrella", ("robot", whole + '#include "quarter/game.h"\n', public, floors), 1),
        ],
        check_umbrella,
    )


def main():
    prove_that_it_fails()
    project = pathlib.Path(sys.argv[1])
    document = project / "docs" / "DESIGN.md"
    floors = read_floors(document.read_text(encoding="utf-8")) if document.exists() else {}
    if not floors:
        raise SystemExit("docs/DESIGN.md holds no floor table (rows `| 0 | robot side | learner side | what |`)")
    faults = []
    headers = {path.stem: path for path in sorted((project / "include/quarter").glob("*.h"))}
    sources = [path for side in ("robot", "learn") for path in sorted((project / "lib" / side).rglob("*.[ch]"))]
    public = [module for module in headers if module not in UMBRELLAS]
    for path in [headers[module] for module in public] + sources:
        name = path.relative_to(project).as_posix()
        faults += check_file(name, path.read_text(encoding="utf-8"), floors)
    for side in sorted(UMBRELLAS):
        faults += check_umbrella(side, headers[side].read_text(encoding="utf-8"), public, floors)
    for path in sorted((project / "demo").rglob("*.[ch]")):
        faults += check_home(path.relative_to(project).as_posix(), path.read_text(encoding="utf-8"))
    report(faults, f"{len(public) + len(sources)} files keep to their floors")


main()
