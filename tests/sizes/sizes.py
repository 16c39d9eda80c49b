"""What Quarter takes on a robot: writes docs/sizes.md, or with --check says whether it is what would be written now. Ends with 77
where the cross compilers or emulators are missing, or of other versions than the document names.
"""

import argparse
import difflib
import pathlib
import subprocess
import sys

import boards
import call_graph

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from check_source import self_test

MISSIONS = ("demining", "flat", "minefield", "site", "turtlebot3_world", "warehouse")
CELLS = 32 * 32
# A drawing of each, 32x32: places, robots, and the options it is learnt with.
DRAWINGS = {
    "large": (12, 2, ["--cleared", "any"]),
    "sixteen": (16, 4, []),
    "twenty_six": (26, 3, []),
}


def draw(places, robots):
    """A mission's drawing, always the same one: walls on 15 of 100 cells."""
    state = 3

    def below(limit):
        nonlocal state
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (state >> 33) % limit

    cells = ["#" if below(100) < 15 else "." for _ in range(CELLS)]
    for glyph in "1" * places + "S" * robots:
        cell = below(CELLS)
        while cells[cell] != ".":
            cell = below(CELLS)
        cells[cell] = glyph
    return "\n".join("".join(cells[row : row + 32]) for row in range(0, CELLS, 32)) + "\n"


def learn(tool, mission, tables, name, options):
    """Learns a mission into tables/name.c, and returns the bytes that a robot keeps of it."""
    source = tables / f"{name}.c"
    subprocess.run([tool, "learn", str(mission), "-q", *options, "--c", str(source)], check=True)
    text = source.read_text(encoding="utf-8")
    return int(text[text.index(f"{name}_size = ") :].split("= ")[1].split(";")[0])


def learn_all(tool, project, tables):
    tables.mkdir(parents=True, exist_ok=True)
    sizes = {}
    for name, (places, robots, options) in DRAWINGS.items():
        drawing = tables / f"{name}.txt"
        drawing.write_text(draw(places, robots), encoding="utf-8")
        sizes[name] = learn(tool, drawing, tables, name, options)
    missions = project / "demo" / "missions"
    for name in MISSIONS:
        sizes[name] = learn(tool, missions / name / "mission.yaml", tables, name, [])
    learn(tool, missions / "turtlebot3_world" / "mission.yaml", tables, "patrol", [])
    return sizes


# ---- the document ----


def number(value):
    return f"{value:,}" if isinstance(value, int) else str(value)


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "| --- |" + " ---: |" * (len(header) - 1)]
    return "\n".join(lines + ["| " + " | ".join(number(cell) for cell in row) + " |" for row in rows]) + "\n"


LOOP = "flash: README.md's loop, without save, restore, blocked"
LINKED = "the same with link-time optimisation (`-flto`)"
CALLED = "stack, worst: by the calls"
WHOLE = "RAM: policy, seeker and field"


def row(title, measured, key, aim=""):
    return [title, *(measures[key] for measures in measured), aim]


def board_rows(measured):
    divides = ["yes" if measures["divides"] else "no" for measures in measured]
    return [
        row(LOOP, measured, "loop", "5,120"),
        row(LINKED, measured, "loop_lto", "4,096"),
        row("flash: save, restore, blocked and lost besides", measured, "restart", "800"),
        row(LINKED, measured, "restart_lto", "800"),
        ["software division is linked", *divides, "no"],
        row(CALLED, measured, "stack", "300"),
        row("stack: painted, after the loop on an emulated board", measured, "painted"),
        row("RAM: `qtr_policy`", measured, "policy"),
        row("RAM: `qtr_seeker`", measured, "seeker"),
        row(f"RAM: `qtr_field`, {CELLS:,} cells", measured, "field", f"{3 * CELLS:,}"),
        row(WHOLE, measured, "ram"),
    ]


def terms_rows(plain, terms):
    """Each figure with the terms, and what they add to that without."""
    rows = []
    for title, key, aim in ((LOOP, "loop", "1,024"), (LINKED, "loop_lto", "1,024"), (CALLED, "stack", "64"), (WHOLE, "ram", "64")):
        added = [{key: with_terms[key] - without[key]} for without, with_terms in zip(plain, terms)]
        rows += [row(title, terms, key), row("&nbsp; more than without terms", added, key, aim)]
    return rows + [
        row("flash: save, restore, blocked and lost besides", terms, "restart"),
        row(LINKED, terms, "restart_lto"),
        row("stack: painted, after the loop on an emulated board", terms, "painted"),
    ]


def count_rows(counted):
    def calls(title, key, aim=""):
        return row(title, counted, key, aim)

    a_byte = [f"{counts['open_large'] / counts['open_large_bytes']:.1f}" for counts in counted]
    others = ("init", "visited", "blocked", "hear", "lost", "announce", "known", "standing", "left", "save", "restore", "target")
    large = counted[0]["open_large_bytes"]
    return [
        [f"open a table of {large:,} B (12 places, any of them cleared): a byte", *a_byte, "20"],
        calls("open a table of 16 places, 4 robots", "open_sixteen", "100,000"),
        calls("open a table of 26 places, 3 robots", "open_twenty_six"),
        calls("26 places: next choice, worst (`qtr_seeker_plan()`)", "plan", "15,000"),
        ["26 places: any other call, worst", *(max(counts[key] for key in others) for counts in counted), "30,000"],
        *(calls(f"&nbsp; `qtr_seeker_{key}()`", key) for key in others),
        calls("26 places: first question where nobody has called `qtr_seeker_plan()`", "asked"),
        calls(f"way over {CELLS:,} cells: `qtr_field_begin()`", "field_begin"),
        calls("way: `qtr_field_work()` of 50 steps, worst", "field_part", "caller's budget"),
        calls("way: all of it, worst", "field_whole"),
    ]


def document(sizes, plain, terms, counted):
    titles = [board.title for board in boards.BOARDS]
    worst = max(terms, key=lambda measures: measures["stack"])
    field = f"{plain[0]['field'] / CELLS:.2f}"
    beside_map = sizes["twenty_six"] - CELLS // 8
    return f"""# What it takes on a robot

`./run sizes` writes this page, and the test `sizes` compares, with
{boards.versions()}.
Under other versions, which give other numbers, the test is skipped. All is compiled by gcc -Os under the `mcu` profile:
{CELLS:,} cells, 16 places, 4 robots. The last column is what the project aims at.

## Without the field's terms

Under `QTR_TERMS` 0: a table that makes use of classes, ready times, endurance, looks, a deadline or home is refused.

{table(["", *titles, "aim"], board_rows(plain))}
Flash is the loop of README.md with all of the library that it needs, and what that needs of C library and compiler; without a
table, without start-up code, without the robot's own functions. The field takes {field} B a cell, of which each takes 2 (4
from 4,096 cells on).

## With the field's terms

As the `mcu` profile has it, and what the terms cost.

{table(["", *titles, "aim"], terms_rows(plain, terms))}
The deepest way of all, on {titles[terms.index(worst)]}:
{" > ".join(f"`{name}`" for name in worst["way"])}.

## Bytes of a table

{table(["mission", "bytes"], [[f"demo/missions/{name}", sizes[name]] for name in MISSIONS])}
A drawing of 32x32 cells with 16 places and 4 robots takes {number(sizes["sixteen"])} B, with 26 places and 3 robots
{number(sizes["twenty_six"])} B, of which {number(beside_map)} B are no map (aim: 1,500 B).

## Instructions

{table(["call", *(board.title for board in boards.COUNTED), "aim"], count_rows(counted))}
Counted by a timer in QEMU, where each instruction takes the same time; the code for a Cortex-M0+ runs on a Cortex-M3. These are
instructions, not cycles. The robots of the mission of 26 places scan in turn, in passing and in no order, meet shut doors, hear
that others are done or lost, and restart after each place; the drawings are those of the tables above.
"""


# ---- what is measured ----

PLANTED = """
00000000 <loop>:
   0:\tpush\t{r4, r5, r6, lr}
   2:\tbl\t10 <deep>
   6:\tbl\t20 <shallow>

00000010 <deep>:
  10:\tsub\tsp, #64
  12:\tb.n\t20 <shallow>

00000020 <shallow>:
  20:\taddi\tsp,sp,-16
  22:\tbne.n\t20 <shallow>
"""


def prove_that_stacks_are_followed():
    functions = call_graph.read_disassembly(PLANTED)

    def depth(usage, wanted):
        size, _ = call_graph.deepest(functions, usage, "loop")
        return [] if size == wanted else [f"{size} B"]

    cases = [("instructions", ({}, 96), 0), ("the compiler's word", ({"loop": 24, "deep": 40}, 80), 0), ("another sum", ({}, 95), 1)]
    self_test(cases, depth)


def measure(options):
    prove_that_stacks_are_followed()
    boards.look_for_tools()
    tables = options.work / "tables"
    sizes = learn_all(options.tool, options.project, tables)
    plain, terms, counted = [], [], []
    for board in boards.BOARDS:
        folder = boards.build(board, options.project, options.cmake, options.generator, options.work, tables)
        plain.append(boards.image_measures(board, folder, False))
        terms.append(boards.image_measures(board, folder, True))
        counted += [boards.counts_of(folder)] if board in boards.COUNTED else []
    return document(sizes, plain, terms, counted)


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--project", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--tool", required=True, help="the host command quarter")
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--generator", default="Ninja")
    parser.add_argument("--check", action="store_true", help="write nothing; say what would change")
    options = parser.parse_args()
    options.project, options.work = options.project.resolve(), options.work.resolve()
    return options


def main():
    options = parse()
    path = options.project / "docs" / "sizes.md"
    before = path.read_text(encoding="utf-8") if path.exists() else ""
    try:
        if options.check and boards.look_for_tools() is None and f"\n{boards.versions()}.\n" not in before:
            raise boards.Missing(f"docs/sizes.md is of other versions than {boards.versions()}")
        now = measure(options)
    except boards.Missing as missing:
        print(f"SKIPPED: {missing}")
        sys.exit(77)
    if not options.check:
        path.write_text(now, encoding="utf-8")
    elif now != before:
        sys.stdout.writelines(difflib.unified_diff(before.splitlines(True), now.splitlines(True), "docs/sizes.md", "now", n=0))
        sys.exit("docs/sizes.md is not what ./run sizes writes now")


if __name__ == "__main__":
    main()
