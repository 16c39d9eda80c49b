"""Runs the host tool and reads what it says: the report knows Quarter only from outside, as any user does."""

import csv
import json
import os
import statistics
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SEEDS = range(1, 21)


class Lab:
    """`root` is the checkout, `scratch` a folder for files in between."""

    def __init__(self, tool, root, scratch):
        self.tool = Path(tool).resolve()
        self.root = Path(root)
        self.scratch = Path(scratch)
        self.files = 0

    def map(self, name):
        return f"demo/missions/paper/{name}.txt"

    def file(self, suffix):
        self.files += 1
        return str(self.scratch / f"{self.files}{suffix}")

    def run(self, *words):
        done = subprocess.run([str(self.tool), *map(str, words)], cwd=self.root, capture_output=True, encoding="utf-8")
        if done.returncode != 0:
            raise SystemExit(f"quarter {' '.join(map(str, words))}\n{done.stderr}")
        return done.stdout

    def ask(self, *words):
        return json.loads(self.run(*words, "--json"))

    def learn(self, name, *options):
        """Two seekers on a map of the paper."""
        return self.ask("learn", self.map(name), "--robots", 2, *options)

    def explore(self, name, episodes, seed, *options):
        """The paper setting for that many episodes: the tool's report, and the rows of its curve."""
        path = self.file(".csv")
        told = self.learn(name, "--learner", "paper", "--gap", 0, "--episodes", episodes, "--seed", seed, "--curve",
                          path, *options)
        with open(path, newline="", encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        os.remove(path)
        return told, rows

    def picture_of_policy(self, name, *options):
        # A table's picture has the name of its file as the title.
        table, picture = str(self.scratch / f"{name}.qtr"), self.file(".svg")
        self.run("learn", self.map(name), "--robots", 2, "-q", "-o", table, *options)
        self.run("draw", table, "-o", picture)
        return Path(picture).read_text(encoding="utf-8")

    def picture_of_map(self, name, *options):
        picture = self.file(".svg")
        told = self.ask("draw", self.map(name), "-o", picture, *options)
        return Path(picture).read_text(encoding="utf-8"), told


def side_by_side(work, items):
    """work(item) for every item, as many at a time as there are processors; the results in the items' order."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(work, items))


def spread(values):
    """Median and range."""
    return {"median": statistics.median(values), "least": min(values), "most": max(values)}


def moments(last):
    """Episodes at which curves are compared: ten a decade, the last one included."""
    return sorted({min(last, round(10 ** (n / 10))) for n in range(0, 100) if 10 ** ((n - 1) / 10) < last})


def at(rows, episode, key):
    """A curve's value after an episode: that of the last row up to it."""
    value = 0.0
    for row in rows:
        if row["episode"] > episode:
            break
        value = row[key]
    return value


def course(curves, last, key):
    """Median and range over the seeds' curves at the moments up to `last`."""
    points = []
    for episode in moments(last):
        s = spread([at(rows, episode, key) for rows in curves])
        points.append([episode, s["median"], s["least"], s["most"]])
    return points
