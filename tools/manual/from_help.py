"""What --help prints as pages of the manual.

The text begins with examples, one a line: the words, two blanks or more, what they do (or that on the next line). Paragraphs follow,
then options, a line or more each, then more paragraphs, and last what begins with "Exit status:".
"""

import itertools
import re

import scd

EXAMPLE = re.compile(r"^(quarter\b.*?)(?: {2,}(\S.*))?$")
OPTION = re.compile(r"^(?: {2}-\w, | {6})(--.*)$")
QUOTED = re.compile(r"'(quarter [^']*)'")
COMMAND = re.compile(r"quarter ([a-z]+)")


def commands_of(overview):
    """What each command does, by its name, in the order of the overview."""
    matches = (EXAMPLE.match(line) for line in overview.split("\n"))
    return {match[1].split()[1]: match[2] for match in matches if match and match[2]}


def name_of(command):
    return f"{scd.bold('quarter-' + command)}(1)"


def command_named(words):
    match = COMMAND.fullmatch(words)
    return name_of(match[1]) if match else scd.bold(words)


def flow(lines):
    """Lines of a paragraph as one; a command named in it is that command's page."""
    parts = QUOTED.split(" ".join(line.strip() for line in lines))
    return "".join(scd.text(part) if i % 2 == 0 else command_named(part) for i, part in enumerate(parts))


def paragraphs(lines):
    """Lists of lines between empty ones."""
    group = []
    for line in [*lines, ""]:
        if line:
            group.append(line)
        elif group:
            yield group
            group = []


# ---- examples ----


def examples(group):
    """(words, what they do) of the lines of examples."""
    found = []
    for line in group:
        match = EXAMPLE.match(line)
        if match:
            found.append([match[1], match[2] or ""])
        else:
            found[-1][1] += line.strip()
    return found


def example_section(found):
    text = scd.heading("EXAMPLES")
    for words, what in found:
        text += scd.definition(scd.bold(words), scd.text(what)) if what else scd.bold(words) + "\n\n"
    return text


# ---- options ----


def split_options(lines):
    """(spelling, text) of each option, its lines together. A spelling that ends with a comma goes on in the next line."""
    entries = []
    for line in lines:
        begins = OPTION.match(line)
        if begins and not (entries and entries[-1][0].endswith(",") and not entries[-1][1]):
            entries.append(["", ""])
        spelling, _, text = re.match(r"^ *(.*?)(?:( {2,})(\S.*))?$", line).groups(default="")
        if begins:
            entries[-1][0] += (" " if entries[-1][0] else "") + spelling
        else:
            text = line.strip()
        entries[-1][1] += (" " if entries[-1][1] and text else "") + text
    return entries


def mark_option(spelling):
    """-o, --output FILE with its names in bold and its values slanted."""
    marked = ""
    for i, part in enumerate(re.split(r"(-?-[a-z][a-z-]*)", spelling)):
        if i % 2 == 1:
            marked += scd.bold(part)
        else:
            value = part.replace("[", "\\[")
            marked += re.sub(r"[A-Z](?:[A-Zx,.:@]*[A-Z])?", lambda match: scd.slanted(match[0]), value)
    return marked


def option_section(lines):
    text = scd.heading("OPTIONS")
    for spelling, meaning in split_options(lines):
        text += scd.definition(mark_option(spelling), flow([meaning]))
    return text


# ---- pages ----


def exit_section(group):
    """"Exit status: 0 done; 2 bad input." as a list."""
    plain = " ".join(line.strip() for line in group).removeprefix("Exit status: ").rstrip(".")
    text = scd.heading("EXIT STATUS")
    for part in re.split(r"[;.] (?=\d)", plain):
        status, meaning = re.match(r"(\d+(?: \(\d+\))?) (.*)", part).groups()
        text += scd.definition(scd.bold(status), scd.text(meaning))
    return text


def see_also(names):
    return scd.heading("SEE ALSO") + ", ".join(names) + "\n"


def split_help(text):
    """The lines before the options, of the options, behind them, and from the exit status on."""
    lines = text.rstrip("\n").split("\n")
    first = next(i for i, line in enumerate(lines) if OPTION.match(line))
    last = first + lines[first:].index("")
    ends = next(i for i, line in enumerate(lines) if line.startswith("Exit status:"))
    return lines[:first], lines[first:last], lines[last:ends], lines[ends:]


def synopsis(name, example):
    """By the first example: two inputs have names of their own."""
    words = list(itertools.takewhile(lambda word: not word.startswith("-"), example.split()[2:]))
    inputs = [word.split(".")[0] for word in words] if len(words) > 1 else ["input"][: len(words)]
    return " ".join([scd.bold(f"quarter {name}"), *map(scd.slanted, inputs), f"\\[{scd.slanted('option')}...\\]"])


def command_page(name, summary, text, commands, version):
    before, listed, after, ends = split_help(text)
    shown, *prose = paragraphs(before)
    shown, notes = examples(shown), "".join(flow(group) + "\n\n" for group in paragraphs(after))
    others = [name_of(other) for other in commands if other != name]
    return (
        scd.preamble(f"quarter-{name}", 1, version)
        + scd.heading("NAME")
        + f"quarter-{name} - {scd.text(summary)}\n\n"
        + scd.heading("SYNOPSIS")
        + f"{synopsis(name, shown[0][0])}\n\n"
        + scd.heading("DESCRIPTION")
        + f"{scd.text(summary[0].upper() + summary[1:]).rstrip('.')}.\n\n"
        + "".join(flow(group) + "\n\n" for group in prose)
        + option_section(listed)
        + (scd.heading("NOTES") + notes if notes else "")
        + exit_section(ends)
        + example_section(shown)
        + see_also([f"{scd.bold('quarter')}(1)", f"{scd.bold('quarter-mission')}(5)", *others])
    )


def overview_page(text, commands, version):
    shown, *prose = paragraphs(text.rstrip("\n").split("\n"))
    listed = "".join(scd.definition(name_of(name), scd.text(what)) for name, what in commands.items())
    return (
        scd.preamble("quarter", 1, version)
        + scd.heading("NAME")
        + "quarter - divides a search area among robots\n\n"
        + scd.heading("SYNOPSIS")
        + f"{scd.bold('quarter')} {scd.slanted('command')} \\[{scd.slanted('input')}\\] \\[{scd.slanted('option')}...\\]\n\n"
        + scd.heading("DESCRIPTION")
        + "".join(flow(group) + "\n\n" for group in prose)
        + scd.heading("COMMANDS")
        + listed
        + example_section(examples(shown))
        + see_also([f"{scd.bold('quarter-mission')}(5)", f"{scd.bold('quarter-policy')}(5)"])
    )
