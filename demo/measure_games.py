"""Seeded games by the thousand, as the tables of docs/demo.md: `./run games [--games N]`, a few minutes for 1,000."""

import argparse
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MISSIONS = ["minefield", "site", "warehouse", "turtlebot3_world"]
KINDS = {"plan": [], "lost": ["--lose-one"], "nearest": ["--strategy", "nearest"], "informed": ["--strategy", "informed"]}


def play(tool, mission, kind, games):
    words = [tool, f"demo/missions/{mission}/mission.yaml", "--runs", str(games), "--json", *KINDS[kind]]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    return json.loads(done.stdout)


def play_all(tool, games):
    """As many at a time as there are processors."""
    pairs = [(mission, kind) for mission in MISSIONS for kind in KINDS]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(lambda pair: play(tool, *pair, games), pairs)
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


def message_rows(found):
    for mission in MISSIONS:
        f = found[mission, "plan"]
        m, games = f["messages"], f["games"]
        yield [f["mission"], *(f"{m[kind] / games:,.0f}" for kind in ("pose", "scan", "command", "terminate"))]


def main():
    parser = argparse.ArgumentParser(prog="./run games", description=__doc__)
    parser.add_argument("tool", help=argparse.SUPPRESS)
    parser.add_argument("--games", type=int, default=1000, help="of each kind (default 1000)")
    asked = parser.parse_args()
    found = play_all(str(Path(asked.tool).resolve()), asked.games)
    print(f"{asked.games} games of each kind, seeds from 1 on.\n")
    print(table(["mission", "robots", "found", "planned mean, same mines", "achieved mean", "difference",
                 "median / 90 % / longest", "games with a deadlock", "scanned twice, a game", "collisions, a game",
                 "one robot lost: found", "deadlocks", "mean"], plan_rows(found)))
    print("\nWhat dividing the territory is worth: mean time to find.\n")
    print(table(["mission", "the plan", "nearest first, no plan", "less by", "its scans of what is scanned, a game",
                 "nearest first, full communication", "less by"], worth_rows(found)))
    print("\nMessages a game; only terminate goes from robot to robot.\n")
    print(table(["mission", "pose", "scan", "command", "terminate"], message_rows(found)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
