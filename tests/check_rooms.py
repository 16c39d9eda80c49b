"""check_rooms.py PROJECT: small rooms. The limits are these, and CONTRIBUTING.md states them.

A function: FUNCTION_LINES from its signature to its last brace, cyclomatic complexity COMPLEXITY (1, and 1 for each
if, for, while, case, &&, || and ?). A file: FILE_LINES. A test's main, a list of the tests, may be longer.
"""

import pathlib
import re
import sys

from check_source import blanked, report, self_test

FUNCTION_LINES = 60
COMPLEXITY = 10
FILE_LINES = 500
FOLDERS = ("include", "lib", "tools", "demo", "tests")

BRANCH = re.compile(r"\b(?:if|for|while|case)\b|&&|\|\||\?")
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
BODY = re.compile(r"\)\s*\{")


def functions(text):
    """(name, first line, lines, complexity) of every function defined in C source."""
    code = DIRECTIVE.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), blanked(text))
    depth, start = 0, None
    end_of_last = 0  # where the previous declaration or definition ended
    for match in re.finditer(r"[{};]", code):
        sign, at = match.group(0), match.start()
        if sign == "{":
            if depth == 0 and BODY.search(code[end_of_last : at + 1]):
                start = end_of_last
            depth += 1
        elif sign == "}":
            depth -= 1
            if depth == 0 and start is not None:
                whole = code[start : at + 1]
                begin = start + len(whole) - len(whole.lstrip())
                name = re.search(r"(\w+)\s*\(", whole)
                first = code.count("\n", 0, begin) + 1
                lines = code.count("\n", begin, at) + 1
                yield name.group(1), first, lines, 1 + len(BRANCH.findall(whole))
                start = None
        if depth == 0:
            end_of_last = at + 1


def check_file(name, text):
    faults = []
    if text.count("\n") > FILE_LINES:
        faults.append(f"{name}: {text.count(chr(10))} lines, more than {FILE_LINES}")
    for function, line, lines, complexity in functions(text):
        if lines > FUNCTION_LINES and not (function == "main" and name.startswith("tests/")):
            faults.append(f"{name}:{line}: {function} has {lines} lines, more than {FUNCTION_LINES}")
        if complexity > COMPLEXITY:
            faults.append(f"{name}:{line}: {function} has complexity {complexity}, more than {COMPLEXITY}")
    return faults


def prove_that_it_fails():
    def function(lines, branches):
        body = ["  if (x) x--; /* if */"] * branches + ["  x++;"] * (lines - branches - 2)
        return "#define IF(x) if (x) {\nint table[] = {1, 2};\nint f(int x) {\n" + "\n".join(body) + "\n}\n"

    self_test(
        [
            ("nothing", ("lib/f.c", function(60, 9)), 0),
            ("a long function", ("lib/f.c", function(61, 9)), 1),
            ("a winding function", ("lib/f.c", function(60, 10)), 1),
            ("both", ("lib/f.c", function(61, 10)), 2),
            ("a long test main", ("tests/f.c", function(61, 0).replace("f(int x)", "main(int x)")), 0),
            ("a winding line", ("lib/f.c", "int f(int a) { return a && a || a ? a : a " + "|| a" * 8 + "; }"), 1),
            ("a long file", ("lib/f.c", "int x;\n" * 501), 1),
        ],
        check_file,
    )


def main():
    prove_that_it_fails()
    project = pathlib.Path(sys.argv[1])
    paths = sorted(path for folder in FOLDERS for path in (project / folder).rglob("*.[ch]"))
    faults = []
    for path in paths:
        faults += check_file(path.relative_to(project).as_posix(), path.read_text(encoding="utf-8"))
    report(faults, f"{len(paths)} files: functions of {FUNCTION_LINES} lines and complexity {COMPLEXITY} at most")


main()
