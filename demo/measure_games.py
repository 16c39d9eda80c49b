"""Seeded games by the thousand, as the tables of docs/demo.md: `./run games [--games N]`, 45 minutes of a processor for 1,000.

What it is at goes to standard error, a line for each kind of games that is done. With `--keep FOLDER` the figures of each kind are
put there as they come, and those that are there are taken: a run that was ended is gone on with. They are of the program, the
missions and the number of games that made them: for others take another folder.
"""

import argparse
import json
import math
import os
import statistics
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MISSIONS = ["minefield", "site", "warehouse", "turtlebot3_world", "demining", "flat"]
WITH_TERMS = ["demining", "flat"]
KINDS = {"plan": [], "lost": ["--lose-one"], "nearest": ["--strategy", "nearest"], "informed": ["--strategy", "informed"],
         "plain": ["--strategy", "plain"]}


def play(tool, mission, kind, games):
    """The program's own figures, as JSON."""
    words = [tool, f"demo/missions/{mission}/mission.yaml", "--runs", str(games), "--json", "--learn-limit", "60",
             *KINDS[kind]]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    return done.stdout


def play_or_take(asked, mission, kind):
    kept = asked.keep / f"{mission}-{kind}-{asked.games}.json" if asked.keep else None
    if kept and kept.exists():
        return json.loads(kept.read_text(encoding="utf-8"))
    told = play(asked.tool, mission, kind, asked.games)
    if kept:  # whole or not at all
        half = kept.with_suffix(".part")
        half.write_text(told, encoding="utf-8")
        half.replace(kept)
    print(f"{mission}, {kind}: {asked.games} games played", file=sys.stderr, flush=True)
    return json.loads(told)


def play_all(asked):
    """As many at a time as there are processors."""
    pairs = [(mission, kind) for mission in MISSIONS for kind in KINDS if kind != "plain" or mission in WITH_TERMS]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(lambda pair: play_or_take(asked, *pair), pairs)
        return dict(zip(pairs, results))


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def share(part, whole):
    return f"{100 * part / whole:.0f} %" if part < whole else "100 %"


def plan_rows(found):
    for mission in MISSIONS:
        f, lost = found[mission, "plan"], found[mission, "lost"]
        yield [f["mission"], f["robots"], share(f["found"], f["games"]), f"{f['planned_mean']:.2f} s", f"{f['mean']:.2f} s",
               f"{100 * (f['mean'] / f['planned_mean'] - 1):+.1f} %", f"{f['median']:.1f} / {f['quantile_90']:.1f} / {f['longest']:.1f} s",
               f["games_with_deadlock"], f"{f['duplicates_a_game']:.3f}", f"{f['collisions_a_game']:.2f}",
               share(lost["found"], lost["games"]), lost["games_with_deadlock"], f"{lost['mean']:.1f} s"]


def worth_rows(found):
    for mission in MISSIONS:
        f, nearest, informed = (found[mission, kind] for kind in ("plan", "nearest", "informed"))
        yield [f["mission"], f"{f['mean']:.1f} s", f"{nearest['mean']:.1f} s", f"{100 * (1 - f['mean'] / nearest['mean']):.0f} %",
               f"{nearest['duplicates_a_game']:.1f}", f"{informed['mean']:.1f} s", f"{100 * (1 - f['mean'] / informed['mean']):.0f} %"]


def times(f):
    """Of each game in the order of the seeds; what is not found counts as the last battery's end."""
    return [f["not_found_counts_as"] if seconds is None else seconds for seconds in f["found_at"]]


def paired(less, more):
    """Mean of the differences, game by game, and half of its 95 % confidence interval."""
    differences = [b - a for a, b in zip(less, more)]
    return statistics.mean(differences), 1.96 * statistics.stdev(differences) / math.sqrt(len(differences))


def term_rows(found):
    for mission in WITH_TERMS:
        f, plain = found[mission, "plan"], found[mission, "plain"]
        mean, half = paired(times(f), times(plain))
        yield [f["mission"], f"{f['mean']:.1f} s", f"{plain['mean']:.1f} s", f"{mean:.1f} s ± {half:.1f}",
               f"{100 * mean / plain['mean']:.0f} %", share(f["found"], f["games"]), share(plain["found"], plain["games"]),
               f"{f['not_found_counts_as']:.0f} s"]


def message_rows(found):
    for mission in MISSIONS:
        f = found[mission, "plan"]
        m, games = f["messages"], f["games"]
        yield [f["mission"], *(f"{m[kind] / games:,.0f}" for kind in ("pose", "scan", "command", "terminate"))]


def main():
    parser = argparse.ArgumentParser(prog="./run games", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tool", help=argparse.SUPPRESS)
    parser.add_argument("--games", type=int, default=1000, help="of each kind (default 1000)")
    parser.add_argument("--keep", metavar="FOLDER", type=Path, help="put each kind's figures there, and take those that are there")
    asked = parser.parse_args()
    asked.tool = str(Path(asked.tool).resolve())
    if asked.keep:
        asked.keep.mkdir(parents=True, exist_ok=True)
    found = play_all(asked)
    print(f"{asked.games} games of each kind, seeds from 1 on.\n")
    print(table(["mission", "robots", "found", "planned mean, same mines", "achieved mean", "difference",
                 "median / 90 % / longest", "games with a deadlock", "scanned twice, a game", "collisions, a game",
                 "one robot lost: found", "deadlocks", "mean"], plan_rows(found)))
    print("\nWhat dividing the territory is worth: mean time to find.\n")
    print(table(["mission", "the plan", "nearest first, no plan", "less by", "its scans of what is scanned, a game",
                 "nearest first, full communication", "less by"], worth_rows(found)))
    print("\nWhat it is worth to plan with the field's terms: mean time to find.\n")
    print(table(["mission", "the plan", "a plan as if sensors were perfect and robots alike", "less by (paired, 95 %)", "less by",
                 "found", "found without", "not found counts as"], term_rows(found)))
    print("\nMessages a game; only terminate goes from robot to robot.\n")
    print(table(["mission", "pose", "scan", "command", "terminate"], message_rows(found)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
