"""check_rooms.py PROJECT: small rooms, in C, in Python and in the viewer's scripts. CONTRIBUTING.md states the limits.

A function: FUNCTION_LINES from its signature to its end, cyclomatic complexity COMPLEXITY. That is 1, and 1 for each branch:
in C and in scripts if, for, while, case, catch, &&, ||, ?? and ?; in Python if, for, while, except, case, and, or, also
within an expression. A function within a Python function, or a lambda, is one of its own; in a script all within a function
at its top level counts to that. A file: FILE_LINES. A test's main in C, a list of the tests, may be longer.
"""

import ast
import pathlib
import re
import sys

from check_source import blanked, blanked_script, report, self_test

FUNCTION_LINES = 60
COMPLEXITY = 10
FILE_LINES = 500
FOLDERS = ("include", "lib", "tools", "demo", "tests")
SUFFIXES = (".c", ".h", ".py", ".js", ".html")

BRANCH = re.compile(r"\b(?:if|for|while|case)\b|&&|\|\||\?")
SCRIPT_BRANCH = re.compile(r"\b(?:if|for|while|case|catch)\b|&&|\|\||\?\?|\?(?![.?])")
SCRIPT_FUNCTION = re.compile(r"^(?:async )?function (\w+)|^const (\w+) = (?:async )?(?:\([^()]*\)|\w+) =>", re.MULTILINE)
PYTHON_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
PYTHON_BRANCHES = (ast.If, ast.IfExp, ast.For, ast.AsyncFor, ast.While, ast.ExceptHandler, ast.match_case)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
BODY = re.compile(r"\)\s*\{")


def c_functions(text):
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


def python_branches(node):
    """Branches below a node, those of functions within left out."""
    count = 0
    for child in ast.iter_child_nodes(node):
        if isinstance(child, (*PYTHON_FUNCTIONS, ast.Lambda)):
            continue
        count += isinstance(child, PYTHON_BRANCHES)
        if isinstance(child, ast.BoolOp):
            count += len(child.values) - 1
        if isinstance(child, ast.comprehension):
            count += 1 + len(child.ifs)
        count += python_branches(child)
    return count


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, PYTHON_FUNCTIONS):
            yield node.name, node.lineno, node.end_lineno - node.lineno + 1, 1 + python_branches(node)


def script_functions(text):
    """Those at the top level of a script. Such a one ends with the first line that begins with a brace, or in one line."""
    code = blanked_script(text)
    for match in SCRIPT_FUNCTION.finditer(code):
        line_end = code.index("\n", match.start())
        opens = code[line_end - 1] in "{([" or match.group(1)
        closed = re.compile(r"^[})\]]", re.MULTILINE).search(code, line_end) if opens else None
        body = code[match.start() : closed.start() + 1 if closed else line_end]
        first = code.count("\n", 0, match.start()) + 1
        yield match.group(1) or match.group(2), first, body.count("\n") + 1, 1 + len(SCRIPT_BRANCH.findall(body))


FUNCTIONS = {".c": c_functions, ".h": c_functions, ".py": python_functions, ".js": script_functions}


def check_file(name, text):
    faults = []
    if text.count("\n") > FILE_LINES:
        faults.append(f"{name}: {text.count(chr(10))} lines, more than {FILE_LINES}")
    functions = FUNCTIONS.get(pathlib.PurePosixPath(name).suffix)
    for function, line, lines, complexity in functions(text) if functions else []:
        is_list = function == "main" and re.match(r"tests/.*\.c$", name)
        if lines > FUNCTION_LINES and not is_list:
            faults.append(f"{name}:{line}: {function} has {lines} lines, more than {FUNCTION_LINES}")
        if complexity > COMPLEXITY:
            faults.append(f"{name}:{line}: {function} has complexity {complexity}, more than {COMPLEXITY}")
    return faults


def prove_for_c():
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


def prove_for_the_others():
    def python(lines, branches):
        return "def f(x):\n" + "    if x and x: x -= 1\n" * branches + "    x += 1\n" * (lines - branches - 1)

    def script(lines, branches):
        body = "  if (x ?? y) x?.z; // if\n" * branches + "  x++;\n" * (lines - branches - 2)
        return "const z = () => 1;\nfunction f(x) {\n" + body + "}\nconst y = /[?]/;\n"

    nested = "def f(x):\n    def g(y):\n        return " + "y and " * 9 + "y\n    return x and g(x)\n"
    within = "def f(x):\n    return [y for y in x if y] + " + "[y for y in x] + " * 8 + "[]\n"
    self_test(
        [
            ("nothing in Python", ("tests/f.py", python(60, 4)), 0),
            ("a long Python function", ("tests/f.py", python(61, 4)), 1),
            ("a winding Python function", ("tools/f.py", python(60, 5)), 1),
            ("a Python function within", ("tools/f.py", nested), 0),
            ("winding expressions", ("tools/f.py", within), 1),
            ("a long Python file", ("tests/f.py", "x = 1\n" * 501), 1),
            ("nothing in a script", ("demo/f.js", script(60, 4)), 0),
            ("a long function of a script", ("demo/f.js", script(61, 4)), 1),
            ("a winding function of a script", ("demo/f.js", script(60, 5)), 1),
            ("a winding line of a script", ("demo/f.js", "const f = (a) => a" + " && a" * 10 + ";\n"), 1),
            ("a long page", ("demo/f.html", "<p>\n" * 501), 1),
        ],
        check_file,
    )


def main():
    prove_for_c()
    prove_for_the_others()
    project = pathlib.Path(sys.argv[1])
    found = sorted(path for folder in FOLDERS for path in (project / folder).rglob("*"))
    paths = [path for path in found if path.suffix in SUFFIXES]
    faults = []
    for path in paths:
        faults += check_file(path.relative_to(project).as_posix(), path.read_text(encoding="utf-8"))
    report(faults, f"{len(paths)} files: functions of {FUNCTION_LINES} lines and complexity {COMPLEXITY} at most")


main()
