"""test_manual.py --quarter PROGRAM --pages DIR --cmake PROGRAM --build DIR: the manual's pages.

Each command has a page, each of its options a place on it, and each key of a mission one in quarter-mission(5); formatters find
nothing wrong with any of them (groff by way of man, mandoc, whichever is there); an installation has them where man looks. Skipped
(77) where the build made none.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys


def run(*words):
    return subprocess.run(words, check=True, encoding="utf-8", stdout=subprocess.PIPE).stdout


def plain(page):
    """A page's text without its markup."""
    text = re.sub(r"\\f[BIRP]", "", page.read_text(encoding="utf-8"))
    return text.replace("\\&", "").replace("\\-", "-").replace("\\(ti", "~").replace("\\(ha", "^").replace("\\\\", "\\")


def check_commands(quarter, folder):
    commands = set(re.findall(r"^quarter ([a-z]+) ", run(quarter, "--help"), re.MULTILINE)) | {"keys"}
    pages = {path.name for path in folder.glob("*.1")}
    assert pages == {"quarter.1"} | {f"quarter-{command}.1" for command in commands}, pages
    overview = plain(folder / "quarter.1")
    for command in sorted(commands):
        assert f"quarter-{command}(1)" in overview, command
        check_options(run(quarter, command, "--help"), plain(folder / f"quarter-{command}.1"), command)


def check_options(text, page, command):
    """Every option in the lines of options stands on the page, and so does what status 0 means."""
    lines = [line for line in text.split("\n") if re.match(r" {2}-\w, | {6}--", line)]
    assert lines, command
    options = page[page.index("OPTIONS") : page.index("EXIT STATUS")]
    for line in lines:
        for option in re.findall(r"--[a-z][a-z-]*", re.split(r"(?<=\S) {2,}", line)[0]):
            assert re.search(rf"(?<![\w-]){option}(?![\w-])", options), f"quarter-{command}.1 lacks {option}"
    for meaning in re.findall(r"^Exit status: 0 (.*?);", text, re.MULTILINE):
        assert meaning in page, f"quarter-{command}.1 lacks '{meaning}'"


def keys_of(schema):
    """The names of all keys, those of robots, places and classes among them."""
    found = set()
    if isinstance(schema, dict):
        found |= set(schema.get("properties", {}))
        schema = list(schema.values())
    for part in schema if isinstance(schema, list) else []:
        found |= keys_of(part)
    return found


def check_keys(quarter, folder):
    page = plain(folder / "quarter-mission.5")
    keys = keys_of(json.loads(run(quarter, "keys", "--json")))
    assert len(keys) > 40, keys
    terms = "\n".join(re.findall(r"^(.*)\n\.RS 4$", page, re.MULTILINE))
    for key in sorted(keys):
        assert re.search(rf"(?<!\w){key}(?!\w)", terms), f"quarter-mission.5 lacks {key}"


# man shuts its own filters in by seccomp, under which a preloaded library (another clock) cannot work.
MAN = dict(os.environ, LC_ALL="C.UTF-8", MANPAGER="cat", MAN_DISABLE_SECCOMP="1")


def check_format(folder):
    linters = []
    if shutil.which("mandoc"):
        linters.append(["mandoc", "-Tlint", "-Werror"])
    if shutil.which("man") and shutil.which("groff"):
        linters.append(["man", "--warnings", "-l"])
    for page in sorted(folder.glob("*.[15]")):
        for linter in linters:
            done = subprocess.run([*linter, str(page)], check=False, encoding="utf-8", stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, env=MAN)
            said = done.stderr + (done.stdout if linter[0] == "mandoc" else "")
            assert done.returncode == 0 and not said, f"{page.name}: {linter[0]}: {said}"
    return [linter[0] for linter in linters]


def check_installation(cmake, build, folder):
    prefix = pathlib.Path("installed").absolute()
    shutil.rmtree(prefix, ignore_errors=True)
    run(cmake, "--install", build, "--component", "tools", "--prefix", str(prefix))
    found = {path.name for path in prefix.glob("share/man/man[15]/*")}
    assert found == {path.name for path in folder.glob("*.[15]")}, found


def main():
    words = argparse.ArgumentParser()
    for word in ("--quarter", "--pages", "--cmake", "--build"):
        words.add_argument(word, required=True)
    given = words.parse_args()
    folder = pathlib.Path(given.pages)
    if not given.pages or not (folder / "quarter.1").exists():
        print("SKIPPED: scdoc was not there when Quarter was built (package scdoc)")
        sys.exit(77)
    check_commands(given.quarter, folder)
    check_keys(given.quarter, folder)
    linters = check_format(folder)
    check_installation(given.cmake, given.build, folder)
    print("The manual is whole; looked at by", *linters or ["nobody: neither mandoc nor man is here"])


main()
