"""Games of five processes over a network that loses packets: `./run losses [--games N]`. Each runs in a network namespace of
its own, in real time; prints how long after the finding the last robot stood."""

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MISSION = "demo/missions/minefield/mission.yaml"
MINE = "19"  # planned within a quarter of a minute
LOSSES = [0, 30, 60]
NETWORK = """ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 9
if [ "$1" != 0 ]; then
  nft add table ip t && nft add chain ip t in '{ type filter hook input priority 0; }' &&
  nft add rule ip t in udp dport 7667 numgen random mod 100 '<' "$1" drop || exit 9
fi
shift; exec "$@"
"""


def play(tool, loss, seed):
    words = [tool, MISSION, "--processes", "--mine", MINE, "--seed", str(seed), "--json"]
    environment = {**os.environ, "PATH": os.environ["PATH"] + ":/usr/sbin:/sbin"}
    done = subprocess.run(["unshare", "-rn", "sh", "-c", NETWORK, "sh", str(loss), *words], cwd=ROOT, env=environment,
                          capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        raise SystemExit(f"a game with {loss} % lost ended with status {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout)["result"]


def need_programs():
    for program in ("unshare", "ip", "nft"):
        if shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin:/sbin") is None:
            raise SystemExit(f"./run losses: there is no {program}; install util-linux, iproute2 and nftables")


def main():
    parser = argparse.ArgumentParser(prog="./run losses", description=__doc__)
    parser.add_argument("tool", help=argparse.SUPPRESS)
    parser.add_argument("--games", type=int, default=10, help="at each loss (default 10)")
    asked = parser.parse_args()
    need_programs()
    tool = str(Path(asked.tool).resolve())
    pairs = [(loss, seed) for loss in LOSSES for seed in range(1, asked.games + 1)]
    with ThreadPoolExecutor(2 * (os.cpu_count() or 1)) as pool:
        results = list(pool.map(lambda pair: play(tool, *pair), pairs))
    print("| packets lost | games | found | until all stood: median | most |\n| --- | --- | --- | --- | --- |")
    for loss in LOSSES:
        games = [r for (l, _), r in zip(pairs, results) if l == loss]
        delays = [r["all_stopped_at"] - r["found_at"] for r in games if r["found_at"] is not None]
        print(f"| {loss} % | {len(games)} | {len(delays)} | {statistics.median(delays):.2f} s | {max(delays):.2f} s |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
