"""check_model.py [--spin SPIN] [--cc CC] [--quick]: the model of the termination protocol has the properties it should have, and
loses them where the protocol is got wrong.

Works in the current folder. Every search is exact and goes to its end: no bitstate hashing, no partial order reduction. Its
limits are the depth and the states that fit into the memory, never the time: what it finds is the same on every machine.
One line a run; ends with 0 only if every run gave what is expected of it, with 77 where there is no Spin.
"""

import argparse
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys

MODEL = pathlib.Path(__file__).resolve().parent / "termination.pml"
CORES = 2
MEMORY_MB = 512  # for one run: some millions of states, of which 400,000 are needed
DEPTH = 100000

HOLDS = "holds"
REFUTED = "refuted"  # a bad state is reached
CYCLE = "cycle"  # a run goes on for ever without the good thing
REST = "rest"  # the pseudo-property: nobody is left hanging in mid-protocol

FIND, CLEAR = [], ["CLEAR_ALL"]
ALL_LATE, ONE_LATE = ["LATE=N"], ["LATE=1"]
CUT, TWO = ["RESETS=1"], ["N=2"]

SAFE = [("sound", HOLDS), ("ends", HOLDS)]
FOUND_SAFE = [*SAFE, ("target_kept", HOLDS), ("all_clear", HOLDS)]
RESTS = (REST, HOLDS)
BARRED = [("sound", HOLDS), ("reach", HOLDS), ("patient", HOLDS), ("ends", REFUTED), ("walkers_stop", HOLDS)]
UNSOUND = [("sound", REFUTED), ("ends", REFUTED)]
FOUND_UNSOUND = [*UNSOUND, ("target_kept", REFUTED), ("all_clear", REFUTED)]

# What is built, by its definitions, and (property, expected) of each of its runs. A property with a `!` at its end is
# run without fairness. What is quick: the protocol, its faults with two robots, each mutation.
QUICK_RUNS = [
    ([*FIND], [RESTS, *FOUND_SAFE, ("walkers_stop", HOLDS)]),
    ([*CLEAR], [RESTS, *SAFE, ("walkers_stop", HOLDS)]),
    ([*TWO, *FIND, *ONE_LATE], [RESTS, *FOUND_SAFE, ("late_stop", HOLDS)]),
    ([*TWO, *CLEAR, *ONE_LATE], [RESTS, *SAFE, ("late_stop", HOLDS)]),
    ([*TWO, *FIND, "RESETS=3", "SHUT"], [*BARRED, ("target_kept", HOLDS)]),
    ([*TWO, *FIND, "SHUT", *CUT, "MIXED"], [*BARRED, ("target_kept", HOLDS)]),
    # runs that must exist, or the above would say nothing
    ([*FIND], [("never_stop", REFUTED), ("never_again", REFUTED), ("never_told", CYCLE)]),
    ([*CLEAR], [("never_stop", REFUTED), ("never_told", CYCLE)]),
    # mutations
    ([*FIND, *ALL_LATE, "ONCE"], [("told_stop", CYCLE)]),
    ([*FIND, *ALL_LATE, "NO_RELAY"], [("told_stop", CYCLE)]),
    ([*FIND, *ALL_LATE, "SILENT"], [("told_stop", CYCLE)]),
    ([*FIND, "EARLY"], FOUND_UNSOUND),
    ([*FIND, "STALE"], FOUND_UNSOUND),
    ([*FIND, "GO_ON"], [("target_kept", REFUTED), ("all_clear", REFUTED)]),
    ([*FIND, "WAIT"], [(REST, REFUTED), ("walkers_stop", CYCLE)]),
    ([*FIND, "MIXED", "BELIEVE"], FOUND_UNSOUND),
    ([*FIND, *CUT, "RECLEAR", "BELIEVE"], FOUND_UNSOUND),
    ([*FIND, *CUT, "AHEAD"], FOUND_UNSOUND),
    ([*FIND, *CUT, *ALL_LATE, "MUTE"], [("told_stop", CYCLE)]),
    ([*FIND, "SHUT", "WAVE"], FOUND_UNSOUND),
    ([*FIND, "SHUT", "INSIST"], [("walkers_stop", CYCLE)]),
]

# What takes a minute more: its faults with three robots, what is assumed, all of it in the other mode.
LONG_RUNS = [
    # the protocol
    ([*FIND, *ALL_LATE], [("told_stop", HOLDS)]),
    ([*CLEAR, *ALL_LATE], [("told_stop", HOLDS)]),
    ([*FIND, *ONE_LATE], [RESTS, *FOUND_SAFE, ("late_stop", HOLDS)]),
    ([*CLEAR, *ONE_LATE], [RESTS, *SAFE, ("late_stop", HOLDS)]),
    # a robot that cannot reach everything stops when all in its reach is done: a known limit, and sound all the same
    ([*FIND, "MISSED"], [RESTS, *BARRED, ("target_kept", HOLDS)]),
    ([*CLEAR, "MISSED"], BARRED),
    ([*FIND, "MISSED", *ALL_LATE], [("told_stop", HOLDS)]),
    # a door, shut or open whenever somebody comes
    ([*FIND, "SHUT"], [*BARRED, ("target_kept", HOLDS), ("never_retried", REFUTED)]),
    ([*CLEAR, "SHUT"], [*BARRED, ("never_retried", REFUTED)]),
    ([*FIND, "SHUT", *ALL_LATE], [("told_stop", HOLDS)]),
    # power cuts
    ([*FIND, *CUT], [*FOUND_SAFE, ("walkers_stop", HOLDS)]),
    ([*CLEAR, *CUT], [*SAFE, ("walkers_stop", HOLDS)]),
    ([*FIND, *CUT, *ALL_LATE], [("told_stop", HOLDS)]),
    ([*CLEAR, *CUT, *ONE_LATE], [("late_stop", HOLDS)]),
    ([*FIND, *CUT, "NO_DEATHS"], [("never_again", REFUTED)]),
    ([*FIND, "RESETS=3"], [*FOUND_SAFE]),
    # a robot of another division
    ([*FIND, "MIXED"], [*FOUND_SAFE, ("walkers_stop", HOLDS), ("never_stop", REFUTED)]),
    ([*CLEAR, "MIXED"], [*SAFE, ("walkers_stop", HOLDS), ("never_stop", REFUTED)]),
    # all of it at once
    ([*FIND, "SHUT", *CUT, "MIXED"], [("sound", HOLDS), ("reach", HOLDS), ("patient", HOLDS), ("target_kept", HOLDS)]),
    ([*CLEAR, "SHUT", *CUT], [("sound", HOLDS), ("reach", HOLDS)]),
    # runs that must exist
    ([*FIND, *ALL_LATE], [("never_told", CYCLE)]),
    ([*CLEAR, *ALL_LATE], [("never_told", CYCLE)]),
    ([*FIND, *ONE_LATE], [("never_late", CYCLE)]),
    ([*CLEAR, *ONE_LATE], [("never_late", CYCLE)]),
    # assumptions that are needed
    ([*FIND], [("walkers_stop!", CYCLE)]),
    ([*FIND, *ALL_LATE], [("walkers_stop", CYCLE), ("told_stop!", CYCLE), ("told_stop_all_lost", CYCLE)]),
    ([*CLEAR, *ALL_LATE], [("told_stop_all_lost", CYCLE)]),
    # mutations in the other mode, and what they leave whole
    ([*CLEAR, *ALL_LATE, "ONCE"], [("told_stop", CYCLE)]),
    ([*FIND, *ONE_LATE, "ONCE"], [("late_stop", CYCLE)]),
    ([*FIND, "ONCE"], [("walkers_stop", HOLDS)]),
    ([*CLEAR, *ALL_LATE, "NO_RELAY"], [("told_stop", CYCLE)]),
    ([*FIND, *ALL_LATE, "NO_RELAY", "NO_DEATHS"], [("told_stop", HOLDS)]),
    ([*CLEAR, *ALL_LATE, "SILENT"], [("told_stop", CYCLE)]),
    ([*CLEAR, "EARLY"], UNSOUND),
    ([*CLEAR, "STALE"], UNSOUND),
    ([*FIND, "GO_ON"], [("sound", HOLDS)]),
    ([*CLEAR, "WAIT"], [(REST, REFUTED), ("walkers_stop", CYCLE)]),
    ([*CLEAR, "MIXED", "BELIEVE"], UNSOUND),
    ([*FIND, *CUT, "RECLEAR"], FOUND_SAFE),
    ([*CLEAR, *CUT, "RECLEAR", "BELIEVE"], UNSOUND),
    ([*CLEAR, *CUT, "AHEAD"], UNSOUND),
    ([*FIND, "SHUT", "INSIST"], [("sound", HOLDS)]),
]


def call(command, folder):
    done = subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", errors="replace")
    return done.returncode, done.stdout + done.stderr


def verdict(output):
    """(what the search came to, states stored) from pan's output; None in place of what cannot be told for sure."""
    states = re.search(r"^\s*(\d+) states, stored", output, re.MULTILINE)
    errors = re.search(r"errors: (\d+)$", output, re.MULTILINE)
    if states is None or errors is None:
        return None, None
    if errors.group(1) == "0":
        cut = re.search(r"Search not completed|too small|out of memory|MEMLIM|truncated|Bit statespace", output)
        result = HOLDS if "Full statespace search" in output and not cut else None
    elif "acceptance cycle (at" in output:
        result = CYCLE
    elif "assertion violated" in output or "invalid end state" in output:
        result = REFUTED
    else:
        result = None
    return result, int(states.group(1))


def build(tools, folder, defines, claims, long):
    """Build pan in `folder`. With claims it checks properties, without them that every run comes to rest. Optimising takes
    longer than a search gains by it, unless it is a long one."""
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(MODEL, folder)  # Spin hands the name to a shell, as it is
    ends = [] if claims else ["-DENDS"]
    status, output = call([tools.spin, *(f"-D{d}" for d in defines), *ends, "-a", MODEL.name], folder)
    if status == 0:
        flags = ["-O1" if long else "-O0", "-w", "-DNOREDUCE", "-DNFAIR=3", f"-DMEMLIM={MEMORY_MB}"] + ([] if claims else ["-DNOCLAIM"])
        status, output = call([tools.cc, *flags, "-o", "pan", "pan.c"], folder)
    if status != 0:
        raise SystemExit(f"{' '.join(defines)}: not built:\n{output}")


def search(folder, name):
    """Run pan for one property."""
    limits = [f"-m{DEPTH}", "-w20", "-n"]
    if name == REST:
        return verdict(call(["./pan", *limits], folder)[1])
    fairness = [] if name.endswith("!") else ["-f"]
    asked = name.rstrip("!")
    output = call(["./pan", "-a", *fairness, "-N", asked, *limits], folder)[1]
    # pan takes the first claim if it does not know the name
    return verdict(output) if f"pan: ltl formula {asked}\n" in output else (None, None)


def title(defines):
    mode = "clear-all" if "CLEAR_ALL" in defines else "find-first"
    robots = next((d for d in defines if d.startswith("N=")), "N=3")
    return " ".join([robots, mode, *(d for d in defines if d != "CLEAR_ALL" and not d.startswith("N="))])


def line_of(defines, name, states, found, expected):
    fair = " unfair" if name.endswith("!") else ""
    return (f"{title(defines):41} {name.rstrip('!') + fair:19} {'?' if states is None else states:>7} states  "
            f"{found or 'not searched to the end':8}" + ("as expected" if found == expected else f"NOT {expected}"))


def run(tools, number, defines, properties):
    """The lines to print for the runs of one model, and how many are not as expected."""
    lines, wrong = [], 0
    goes_to_the_end = any(expected == HOLDS for name, expected in properties if name != REST)
    for name, expected in properties:
        claims = name != REST
        folder = pathlib.Path(f"{number}_{'claims' if claims else 'rest'}")
        if not (folder / "pan").exists():
            build(tools, folder, defines, claims, long=claims and goes_to_the_end)
        found, states = search(folder, name)
        wrong += found != expected
        lines.append(line_of(defines, name, states, found, expected))
    return lines, wrong


def models(runs):
    """(definitions, the properties that are asked of them) of each model that must be built."""
    properties = {}
    for defines, asked in runs:
        properties.setdefault(tuple(defines), []).extend(asked)
    return properties.items()


def prove_that_it_fails():
    full = "Full statespace search for:\nState-vector 100 byte, depth reached 9, errors: {}\n 7 states, stored\n"
    for output, expected in [
        (full.format(0), HOLDS),
        ("error: max search depth too small\n" + full.format(0), None),
        ("Warning: Search not completed\n" + full.format(0), None),
        (full.format(0).replace("Full", "Bit"), None),
        ("pan:1: acceptance cycle (at depth 3)\n" + full.format(1), CYCLE),
        ("pan:1: assertion violated x (at depth 3)\n" + full.format(1), REFUTED),
        ("pan:1: invalid end state (at depth 3)\n" + full.format(1), REFUTED),
        ("pan:1: VECTORSZ is too small\n" + full.format(1), None),
        ("", None),
    ]:
        if verdict(output)[0] != expected:
            raise SystemExit(f"self-test: {verdict(output)[0]}, not {expected}, of:\n{output}")


def main():
    prove_that_it_fails()
    parser = argparse.ArgumentParser()
    parser.add_argument("--spin", default="spin")
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--quick", action="store_true", help="what takes some seconds")
    tools = parser.parse_args()
    if shutil.which(tools.spin) is None:
        print(f"SKIPPED: the model of the termination protocol: there is no {tools.spin}")
        sys.exit(77)
    for old in pathlib.Path().glob("[0-9]*_*/pan"):
        old.unlink()
    runs = QUICK_RUNS if tools.quick else QUICK_RUNS + LONG_RUNS
    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(CORES) as pool:
        for lines, faults in pool.map(lambda entry: run(tools, entry[0], *entry[1]), enumerate(models(runs))):
            print(*lines, sep="\n", flush=True)
            wrong += faults
    total = sum(len(properties) for _, properties in runs)
    print(f"{wrong} of {total} runs not as expected" if wrong else f"{total} runs as expected")
    raise SystemExit(1 if wrong else 0)


main()
