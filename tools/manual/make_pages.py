"""make_pages.py --quarter PROGRAM --source PROJECT --scdoc PROGRAM DIR: the manual's pages, made of what is said elsewhere.

quarter(1) and a page a command are what --help prints, quarter-mission(5) is what `quarter keys` prints, and quarter-policy(5)
is docs/policy-format.md. All of it goes through scdoc, whose source files stay beside the pages.
"""

import argparse
import os
import pathlib
import subprocess

import from_help
import from_markdown


def run(*words):
    return subprocess.run(words, check=True, encoding="utf-8", stdout=subprocess.PIPE).stdout


def write(folder, page, text, scdoc):
    source = folder / f"{page}.scd"
    source.write_text(text, encoding="utf-8")
    with source.open("rb") as stream, (folder / page).open("wb") as out:
        subprocess.run([scdoc], check=True, stdin=stream, stdout=out)


def pages(quarter, project):
    """The name of each page, and its text as scdoc takes it."""
    version = run(quarter, "--version").strip()
    overview = run(quarter, "--help")
    commands = from_help.commands_of(overview)
    yield "quarter.1", from_help.overview_page(overview, commands, version)
    for name, summary in commands.items():
        yield f"quarter-{name}.1", from_help.command_page(name, summary, run(quarter, name, "--help"), commands, version)
    keys, layout = run(quarter, "keys"), (project / "docs" / "policy-format.md").read_text(encoding="utf-8")
    yield "quarter-mission.5", from_markdown.page("quarter-mission", "what a mission for quarter says", keys, version)
    yield "quarter-policy.5", from_markdown.page("quarter-policy", "the bytes of quarter's policy tables", layout, version)


def main():
    words = argparse.ArgumentParser()
    words.add_argument("--quarter", required=True)
    words.add_argument("--source", required=True, type=pathlib.Path)
    words.add_argument("--scdoc", required=True)
    words.add_argument("folder", type=pathlib.Path)
    given = words.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    for old in given.folder.glob("quarter*.[15]*"):
        old.unlink()
    for page, text in pages(os.path.abspath(given.quarter), given.source):
        write(given.folder, page, text, given.scdoc)


main()
