"""Text as scdoc takes it."""

import re

SPECIAL = re.compile(r"([\\*_`~+#\[\]|<>])")
FIRST = re.compile(r"^([-.;:'!])")


def text(plain):
    """Nothing in it is markup."""
    return FIRST.sub(r"\\\1", SPECIAL.sub(r"\\\1", plain))


def bold(plain):
    return f"*{SPECIAL.sub(lambda match: chr(92) + match[0], plain)}*"


def slanted(plain):
    return f"_{SPECIAL.sub(lambda match: chr(92) + match[0], plain)}_"


def definition(term, meaning):
    """A term, marked up already, and what it means."""
    return f"{term}\n\t{meaning}\n\n"


def heading(name, level=1):
    return f"{'#' * level} {name}\n\n"


def preamble(name, section, version):
    return f'{name}({section}) "{version}" "Quarter"\n\n'
