"""Quarter beside other solvers, on the same problems in one run: prints the tables, or writes docs/benchmarks.md."""

import argparse
import json
import platform
import statistics
import subprocess
import sys
import tempfile
from importlib import metadata
from pathlib import Path

import report
import summary
from contest import NAMES, Contest, Left, processor_seconds
from suite import GROUPS, OBJECTIVES, SERIES

ROOT = Path(__file__).resolve().parent.parent.parent
EXAMPLES = """examples:
  ./run bench --field --quick               some small and middle problems: 3 minutes
  ./run bench --field --write               all of them: writes docs/benchmarks.md and docs/benchmarks/data.json
  ./run bench --field --sizes middle --seeds 5 --seconds 10 --solvers Quarter,routing
"""


def parse(words):
    parser = argparse.ArgumentParser(prog="./run bench --field", description=__doc__, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench", help=argparse.SUPPRESS)
    parser.add_argument("packages", help=argparse.SUPPRESS)
    parser.add_argument("--sizes", default=",".join(GROUPS), metavar="NAMES", help="of problems: " + ", ".join(GROUPS))
    parser.add_argument("--solvers", default=",".join(NAMES), metavar="NAMES", help=", ".join(NAMES))
    parser.add_argument("--seeds", type=int, default=3, help="problems of each kind (default 3)")
    parser.add_argument("--seconds", type=float, default=3.0, help="of the processor for each solver (default 3)")
    parser.add_argument("--quick", action="store_true", help="one problem of every second kind, none large, 1 s each")
    parser.add_argument("--json", metavar="FILE", help="write the data there, too")
    parser.add_argument("--keep", metavar="FILE", help="take the results of solvers that are not named from an earlier run's data")
    parser.add_argument("--write", action="store_true", help="write docs/benchmarks.md and its data")
    asked = parser.parse_args(words)
    for word, known in (("sizes", GROUPS), ("solvers", NAMES)):
        names = getattr(asked, word).split(",")
        unknown = [name for name in names if name not in known]
        if unknown:
            parser.error(f"--{word}: there is no '{unknown[0]}'; there are {', '.join(known)}")
        setattr(asked, word, names)
    if asked.seeds < 1 or asked.seconds <= 0:
        parser.error("--seeds and --seconds are above 0")
    if asked.quick:
        asked.sizes, asked.seeds, asked.seconds = [size for size in asked.sizes if size != "large"], 1, 1.0
    return asked


def tell(text):
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def run_cell(contest, cell, objective, asked, left):
    """The problems of a cell; what the build does not hold goes to `left`."""
    for seed in range(1, asked.seeds + 1):
        tell(f"{cell.name()}, {objective}, seed {seed} ...")
        try:
            _, results = contest.run(cell.options(objective, seed), asked.solvers)
        except Left:
            left.append(f"{cell.name()}: more than this build holds")
            return
        yield {"cell": cell.name(), "objective": objective, "seed": seed, "results": results}


def run_all(contest, asked):
    instances, left = [], []
    cells = [cell for size in asked.sizes for cell in GROUPS[size][:: 2 if asked.quick else 1]]
    for cell in cells:
        for objective in OBJECTIVES:
            instances += run_cell(contest, cell, objective, asked, left)
    return instances, list(dict.fromkeys(left))


def cost(contest, cell, seeds):
    """Seconds until the certificate, or all that there are."""
    taken, certified = [], 0
    for seed in range(1, seeds + 1):
        tell(f"cost of {cell.name()}, seed {seed} ...")
        _, results = contest.run(cell.options("time", seed), ["Quarter"])
        proved = results["Quarter"]["proved_after"]
        certified += proved is not None
        taken.append(contest.seconds if proved is None else proved)
    return {"seconds": statistics.median(taken), "certified": certified, "of": seeds}


def measure_of(cell, name):
    return {"places": cell.places, "robots": cell.robots, "cells": f"{cell.side}x{cell.side}",
            "steps a cell": cell.more[1] if cell.more else 1}[name]


def run_costs(contest, seeds):
    return {name: [{"at": measure_of(cell, name), **cost(contest, cell, seeds)} for cell in cells]
            for name, cells in SERIES.items()}


def machine():
    """The processor by its name, where the system tells it."""
    cpu = Path("/proc/cpuinfo")
    lines = cpu.read_text(encoding="utf-8", errors="replace").splitlines() if cpu.exists() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return f"one core of {names[0] if names else platform.machine()} ({platform.system()})"


def version_of(package, packages):
    found = [each.version for each in metadata.distributions(path=[packages]) if each.name == package]
    return found[0] if found else "(none)"


def commit():
    done = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"], capture_output=True, encoding="utf-8")
    return done.stdout.strip() or "(none)"


def collect(asked, scratch):
    contest = Contest(asked.bench, asked.packages, scratch, asked.seconds)
    instances, left = run_all(contest, asked)
    cost_seeds = 1 if asked.quick else 5
    costs = run_costs(contest, cost_seeds) if "Quarter" in asked.solvers and not asked.quick else {}
    tell("")
    return {"machine": machine(), "commit": commit(), "ortools": version_of("ortools", asked.packages),
            "didppy": version_of("didppy", asked.packages), "seconds": asked.seconds, "seeds": asked.seeds,
            "solvers": asked.solvers, "processor_seconds": processor_seconds(), "cost_seeds": cost_seeds,
            "cost_seconds": asked.seconds, "instances": instances, "costs": costs, "left": left}


def main(words):
    asked = parse(words)
    with tempfile.TemporaryDirectory() as scratch:
        data = collect(asked, scratch)
    if asked.keep:
        summary.keep(data, json.loads(Path(asked.keep).read_text(encoding="utf-8")))
    text = report.write(data)
    if asked.json:
        Path(asked.json).write_text(report.as_text(data), encoding="utf-8")
    if asked.write:
        report.write_documents(ROOT / "docs", data, text)
    else:
        print(text)
    return 1 if any(summary.contradictions(instance) for instance in data["instances"]) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
