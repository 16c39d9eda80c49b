"""check_shell.py PROJECT: no shell script pipes into a command that stops reading early.

What writes into such a pipe dies of it, now and then, and under `set -o pipefail` the whole fails although all went well.
"""

import pathlib
import re
import sys

from check_source import report, self_test

LEFT_OUT = {".git", ".cache", "build"}
EARLY = re.compile(r"\|&?\s*(?:\w+=\S*\s+)*(?:[efz]?grep\s+(?:-\S+\s+)*(?:-\w*[qm]|--(?:quiet|silent|max-count))"
                   r"|head\b|sed\s+[^|]*\b\d*q\b|awk\s+[^|]*\bexit\b)")


def early_readers(text):
    """One fault for each line with such a pipe; a pipe may go on after a line's end."""
    joined = re.sub(r"\\\n|(?<=\|)[ \t]*\n", "\0", text)
    faults, number = [], 1
    for line in joined.split("\n"):
        if EARLY.search(re.sub(r"(^|\s)#.*", "", line).replace("\0", " ")):
            faults.append(f"line {number}: a pipe into a command that stops reading early: {line.strip()[:80]!r}")
        number += 1 + line.count("\0")
    return faults


def scripts(project):
    """The shell scripts: by the end of their names, or by their first line."""
    for path in sorted(project.rglob("*")):
        if LEFT_OUT.intersection(path.relative_to(project).parts) or not path.is_file():
            continue
        with path.open("rb") as file:
            if path.suffix == ".sh" or re.match(rb"#!.*\b(ba|da)?sh\b", file.readline(80)):
                yield path


def main():
    project = pathlib.Path(sys.argv[1]).resolve()
    self_test([("a pipe read to its end", ("ldconfig -p | grep -F x >/dev/null\n",), 0),
               ("a comment", ("# a | grep -q b\n",), 0),
               ("grep -q", ("ldconfig -p | grep -qF x\n",), 1),
               ("grep -q over two lines", ("ldconfig -p |\n  grep -F -q x\n",), 1),
               ("head", ("sort -V | head -n 1\n",), 1),
               ("sed that quits", ("ls | sed 1q\n",), 1)], early_readers)
    found = list(scripts(project))
    assert project / "run" in found, "the scripts are found"
    faults = [f"{path.relative_to(project)}: {fault}" for path in found
              for fault in early_readers(path.read_text(encoding="utf-8"))]
    report(faults, f"{len(found)} shell scripts read their pipes to the end")


main()
