"""check_floors.py PROJECT: files include only what lies below them.

What lies below what, the table in docs/DESIGN.md says: folders from the lowest floor up, in each its modules, the lowest
first. A module (a header and the source of its name) includes modules that stand before it in the table and are of a side
that its own may see, so that no circle can be; an include is followed to the file that it names. Of the core the others see
the public headers alone, and tools and demo nothing of one another. A core file includes few headers of the system; on
the robot side it names no floating-point type and holds no floating-point constant. Each library is included by one file
alone.
"""

import pathlib
import re
import sys

from check_source import blanked, report, self_test

FREESTANDING = {"stdint.h", "stdbool.h", "stddef.h", "limits.h"}
SYSTEM = {"robot": FREESTANDING, "learner": FREESTANDING | {"float.h", "math.h", "string.h"}}
# What each side may see: itself and what it stands on.
SEES = {
    "robot": {"robot"},
    "learner": {"robot", "learner"},
    "host": {"robot", "learner", "host"},
    "tools": {"robot", "learner", "host", "tools"},
    "demo": {"robot", "learner", "host", "demo"},
}
CORE = ("robot", "learner")
ROW = re.compile(r"^\|\s*`([\w/]+)`\s*\|\s*(robot|learner|host|tools|demo)\s*\|([^|]*)\|", re.MULTILINE)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:<([^>]+)>|"([^"]+)"|(\S+))', re.MULTILINE)
FLOATING = re.compile(r"\b(?:float|double)\b|(?<![\w.])(?:\d+\.\d*|\.\d+|\d+[eE][+-]?\d+)")
UMBRELLAS = {"robot": "robot", "learn": "learner"}
PUBLIC = "include/quarter"
# Headers that the build makes, and the one file that knows of each.
MADE = {f"quarter_{message}.h": "demo/bus/bus.c" for message in ("command", "pose", "scan", "status", "terminate")}
MADE["viewer_page.h"] = "demo/game/record.c"
# Libraries, and the one file that knows of each.
HOMES = {
    "box2d/": "demo/world/world.c",
    "lcm/": "demo/bus/bus.c",
    "civetweb.h": "demo/live/live.c",
    "sodium.h": "demo/bus/seal.c",
    "yaml.h": "lib/host/input/tree.c",
    "spng.h": "lib/host/input/png.c",
    "stb_image.h": "lib/host/input/bmp.c",
    "librsvg/": "tools/draw_render.c",
    "cairo": "tools/draw_render.c",
    "proj.h": "lib/host/geo/projection.c",
}


def read_floors(document):
    """The table as {(folder, module): (height, side)}."""
    floors = {}
    for folder, side, modules in ROW.findall(document):
        for module in re.findall(r"`(\w+)`", modules):
            floors[folder, module] = (len(floors), side)
    return floors


def key_of(path, floors):
    """The module of a file, as the table's key; None: it has no floor. A public header is of a core folder's module."""
    path = pathlib.PurePosixPath(path)
    if str(path.parent) != PUBLIC:
        key = (str(path.parent), path.stem)
        return key if key in floors else None
    return next((key for key, (_, side) in floors.items() if side in CORE and key[1] == path.stem), None)


def resolve(name, quoted, files):
    """The file that an include in the file `name` means; None: none of the project's."""
    folder = pathlib.PurePosixPath(name).parent
    roots = [folder, pathlib.PurePosixPath("include"), pathlib.PurePosixPath("lib")]
    if folder.parts[0] == "demo":
        roots += sorted({path.parent for path in map(pathlib.PurePosixPath, files) if path.parts[0] == "demo"})
    return next((str(root / quoted) for root in roots if str(root / quoted) in files), None)


def check_sides(side, target, other_side):
    """What keeps a file of a side from a file of another one, or None."""
    if other_side not in SEES[side]:
        return f"is of the {other_side} side"
    private = other_side in CORE and side not in CORE and not target.startswith(PUBLIC)
    return "is private to the core" if private else None


def check_target(name, target, floors):
    """What keeps the file `name` from including another one of ours, or None."""
    key, other = key_of(name, floors), key_of(target, floors)
    height, side = floors[key]
    stem = pathlib.PurePosixPath(target).stem
    if target.startswith(PUBLIC) and stem in UMBRELLAS and side not in CORE:
        return check_sides(side, target, UMBRELLAS[stem])
    if other is None:
        return "has no floor"
    if other == key:
        return None
    other_height, other_side = floors[other]
    fault = check_sides(side, target, other_side)
    if fault or (target == f"{PUBLIC}/config.h" and key[1] != "config"):
        return fault
    return None if other_height < height else "stands above it in the table"


def check_quoted(name, quoted, floors, files):
    """The fault of one #include of a file of ours, or None."""
    target = resolve(name, quoted, files)
    if target is None:
        return None if MADE.get(quoted) == name else f'"{quoted}" is no file'
    fault = check_target(name, target, floors)
    return f'"{quoted}" {fault}' if fault else None


def check_include(name, match, floors, files):
    """The fault of one #include, or None."""
    key = key_of(name, floors)
    side = floors[key][1]
    system, quoted, macro = match.groups()
    if macro is not None:
        return None if (key[1], macro) == ("config", "QTR_CONFIG_HEADER") else f"{macro} is not a file"
    if system is not None:
        return None if system in SYSTEM.get(side, {system}) else f"<{system}> is not allowed on the {side} side"
    return check_quoted(name, quoted, floors, files)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_file(name, text, floors, files):
    """All faults of one file; `name` is its path in the project, `files` all paths there are."""
    key = key_of(name, floors)
    if key is None:
        path = pathlib.PurePosixPath(name)
        return [f"{name}: module `{path.stem}` of {path.parent} is not in the floor table of docs/DESIGN.md"]
    faults = []
    for match in INCLUDE.finditer(blanked(text, keep_strings=True)):
        fault = check_include(name, match, floors, files)
        if fault:
            faults.append(f"{name}:{line_of(text, match.start())}: includes a header it must not: {fault}")
    if floors[key][1] == "robot":
        code = blanked(text)
        for match in FLOATING.finditer(code):
            faults.append(f"{name}:{line_of(code, match.start())}: floating point on the robot side: {match.group(0)}")
    return faults


def check_table(floors, files):
    """Modules that are no files: the table tells of what is there, and of nothing else."""
    gone = [key for key in floors if key not in {key_of(path, floors) for path in files}]
    return [f"docs/DESIGN.md: module `{module}` of {folder} is no file" for folder, module in gone]


def check_umbrella(umbrella, text, public, floors):
    """An umbrella header includes every public header of its side, and learn.h includes robot.h."""
    wanted = set()
    for module in public:
        key = key_of(f"{PUBLIC}/{module}.h", floors)
        if key and floors[key][1] == UMBRELLAS[umbrella]:
            wanted.add(module)
    if umbrella == "learn":
        wanted.add("robot")
    found = {pathlib.PurePosixPath(quoted).stem for _, quoted, _ in INCLUDE.findall(text)}
    name = f"{PUBLIC}/{umbrella}.h"
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


TRIAL_TABLE = (
    "| folder | side | modules | what |\n| `lib/core` | robot | `config`, `grid` (private: `bytes`) | |\n"
    "| `lib/robot` | robot | `travel`, `seeker` | `attic` |\n| `lib/model` | learner | `game` | |\n"
    "| `lib/host/base` | host | `fault`, `file` | |\n| `tools` | tools | `draw`, `main` | |\n"
    "| `demo/bus` | demo | `bus` | |\n| `demo/game` | demo | `game`, `record` | |\n"
)
TRIAL_FILES = {
    *(f"include/quarter/{name}.h" for name in ("config", "grid", "travel", "seeker", "game", "robot", "learn")),
    *("lib/core/bytes.h", "lib/host/base/fault.h", "lib/host/base/file.h", "lib/host/base/fault.c"),
    *("tools/draw.h", "tools/main.c", "tools/stray.h", "demo/bus/bus.h", "demo/game/game.h", "demo/game/record.h"),
}


def prove_the_core():
    floors = read_floors(TRIAL_TABLE)
    assert [module for _, module in floors][:6] == ["config", "grid", "bytes", "travel", "seeker", "game"]
    assert floors["lib/robot", "travel"] == (3, "robot") and floors["lib/model", "game"] == (5, "learner")
    fine = '#include "quarter/grid.h"\n#include "core/bytes.h"\n#include <stddef.h>\n/* 1.5 double */ int x = 0x1E5;\n'
    cases = [
        ("nothing", "lib/robot/travel.c", fine, 0),
        ("a higher floor", "lib/core/grid.c", '#include "quarter/travel.h"\n', 1),
        ("a later one of the same floor", "lib/robot/travel.c", '#include "quarter/seeker.h"\n', 1),
        ("the learner side", "lib/robot/seeker.c", ' # include "quarter/game.h"\n', 1),
        ("an umbrella", "lib/model/game.c", '#include "quarter/robot.h"\n', 1),
        ("a host header", "lib/model/game.c", "#include <stdlib.h>\n", 1),
        ("a header of the host library", "lib/model/game.c", '#include "host/base/fault.h"\n', 1),
        ("mathematics on the learner side", "lib/model/game.c", "#include <math.h>\ndouble x = 1.5;", 0),
        ("the C library on the robot side", "lib/core/grid.c", "#include <string.h>\n", 1),
        ("the C library on the learner side", "lib/model/game.c", "#include <string.h>\n", 0),
        ("mathematics on the robot side", "include/quarter/grid.h", "#include <math.h>\n", 1),
        ("a floating type", "lib/core/grid.c", "static double x;\n", 1),
        ("a floating constant", "lib/core/grid.c", "int x = (int)(2 * 1.5);\n", 1),
        ("a macro as a header", "lib/core/grid.c", "#include HEADER\n", 1),
        ("a module without a floor", "lib/robot/attic.c", "", 1),
        ("a file in the wrong folder", "lib/robot/grid.c", "", 1),
    ]
    self_test([(what, (name, text, floors, TRIAL_FILES), faults) for what, name, text, faults in cases], check_file)


def prove_the_others():
    floors = read_floors(TRIAL_TABLE)
    cases = [
        ("what the host library stands on", "lib/host/base/file.h", '#include "host/base/fault.h"\n#include <yaml.h>', 0),
        ("a circle", "lib/host/base/fault.c", '#include "host/base/file.h"\n', 1),
        ("the core's public side", "lib/host/base/file.c", '#include "quarter/learn.h"\n#include "quarter/game.h"\n', 0),
        ("the core's private side", "lib/host/base/file.c", '#include "core/bytes.h"\n', 1),
        ("a command's header in the library", "lib/host/base/file.c", '#include "../../../tools/draw.h"\n', 1),
        ("a command's header in the demo", "demo/game/game.c", '#include "draw.h"\n', 1),
        ("a command's header in a command", "tools/main.c", '#include "draw.h"\n#include "host/base/file.h"\n', 0),
        ("the demo in a command", "tools/main.c", '#include "bus.h"\n', 1),
        ("one of two files of a name", "demo/game/record.c", '#include "game.h"\n#include "quarter/game.h"\n', 0),
        ("another folder of the demo", "demo/game/game.h", '#include "bus.h"\n', 0),
        ("a higher folder of the demo", "demo/bus/bus.c", '#include "record.h"\n', 1),
        ("a header that the build makes", "demo/game/record.c", '#include "viewer_page.h"\n', 0),
        ("the same elsewhere", "demo/game/game.c", '#include "viewer_page.h"\n', 1),
        ("a file without a floor", "tools/main.c", '#include "stray.h"\n', 1),
    ]
    self_test([(what, (name, text, floors, TRIAL_FILES), faults) for what, name, text, faults in cases], check_file)
    self_test(
        [
            ("a table of files", (floors, TRIAL_FILES | {"lib/core/config.h"}), 0),
            ("a row of what is gone", (floors, TRIAL_FILES - {"tools/main.c", "tools/draw.h"}), 2),
        ],
        check_table,
    )


def prove_the_rest():
    floors = read_floors(TRIAL_TABLE)
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


def read_sources(project):
    """{path in the project: text} of all C files that have a floor; of the umbrellas apart."""
    texts = {}
    for folder in ("include/quarter", "lib", "tools", "demo"):
        for path in sorted((project / folder).rglob("*.[ch]")):
            texts[path.relative_to(project).as_posix()] = path.read_text(encoding="utf-8")
    umbrellas = {name: texts[f"{PUBLIC}/{name}.h"] for name in UMBRELLAS}
    return texts, umbrellas


def main():
    prove_the_core()
    prove_the_others()
    prove_the_rest()
    project = pathlib.Path(sys.argv[1])
    document = project / "docs" / "DESIGN.md"
    floors = read_floors(document.read_text(encoding="utf-8")) if document.exists() else {}
    if not floors:
        raise SystemExit("docs/DESIGN.md holds no floor table (rows `| folder | side | modules | what |`)")
    texts, umbrellas = read_sources(project)
    faults = check_table(floors, texts)
    for name, text in texts.items():
        if name not in {f"{PUBLIC}/{umbrella}.h" for umbrella in umbrellas}:
            faults += check_file(name, text, floors, texts) + check_home(name, text)
    public = [pathlib.PurePosixPath(name).stem for name in texts if name.startswith(PUBLIC)]
    for umbrella, text in umbrellas.items():
        faults += check_umbrella(umbrella, text, public, floors)
    report(faults, f"{len(texts)} files keep to their floors")


main()
