"""bundle.py SOURCE FOLDER: the robot side as two files, quarter_robot.h and quarter_robot.c, to be copied into a firmware; with a
library.properties beside them, by which the folder is a library for Arduino.

The header holds the public headers of the robot side, the source all of its C files, each include in the place where it is
first asked for. A name that two files keep for themselves (static functions, macros and constants of no header) would collide
in one file: it gets its file's name in front.
"""

import pathlib
import re
import sys

INCLUDE = re.compile(r'^#include "([\w./]+)"\n', re.MULTILINE)
SYSTEM = re.compile(r"^#include (<[\w./]+>)\n", re.MULTILINE)
TOKEN = re.compile(r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)


def read(path):
    return path.read_text(encoding="utf-8")


def version_of(source):
    return re.search(r'QTR_VERSION_STRING "([\d.]+)"', read(source / "include/quarter/status.h")).group(1)


def private_names(text):
    """What a C file keeps for itself: static functions and data, types, enumerators, macros."""
    code = TOKEN.sub(" ", text)
    names = set(re.findall(r"^static [^;={(]*?\b(\w+)\s*(?:\(|\[|=|;)", code, re.MULTILINE))
    names |= set(re.findall(r"^#define (\w+)", code, re.MULTILINE))
    for body in re.findall(r"^(?:typedef )?enum \w* ?\{([^}]*)\}", code, re.MULTILINE):
        names |= set(re.findall(r"(?:^|,)\s*(\w+)", body))
    names |= set(re.findall(r"^static (?:const )?struct \{[^}]*\} (\w+)", code, re.MULTILINE))
    return names


def renamed(text, names, prefix):
    """`text` with the names under a prefix; members that go by the same name are left alone, and so are comments and strings."""
    if not names:
        return text
    word = re.compile(r"(?<![\w.])(?<!->)(" + "|".join(sorted(names, key=len, reverse=True)) + r")\b")
    parts, at = [], 0
    for token in TOKEN.finditer(text):
        parts += [word.sub(prefix + r"\1", text[at : token.start()]), token.group(0)]
        at = token.end()
    return "".join(parts) + word.sub(prefix + r"\1", text[at:])


def without_collisions(files):
    """The C files' texts, {name: text}, with the names that more than one keeps for itself told apart."""
    owners = {}
    for name, text in files.items():
        for word in private_names(text):
            owners.setdefault(word, set()).add(name)
    shared = {word for word, names in owners.items() if len(names) > 1}
    return {name: renamed(text, shared & private_names(text), pathlib.Path(name).stem + "_") for name, text in files.items()}


class Bundle:
    """Headers put in their places, each once."""

    def __init__(self, source, seen=()):
        self.folders = [source / "include", source / "lib"]
        self.seen = set(seen)
        self.system = []

    def find(self, name):
        for folder in self.folders:
            if (folder / name).is_file():
                return folder / name
        raise SystemExit(f"bundle: there is no {name}")

    def put(self, text):
        for header in SYSTEM.findall(text):
            if header not in self.system:
                self.system.append(header)
        return INCLUDE.sub(lambda include: self.header(include.group(1)), SYSTEM.sub("", text))

    def header(self, name):
        if name in self.seen:
            return ""
        self.seen.add(name)
        return self.put(read(self.find(name)))


def tidied(text):
    return re.sub(r"\n{3,}", "\n\n", text).strip("\n") + "\n"


def title(source, what):
    licence = read(source / "LICENSE").strip().replace("\n", "\n * ").replace(" * \n", " *\n")
    return f"/* Quarter {version_of(source)}, {what}, made by its build from many files: change those.\n *\n * {licence}\n */\n"


def arduino_properties(source):
    """A library of the flat layout. No project's page is named: Arduino wants the key, and takes it empty."""
    sentence = "Divides a search area among robots."
    paragraph = "The robot side of Quarter: executes a policy table that the host command has learnt, by termination signals alone."
    return (
        f"name=Quarter\nversion={version_of(source)}\nauthor=Quarter contributors\nmaintainer=Quarter contributors\n"
        f"sentence={sentence}\nparagraph={paragraph}\ncategory=Other\nurl=\narchitectures=*\n"
        "includes=quarter_robot.h\nlicense=MIT\n"
    )


def system_lines(headers):
    return "".join(f"#include {header}\n" for header in headers)


def write_bundle(source, folder):
    public = Bundle(source)
    header = public.header("quarter/robot.h")
    private = Bundle(source, public.seen)
    files = {str(path.relative_to(source)): read(path) for side in ("core", "robot") for path in sorted((source / "lib" / side).glob("*.c"))}
    # The private headers first: what is put in the middle of a file could meet a macro of an earlier one.
    body = "".join(private.put(text) + "\n" for text in without_collisions(files).values())
    system = [header for header in private.system if header not in public.system]
    folder.mkdir(parents=True, exist_ok=True)
    guard = "#ifndef QUARTER_ROBOT_BUNDLE_H\n#define QUARTER_ROBOT_BUNDLE_H\n\n"
    text = title(source, "the robot side") + guard + system_lines(public.system) + "\n" + header + "\n#endif\n"
    (folder / "quarter_robot.h").write_text(tidied(text), encoding="utf-8")
    text = title(source, "the robot side") + '#include "quarter_robot.h"\n\n' + system_lines(system) + "\n" + body
    (folder / "quarter_robot.c").write_text(tidied(text), encoding="utf-8")
    (folder / "library.properties").write_text(arduino_properties(source), encoding="utf-8")


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__.split(":")[0])
    try:
        write_bundle(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
    except OSError as error:
        print(f"bundle: {error.filename}: cannot be written ({error.strerror}); name a folder that can be", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
