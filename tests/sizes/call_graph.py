"""The worst stack of a program: what the compiler says each function takes (-fstack-usage), along the calls that its disassembly
shows. What the compiler said nothing of, in libraries, is read from the instructions.
"""

import re
import subprocess

FUNCTION = re.compile(r"^[0-9a-f]+ <([^>+]+)>:$")
CALLED = re.compile(r"<([^>+]+)>$")
PUSHED = re.compile(r"\t(?:push|push\.w|stmdb\tsp!,|stmfd\tsp!,)\s*\{([^}]*)\}")
LOWERED = re.compile(r"\t(?:sub(?:\.w|w)?\tsp, (?:sp, )?#(\d+)|str(?:\.w)?\t\w+, \[sp, #-(\d+)\]!|(?:c\.)?addi?(?:16sp)?\tsp,(?:sp,)?-(\d+))")
INDIRECT = re.compile(r"\t(?:blx\tr\d+|jalr\t(?!zero|ra,0x|-?\d+\(ra\))|c\.jalr)")
COPY = re.compile(r"\.\d+$")  # of a function that was made for some of its callers: the compiler's word is of the name without


class Recursion(Exception):
    pass


def registers(words):
    """How many a list as `r4, r5-r7, lr` names."""
    count = 0
    for word in words.split(","):
        first, _, last = word.strip().partition("-")
        count += int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count


def frame_of(line):
    pushed, lowered = PUSHED.search(line), LOWERED.search(line)
    if pushed:
        return 4 * registers(pushed.group(1))
    return int(next(group for group in lowered.groups() if group)) if lowered else 0


def read_disassembly(text):
    """{function: (bytes that its instructions take, names that it calls or goes on to, whether through a pointer)}."""
    functions, name = {}, None
    for line in text.splitlines():
        begun = FUNCTION.match(line)
        if begun:
            name = begun.group(1)
            functions.setdefault(name, [0, set(), False])
        elif name and "\t" in line:
            functions[name][0] += frame_of(line)
            called = CALLED.search(line)
            if called and ".word" not in line:
                functions[name][1].add(called.group(1))
            functions[name][2] |= bool(INDIRECT.search(line))
    return functions


def read_usage(folder):
    """{function: bytes} of all the compiler's .su files below a folder; of two functions of a name the larger."""
    usage = {}
    for path in folder.rglob("*.su"):
        for line in path.read_text(encoding="utf-8").splitlines():
            where, size, kind = line.split("\t")
            if "dynamic" in kind and "bounded" not in kind:
                raise SystemExit(f"{where}: its stack has no bound")
            name = where.split(":")[-1]
            usage[name] = max(int(size), usage.get(name, 0))
    return usage


def deepest(functions, usage, root, above=()):
    """(bytes, names) of the deepest way from a function down."""
    own, called, _ = functions[root]
    if root in above:
        raise Recursion(" ".join([*above, root]))
    below = [deepest(functions, usage, name, (*above, root)) for name in sorted(called - {root}) if name in functions]
    size, names = max(below, default=(0, []), key=lambda way: way[0])
    return usage.get(COPY.sub("", root), own) + size, [root, *names]


def worst_stack(objdump, image, usage_folder, root):
    command = [objdump, "-d", "--no-show-raw-insn", str(image)]
    text = subprocess.run(command, check=True, capture_output=True, encoding="utf-8").stdout
    functions = read_disassembly(text)
    pointers = sorted(name for name, (_, _, indirect) in functions.items() if indirect)
    if pointers:
        raise SystemExit(f"{image}: calls through pointers, which nobody can follow: {pointers}")
    return deepest(functions, read_usage(usage_folder), root)
