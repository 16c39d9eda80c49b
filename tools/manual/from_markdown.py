"""Pages of the manual out of Markdown: headings, paragraphs, lists, tables, blocks of code, `code`, **strong** and [links]."""

import re

import scd

INLINE = re.compile(r"`([^`]+)`|\*\*([^*]+)\*\*|\[([^\]]*)\]\([^)]*\)")


def inline(markdown):
    """A line's markup as scdoc's."""
    text, end = "", 0
    for match in INLINE.finditer(markdown):
        text += scd.SPECIAL.sub(r"\\\1", markdown[end : match.start()])
        code, strong, link = match.groups()
        text += inline(link) if link is not None else scd.bold(code or strong.replace("`", ""))
        end = match.end()
    return scd.FIRST.sub(r"\\\1", text + scd.SPECIAL.sub(r"\\\1", markdown[end:]))


# ---- tables ----


def cells(line):
    return [cell.strip() for cell in line.strip()[1:-1].split(" | ")]


def key_row(row):
    """key, what, values, unit, default, example"""
    key, what, values, unit, standard, example = row
    told = f"{inline(what)}. {inline(values[:1].upper() + values[1:])}" + (f", in {scd.text(unit)}" if unit else "") + ". "
    told += "Needed. " if standard == "needed" else f"Default: {inline(standard)}. " if standard else ""
    return scd.definition(inline(key), f"{told}Example: {inline(example)}")


def plain_row(row):
    return scd.definition(", ".join(inline(cell) for cell in row[:-1] if cell), inline(row[-1]))


def table(lines):
    row_of = key_row if cells(lines[0])[:2] == ["key", "what"] else plain_row
    return "".join(row_of(cells(line)) for line in lines[2:])


# ---- the whole ----


def blocks(markdown):
    """Groups of lines between empty ones; a heading is a group of its own."""
    group = []
    for line in [*markdown.split("\n"), ""]:
        if line.strip() and not line.startswith("#"):
            group.append(line)
            continue
        if group:
            yield group
        group = []
        if line.strip():
            yield [line]


def items(group):
    """A list's items, each a line."""
    return [line[2:] for line in re.sub(r"\n {2,}", " ", "\n".join(group)).split("\n")]


def block(group):
    first = group[0]
    if first.startswith("#"):
        level, _, title = first.partition(" ")
        return scd.heading(title.upper() if level == "##" else title, len(level) - 1)
    if first.startswith("|"):
        return table(group)
    if first.startswith("    "):
        return "```\n" + "\n".join(line[4:] for line in group) + "\n```\n\n"
    if first.startswith("- "):
        return "".join(f"- {inline(item)}\n" for item in items(group)) + "\n"
    return inline(" ".join(line.strip() for line in group)) + "\n\n"


def page(name, summary, markdown, version):
    """The title is the page's name; what comes before the first heading below it is the description."""
    groups = list(blocks(markdown))[1:]
    return (
        scd.preamble(name, 5, version)
        + scd.heading("NAME")
        + f"{name} - {scd.text(summary)}\n\n"
        + scd.heading("DESCRIPTION")
        + "".join(map(block, groups))
        + scd.heading("SEE ALSO")
        + f"{scd.bold('quarter')}(1)\n"
    )
