"""check_misra.py PROJECT WORK: the robot side against MISRA C:2012, as far as cppcheck looks. What it finds stands in docs/misra.md,
a row a rule, with how often at most and why it stays; a rule that is not listed is a fault, and so is a finding more. Ends with
77 without cppcheck, or where its version is not the document's: each finds other things.
"""

import pathlib
import re
import shutil
import subprocess
import sys
from collections import Counter

from check_source import report, self_test

ROW = re.compile(r"^\| (\d+\.\d+) \|[^|]*\|[^|]*\| (\d+) \|", re.MULTILINE)
BUILD = ["--std=c99", "-Iinclude", "-Ilib", "-DQTR_PROFILE_MCU", "-DNDEBUG"]
# Where distributions keep cppcheck's addons, from the folder of its program.
ADDONS = ("../lib/*/cppcheck/addons", "../lib*/cppcheck/addons", "../share/cppcheck/addons", "../share/Cppcheck/addons")
DIRECT = re.compile(r"^\[([^\]]+:\d+)\].*\[misra-c2012-(\d+\.\d+)\]$", re.MULTILINE)
WHOLE = re.compile(r"^(\S+:\d+): misra-c2012-(\d+\.\d+)$", re.MULTILINE)


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(77)


def find_addon(program):
    folder = pathlib.Path(program).resolve().parent
    found = [path for place in ADDONS for path in sorted(folder.glob(f"{place}/misra.py"))]
    return found[0] if found else None


def run(command, work):
    done = subprocess.run(command, cwd=work, capture_output=True, encoding="utf-8", errors="replace")
    return done.stdout + done.stderr


def findings(program, addon, project, work):
    """{(file:line, rule)}. By the addon over dumps, for cppcheck itself tells one finding a line; and by cppcheck, which alone
    puts the files together."""
    shutil.rmtree(work, ignore_errors=True)
    for folder in ("include", "lib/core", "lib/robot"):
        shutil.copytree(project / folder, work / folder)
    sources = sorted(str(path.relative_to(work)) for side in ("core", "robot") for path in (work / "lib" / side).glob("*.c"))
    run([program, "--quiet", "--dump", *BUILD, *sources], work)
    direct = run([sys.executable, "-B", str(addon), *(f"{source}.dump" for source in sources)], work)
    template = "--template={file}:{line}: {id}"
    whole = run([program, "--quiet", "--addon=misra", template, *BUILD, *sources], work)
    found = set(DIRECT.findall(direct)) | set(WHOLE.findall(whole))
    if not found:
        sys.exit(f"cppcheck found nothing at all, which cannot be:\n{direct}{whole}")
    return found


def order(rule):
    return [int(number) for number in rule.split(".")]


def compare(found, listed):
    """`found`: {(where, rule)}; `listed`: {rule: how often at most}."""
    faults = []
    for rule, count in sorted(Counter(rule for _, rule in found).items(), key=lambda item: order(item[0])):
        if count > listed.get(rule, 0):
            where = " ".join(sorted(where for where, of in found if of == rule))
            faults.append(f"rule {rule}: {count} found, docs/misra.md has {listed.get(rule, 0)}: {where}")
    return faults


def main():
    cases = [
        ("nothing", ({("a.c:1", "15.5")}, {"15.5": 1}), 0),
        ("a rule that is not listed", ({("a.c:1", "15.5")}, {}), 1),
        ("one more", ({("a.c:1", "15.5"), ("a.c:2", "15.5")}, {"15.5": 1}), 1),
        ("one less", ({("a.c:1", "15.5")}, {"15.5": 3, "2.1": 1}), 0),
    ]
    self_test(cases, compare)
    project, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    document = (project / "docs" / "misra.md").read_text(encoding="utf-8")
    listed = {rule: int(count) for rule, count in ROW.findall(document)}
    program = shutil.which("cppcheck") or skip("there is no cppcheck")
    version = run([program, "--version"], project).split()[-1]
    if f"cppcheck {version}, with" not in document:
        skip(f"docs/misra.md is not of cppcheck {version}")
    addon = find_addon(program) or skip("cppcheck has no misra.py")
    found = findings(program, addon, project, work)
    report(compare(found, listed), f"{len(found)} findings, each of a rule that docs/misra.md has")


main()
