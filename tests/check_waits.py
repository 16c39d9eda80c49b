"""check_waits.py PROJECT: no test sleeps or looks at a clock, and none reads or writes text as the user's locale has it.

A test that waits for time to pass is too slow on one machine and too fast for another. What happens can be waited for.
"""

import pathlib
import re
import sys

from check_source import report, self_test

WAITING = re.compile(r"\b(?:u|nano|clock_nano)?sleep\s*\(|\bsleep\s+[\d.$]|\bsettimeout\s*\(\s*[^)N]|\btime\.(?:time|monotonic)\b"
                     r"|\bclock_gettime\b|\bclock_seconds\b|\bsetTimeout\b|\btimeout=(?!DEADLINE\b)")
LOCALE = re.compile(r"\bread_text\(\)|\bwrite_text\((?!.*encoding=)|\btext=True|\buniversal_newlines=|\bopen\([^()]*\"[rwa]\"\)")
LEFT_OUT = {"bench"}  # measures
NAMES = "check_waits.py"
CLOCKS = {"anywhere/silence.py": "time.monotonic()",  # measures: no test waits for what it says
          "tools/test_stop.c": "clock_gettime(clock, &used)"}  # the tool's processor time, which stands still while the tool does


def faults_of(text, python, clock=None):
    rules = [(WAITING, "waits for a clock")] + [(LOCALE, "takes text as the locale has it")] * python
    return [f"line {number}: {what}: {line.strip()[:80]}" for number, line in enumerate(text.split("\n"), 1)
            for pattern, what in rules if pattern.search(line if clock is None else line.replace(clock, ""))]


def main():
    project = pathlib.Path(sys.argv[1]).resolve()
    self_test([("a wait for what happens", ("process.wait()\nselect.select([one], [], [], HANG)\n", True), 0),
               ("a name with sleep in it", ("static void test_asleep(void) {\n", False), 0),
               ("Python's sleep", ("    time.sleep(0.01)\n", True), 1),
               ("C's sleep", ("  usleep(10);\n  nanosleep(&soon, NULL);\n", False), 2),
               ("the shell's sleep", ("sleep 0.1\n", False), 1),
               ("a clock", ("end = time.monotonic() + 5\n", True), 1),
               ("a clock that is allowed", ("end = time.monotonic() + 5\n", True, "time.monotonic()"), 0),
               ("another beside it", ("end = time.monotonic() + 5\ntime.sleep(1)\n", True, "time.monotonic()"), 1),
               ("a limit", ("subprocess.run(words, timeout=60)\n", True), 1),
               ("the page's timer", ("setTimeout(done, 50)\n", True), 1),
               ("text by the locale", ("path.read_text()\nrun(words, text=True)\n", True), 2),
               ("text by its own encoding", ('path.read_text(encoding="utf-8")\n', True), 0)], faults_of)
    found = [path for path in sorted((project / "tests").rglob("*"))
             if path.suffix in (".c", ".h", ".py", ".sh", ".cmake") and path.name != NAMES
             and not LEFT_OUT.intersection(path.relative_to(project).parts)]
    clocks = {project / "tests" / name: clock for name, clock in CLOCKS.items()}
    faults = [f"{path.relative_to(project)}: {fault}" for path in found
              for fault in faults_of(path.read_text(encoding="utf-8"), path.suffix == ".py", clocks.get(path))]
    report(faults, f"{len(found)} files of tests wait for what happens, not for a clock")


main()
