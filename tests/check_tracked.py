"""check_tracked.py PROJECT: what the project's history holds is the project's own.

A link leads to a place that others do not have, and one in the stead of a folder that is made when it is missing is worse: it
can be neither entered nor made. What .gitignore leaves out was never meant to be there. A text that names somebody's home
does not hold elsewhere. Without a repository, as in an archive of the sources, there is nothing to look at.
"""

import pathlib
import re
import shutil
import subprocess
import sys

from check_source import report, self_test

LINK = "120000"
HOME = re.compile(rb"(?<![\w.])/(?:home|root|Users|work|workspace)/\w")


def git(project, *arguments):
    command = ["git", "-c", "safe.directory=*", "-C", project, *arguments]
    return subprocess.run(command, capture_output=True, check=True).stdout.decode().split("\0")[:-1]


def faults_of(mode, name, ignored, text):
    """Those of one file."""
    found = []
    if mode == LINK:
        found.append(f"{name}: a link")
    if name in ignored:
        found.append(f"{name}: .gitignore leaves it out")
    if mode != LINK and b"\0" not in text:
        found += [f"{name}: line {text.count(10, 0, match.start()) + 1}: names a folder of one machine"
                  for match in HOME.finditer(text)]
    return found


def main():
    project = pathlib.Path(sys.argv[1]).resolve()
    somewhere = b"see /" + b"home/ada/notes"
    self_test([("a file", ("100644", "run", set(), b"echo /usr/bin; a.b/Users/x\n"), 0),
               ("a link", (LINK, "data", set(), b""), 1),
               ("what is left out", ("100644", "build/a", {"build/a"}, b""), 1),
               ("a home folder", ("100644", "notes", set(), b"\n" + somewhere), 1),
               ("not in pictures", ("100644", "a.png", set(), b"\0" + somewhere), 0)], faults_of)
    if not (project / ".git").exists() or shutil.which("git") is None:
        report([], "no repository: nothing is tracked")
    ignored = set(git(project, "ls-files", "-z", "--cached", "--ignored", "--exclude-standard"))
    faults = []
    entries = git(project, "ls-files", "-z", "--stage")
    for entry in entries:
        mode, name = entry.split(" ", 1)[0], entry.split("\t", 1)[1]
        path = project / name
        text = path.read_bytes() if mode != LINK and path.is_file() else b""
        faults += faults_of(mode, name, ignored, text)
    report(faults, f"{len(entries)} tracked files are the project's own")


main()
