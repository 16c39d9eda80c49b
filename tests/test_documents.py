"""test_documents.py --quarter PROGRAM --source PROJECT [--mend] DOCUMENT...

Every command of a document is run, and prints what the document shows. In its blocks that are indented by four blanks, a line
that begins with "$ " is a command, as a shell takes it, with the lines of its here-documents; what follows, up to the next or the
block's end, is what it prints. A ```yaml FILE block gives values for keys of the mission FILE, which are put into it as a
reader would. All of a document runs in one new folder, with `quarter` in the PATH and the checkout in $QUARTER. How many games and
how long learning took is not compared; figures of a plan that is known to be improvable are, by and large. --mend writes what is printed now into the documents.

Skipped (77) where the build lacks a library that a command of the document wants.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

INDENT = "    "
# How the plan was come to, where in a mission that `quarter new` wrote a key stands, and what random starts lose.
PASSING = re.compile(
    r"^\d+ episodes?, \d+ updates?, \d+ Q entr(?:y|ies) \(\d+ bytes?\), \S+ s$|(?<=\.yaml):\d+(?=: )|(?<=loses ).*(?= against)"
)
# A plan that is not the best to the end: a better way to search finds another. How near it is stands in the first number.
OPEN = re.compile(r"(within|at most) \S+% (of|from) the optimum")
OPEN_SHARE = 0.15
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")
LACKS = re.compile(r"which was not there when Quarter was built")


class Skipped(Exception):
    pass


def parts_of(text):
    """("text", lines), ("yaml", file, lines) and ("block", lines) in their order; together they are the document."""
    lines, at = text.split("\n"), 0
    while at < len(lines):
        begin = at
        match = re.fullmatch(r"```yaml (\S+)", lines[at])
        if match:
            at = lines.index("```", at) + 1
            yield "yaml", match[1], lines[begin:at]
        elif lines[at].startswith(INDENT + "$ "):
            while at < len(lines) and lines[at].startswith(INDENT):
                at += 1
            yield "block", "", lines[begin:at]
        else:
            at += 1
            yield "text", "", lines[begin:at]


def commands_of(block):
    """(the command's lines, the lines that it is to print), without the indentation."""
    lines, at = [line[len(INDENT) :] for line in block], 0
    while at < len(lines):
        command = [lines[at]]
        at += 1
        here = re.search(r"<<'(\w+)'", command[0])
        while here and command[-1] != here[1]:
            command.append(lines[at])
            at += 1
        begin = at
        while at < len(lines) and not lines[at].startswith("$ "):
            at += 1
        yield command, lines[begin:at]


def put_in(text, block):
    """A mission with the block's keys in the place of its own, stated or behind a #."""
    for part in re.split(r"\n(?=[a-z_]+:)", block):
        key = part.split(":")[0]
        place = re.compile(rf"^#?{key}:.*\n(?: +.*\n)*", re.MULTILINE)
        if len(place.findall(text)) != 1:
            raise AssertionError(f"the mission has no key {key} of which a value could be written in")
        text = place.sub(lambda _, part=part: part + "\n", text)
    return text


def run(command, folder, environment):
    script = "\n".join(command)[2:]
    done = subprocess.run(["sh", "-c", script], cwd=folder, env=environment, encoding="utf-8", check=False,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if LACKS.search(done.stdout):
        raise Skipped(done.stdout)
    return done.stdout.removesuffix("\n").split("\n") if done.stdout else []


def near(found, wanted):
    return abs(float(found) - float(wanted)) <= OPEN_SHARE * abs(float(wanted))


def same_line(found, wanted):
    found, wanted = PASSING.sub("", found), PASSING.sub("", wanted)
    if not (OPEN.search(found) and OPEN.search(wanted)):
        return found == wanted
    found, wanted = OPEN.sub(r"\1 \2", found), OPEN.sub(r"\1 \2", wanted)
    if NUMBER.sub("", found) != NUMBER.sub("", wanted):
        return False
    return all(near(*pair) for pair in zip(NUMBER.findall(found), NUMBER.findall(wanted), strict=True))


def same(printed, shown):
    return len(printed) == len(shown) and all(same_line(*pair) for pair in zip(printed, shown, strict=True))


def play_block(block, folder, environment):
    """The block as it ought to be, and what is wrong with it."""
    mended, faults = [], []
    for command, shown in commands_of(block):
        printed = run(command, folder, environment)
        if not same(printed, shown):
            faults.append("\n".join([f"{command[0]}\nprints", *printed, "not", *shown]))
        else:
            printed = shown
        mended += [INDENT + line if line else INDENT.rstrip() for line in command + printed]
    return mended, faults


def play(text, folder, environment):
    """The document as it ought to be, and what is wrong with it."""
    mended, faults = [], []
    for kind, name, lines in parts_of(text):
        if kind == "yaml":
            mission = folder / name
            stated = put_in(mission.read_text(encoding="utf-8"), "\n".join(lines[1:-1]))
            mission.write_text(stated, encoding="utf-8")
        if kind == "block":
            lines, wrong = play_block(lines, folder, environment)
            faults += wrong
        mended += lines
    return "\n".join(mended), faults


def self_test():
    """What it finds wrong in a small document, and what it mends it to."""
    folder = pathlib.Path("self")
    folder.mkdir(exist_ok=True)
    (folder / "m.yaml").write_text("a: 1\n\n#b:\n  - 2\n#c: 3\n", encoding="utf-8")
    right = "Text.\n\n```yaml m.yaml\nb:\n  - 5\n```\n\n    $ cat <<'END' && cat m.yaml\n    x\n    END\n    x\n    a: 1\n\n"
    right = right.replace("a: 1\n\n", "a: 1\n    \n    b:\n      - 5\n    #c: 3\n")
    mended, faults = play(right.replace("a: 1", "a: 2"), folder, os.environ)
    assert len(faults) == 1 and "prints" in faults[0], faults
    assert same(["certified: within 1% of the optimum; value 2"], ["certified: within 3% of the optimum; value 2.1"])
    assert not same(["certified: within 1% of the optimum; value 2"], ["certified: within 3% of the optimum; value 3"])
    assert not same(["certified optimal; value 2"], ["certified optimal; value 2.1"])
    assert [line.rstrip() for line in mended.split("\n")] == [line.rstrip() for line in right.split("\n")], mended


def main():
    words = argparse.ArgumentParser()
    words.add_argument("--quarter", required=True, type=pathlib.Path)
    words.add_argument("--source", required=True, type=pathlib.Path)
    words.add_argument("--mend", action="store_true")
    words.add_argument("documents", nargs="+", type=pathlib.Path)
    given = words.parse_args()
    self_test()
    environment = dict(os.environ, PATH=f"{given.quarter.parent}:{os.environ['PATH']}", QUARTER=str(given.source), LC_ALL="C")
    wrong = []
    for document in given.documents:
        folder = pathlib.Path(document.stem)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        text = document.read_text(encoding="utf-8")
        mended, faults = play(text, folder, environment)
        wrong += [f"{document}: {fault}" for fault in faults]
        if given.mend and mended != text:
            document.write_text(mended, encoding="utf-8")
    if wrong and not given.mend:
        sys.exit("\n\n".join(wrong) + "\n\n--mend writes what is printed now into the documents, to be looked at")


try:
    main()
except Skipped as reason:
    print(f"SKIPPED: {reason}")
    sys.exit(77)
