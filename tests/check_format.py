"""check_format.py PROJECT CLANG_FORMAT [--mend]: every C file is laid out as .clang-format says, by the pinned clang-format.

With --mend the files are laid out so.
"""

import pathlib
import subprocess
import sys

from check_source import report, self_test

WIDTH = 120  # as .clang-format has it
FOLDERS = ("include", "lib", "tools", "demo", "tests", "examples")


def differs(formatter, project, text):
    """A list with one fault if `text` is laid out otherwise than .clang-format says."""
    style = f"file:{project / '.clang-format'}"
    run = subprocess.run([formatter, f"--style={style}", "--assume-filename=x.c"], input=text.encode("utf-8"),
                         stdout=subprocess.PIPE, check=True)
    return [] if run.stdout == text.encode("utf-8") else ["differs"]


def sources(project):
    return sorted(path for folder in FOLDERS for path in (project / folder).rglob("*.[ch]"))


def long_lines(project):
    """clang-format breaks code, and leaves comments as they are."""
    return [f"{path.relative_to(project)}:{number}: {len(line)} characters, more than {WIDTH}" for path in sources(project)
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1) if len(line) > WIDTH]


def unkept(formatter, project):
    """One line for each file that is laid out otherwise."""
    run = subprocess.run([formatter, "--dry-run", "--style=file", "--ferror-limit=1", *map(str, sources(project))],
                         stderr=subprocess.PIPE, check=True)
    lines = run.stderr.decode("utf-8", "replace").splitlines()
    return [line for line in lines if "[-Wclang-format-violations]" in line]


def main():
    project, formatter = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    if sys.argv[3:] == ["--mend"]:
        subprocess.run([formatter, "-i", "--style=file", *map(str, sources(project))], check=True)
    self_test([("a line as it should be", (formatter, project, "int a = 1;\n"), 0),
               ("a blank too many", (formatter, project, "int  a = 1;\n"), 1)], differs)
    faults = unkept(formatter, project)
    if faults:
        faults.append("`cmake --build build/release --target format` lays them out")
    faults += long_lines(project)
    report(faults, f"{len(sources(project))} files are laid out as .clang-format says")


main()
