"""What the checks share: source without its comments and strings, line for line."""

import re

TOKEN = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)

# A slash begins a regular expression where a value may begin.
SCRIPT_TOKEN = re.compile(
    TOKEN.pattern + r"|`(?:\\.|[^`\\])*`|(?<=[(=,:!])\s*/(?![/*])(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n])+/", re.DOTALL
)


def blanked(text, keep_strings=False):
    """`text` with comments (and what strings and character constants hold) as spaces; line breaks stay."""

    def blank(match):
        token = match.group(0)
        if token[0] in "\"'":
            return token if keep_strings else token[0] + " " * (len(token) - 2) + token[0]
        return re.sub(r"[^\n]", " ", token)

    return TOKEN.sub(blank, text)


def blanked_script(text):
    """JavaScript with comments, strings, templates and regular expressions as spaces; line breaks stay."""
    return SCRIPT_TOKEN.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), text)


def self_test(cases, check):
    """Each case: what is planted, its arguments for `check`, and how many faults `check` must find."""
    for name, arguments, expected in cases:
        found = check(*arguments)
        if len(found) != expected:
            raise SystemExit(f"self-test: {name}: {len(found)} faults found, {expected} planted: {found}")


def report(faults, done):
    """End with a line for each fault, or with what was checked."""
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults" if faults else done)
    raise SystemExit(1 if faults else 0)
