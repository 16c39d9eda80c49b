"""check_floors.py PROJECT: files include only what lies below them.

What lies below what, the table in docs/DESIGN.md says: folders from the lowest floor up, in each its modules, the lowest
first. A module (a header and the source of its name) includes modules that stand before it in the table, and `config`. A
core file includes few headers of the system; on the robot side it names no floating-point type and holds no floating-point
constant. Each library is included by one file alone.
"""

import pathlib
import re
import sys

from check_source import blanked, report, self_test

FREESTANDING = {"stdint.h", "stdbool.h", "stddef.h", "limits.h", "string.h"}
SYSTEM = {"robot": FREESTANDING, "learner": FREESTANDING | {"float.h", "math.h"}}
ROW = re.compile(r"^\|\s*`([\w/]+)`\s*\|\s*(robot|learner)\s*\|([^|]*)\|", re.MULTILINE)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:<([^>]+)>|"([^"]+)"|(\S+))', re.MULTILINE)
FLOATING = re.compile(r"\b(?:float|double)\b|(?<![\w.])(?:\d+\.\d*|\.\d+|\d+[eE][+-]?\d+)")
UMBRELLAS = {"robot": "robot", "learn": "learner"}
# Libraries, and the one file that knows of each.
HOMES = {
    "box2d/": "demo/world/world.c",
    "lcm/": "demo/bus/bus.c",
    "civetweb.h": "demo/live/live.c",
    "spng.h": "lib/host/input/png.c",
    "stb_image.h": "lib/host/input/bmp.c",
}


def read_floors(document):
    """The table as {module: (height, side, folder)}."""
    floors = {}
    for folder, side, modules in ROW.findall(document):
        for module in re.findall(r"`(\w+)`", modules):
            floors[module] = (len(floors), side, folder)
    return floors


def check_include(module, system, quoted, floors):
    """The fault of one #include in a module's file, or None."""
    height, side, _ = floors[module]
    if system is not None:
        return None if system in SYSTEM[side] else f"<{system}> is not allowed on the {side} side"
    other = pathlib.PurePosixPath(quoted).stem
    if other == module or (other == "config" and module != "config"):
        return None
    if other in UMBRELLAS or other not in floors:
        return f'"{quoted}" has no floor'
    other_height, other_side, _ = floors[other]
    if side == "robot" and other_side == "learner":
        return f'"{quoted}" is of the learner side'
    if other_height >= height:
        return f'"{quoted}" stands above it in the table'
    return None


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_file(name, text, floors):
    """All faults of one file; `name` is its path in the project."""
    module = pathlib.PurePosixPath(name).stem
    if module not in floors:
        return [f"{name}: module `{module}` is not in the floor table of docs/DESIGN.md"]
    _, side, folder = floors[module]
    faults = []
    if name.startswith("lib/") and str(pathlib.PurePosixPath(name).parent) != folder:
        faults.append(f"{name}: the floor table has it in {folder}")
    for match in INCLUDE.finditer(blanked(text, keep_strings=True)):
        system, quoted, macro = match.groups()
        if macro is not None:
            fault = None if (module, macro) == ("config", "QTR_CONFIG_HEADER") else f"{macro} is not a file"
        else:
            fault = check_include(module, system, quoted, floors)
        if fault:
            faults.append(f"{name}:{line_of(text, match.start())}: includes a header it must not: {fault}")
    if side == "robot":
        code = blanked(text)
        for match in FLOATING.finditer(code):
            faults.append(f"{name}:{line_of(code, match.start())}: floating point on the robot side: {match.group(0)}")
    return faults


def check_umbrella(umbrella, text, public, floors):
    """An umbrella header includes every public header of its side, and learn.h includes robot.h."""
    wanted = {module for module in public if floors.get(module, (0, ""))[1] == UMBRELLAS[umbrella]}
    if umbrella == "learn":
        wanted.add("robot")
    found = {pathlib.PurePosixPath(quoted).stem for _, quoted, _ in INCLUDE.findall(text)}
    name = f"include/quarter/{umbrella}.h"
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
        "| folder | side | modules | what |\n| `lib/core` | robot | `config`, `grid` (private: `bytes`) | |\n"
        "| `lib/robot` | robot | `travel`, `seeker` | `attic` |\n| `lib/model` | learner | `game` | |\n"
    )
    assert list(floors) == ["config", "grid", "bytes", "travel", "seeker", "game"]
    assert floors["travel"] == (3, "robot", "lib/robot") and floors["game"] == (5, "learner", "lib/model")
    fine = '#include "quarter/grid.h"\n#include "core/bytes.h"\n#include <string.h>\n/* 1.5 double */ int x = 0x1E5;\n'
    self_test(
        [
            ("nothing", ("lib/robot/travel.c", fine, floors), 0),
            ("a higher floor", ("lib/core/grid.c", '#include "quarter/travel.h"\n', floors), 1),
            ("a later one of the same floor", ("lib/robot/travel.c", '#include "quarter/seeker.h"\n', floors), 1),
            ("the learner side", ("lib/robot/seeker.c", ' # include "quarter/game.h"\n', floors), 1),
            ("an umbrella", ("lib/model/game.c", '#include "quarter/robot.h"\n', floors), 1),
            ("a host header", ("lib/model/game.c", "#include <stdlib.h>\n", floors), 1),
            ("mathematics on the learner side", ("lib/model/game.c", "#include <math.h>\ndouble x = 1.5;", floors), 0),
            ("mathematics on the robot side", ("include/quarter/grid.h", "#include <math.h>\n", floors), 1),
            ("a floating type", ("lib/core/grid.c", "static double x;\n", floors), 1),
            ("a floating constant", ("lib/core/grid.c", "int x = (int)(2 * 1.5);\n", floors), 1),
            ("a macro as a header", ("lib/core/grid.c", "#include HEADER\n", floors), 1),
            ("a module without a floor", ("lib/robot/attic.c", "", floors), 1),
            ("a file in the wrong folder", ("lib/robot/grid.c", "", floors), 1),
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
        raise SystemExit("docs/DESIGN.md holds no floor table (rows `| folder | robot or learner | modules | what |`)")
    faults = []
    headers = {path.stem: path for path in sorted((project / "include/quarter").glob("*.h"))}
    host = sorted(path for folder in ("lib/host", "tools", "demo") for path in (project / folder).rglob("*.[ch]"))
    sources = sorted(path for path in (project / "lib").rglob("*.[ch]") if path not in host)
    public = [module for module in headers if module not in UMBRELLAS]
    for path in [headers[module] for module in public] + sources:
        name = path.relative_to(project).as_posix()
        faults += check_file(name, path.read_text(encoding="utf-8"), floors)
    for umbrella in sorted(UMBRELLAS):
        faults += check_umbrella(umbrella, headers[umbrella].read_text(encoding="utf-8"), public, floors)
    for path in host:
        faults += check_home(path.relative_to(project).as_posix(), path.read_text(encoding="utf-8"))
    report(faults, f"{len(public) + len(sources)} files keep to their floors")


main()
