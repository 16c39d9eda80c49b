"""The demo's programs in networks of their own: what their tests share."""

import argparse
import collections
import hashlib
import json
import os
import re
import shutil
import struct
import sys
import unittest
import zlib
from pathlib import Path

import lcmlog
import network
from lcmlog import COMMAND, DONE, FOUND, POSE, SCAN, STATUS, TERMINATE
from network import Network
from side_by_side import Runner

ROOT = Path(__file__).resolve().parent.parent.parent
MISSIONS = ROOT / "demo" / "missions"
MISSION = MISSIONS / "minefield" / "mission.yaml"
TICK = 0.05
TAG = 16  # bytes of a seal, the end of a terminate message
LINE = re.compile(r'<script id="replay" type="application/json">(.*?)</script>', re.DOTALL)
asked = argparse.Namespace()  # the command line, and what prepare() made


def program(name, *words):
    return asked.programs / name, *words


def demo(*words):
    return program("quarter-demo", MISSION, "--table", asked.table, *words)


def world(*words):
    return program("quarter-world", MISSION, "--table", asked.table, *words)


def robot(number, *words):
    return program("quarter-robot", asked.table, "--robot", number, *words)


def identity_of(table):
    """Of the division that a table makes from the mission's own starts, nothing cleared, worked out apart from the core: as the
    32-bit number of a message."""
    places, seekers = struct.unpack_from("<HB", table, 20)
    starts = struct.unpack_from(f"<{seekers}H", table, *struct.unpack_from("<H", table, 6))
    nodes = struct.pack(f"<{seekers}H", *(places + start for start in starts))
    identity = zlib.crc32(nodes + bytes((places + 7) // 8), struct.unpack_from("<I", table, 12)[0])
    return identity - 2**32 if identity >= 2**31 else identity


def terminate(key=None, **message):
    """A signal of this table's first run, where nothing else is said; sealed if there is a key, the contents of its file."""
    data = TERMINATE.encode(**{"territory": 0, "identity": asked.identity, "run": 0, "tag": [0] * TAG, **message})
    return data if key is None else data[:-TAG] + tag_of(data[:-TAG], key)


def tag_of(data, key):
    """As demo/bus/seal.c makes it, by code that shares nothing with it."""
    return hashlib.blake2b(data, key=hashlib.blake2b(key, digest_size=32).digest(), digest_size=TAG).digest()


def page_data(path):
    return json.loads(LINE.search(Path(path).read_text(encoding="utf-8"))[1])


def prepare():
    """One table for all tests, what it plans, and the places that it reaches soon."""
    folder = Path("prepared").resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    asked.table = folder / "mission.qtr"
    status, _, errors = network.Program(
        program("quarter-demo", MISSION, "--learn-limit", 2, "--save-table", asked.table, "--mine", "none", "-o",
                folder / "plan.html", "--quiet")).end()
    assert status == 0, errors
    asked.identity = identity_of(asked.table.read_bytes())
    asked.plan = page_data(folder / "plan.html")
    asked.robots, asked.places = len(asked.plan["starts"]), len(asked.plan["places"])
    planned = sorted((place["planned"], number) for number, place in enumerate(asked.plan["places"])
                     if place["planned"] is not None)
    asked.soon = [number for seconds, number in planned if seconds < 20]  # the soonest first
    assert len(asked.soon) >= 2, planned


def is_found(channel, data):
    return channel == "QUARTER_TERMINATE" and TERMINATE.decode(data)["signal"] == FOUND


def drives(order):
    """Or stands for a look, or until it is ready: it has not stopped."""
    return bool(order["left"] or order["right"] or order["read"] or order["intent"] == 1)


def note_order(stands_since, robot, order, seconds):
    """Keep since when each robot stands."""
    if drives(order):
        stands_since.pop(robot, None)
    else:
        stands_since.setdefault(robot, seconds)


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.id().rpartition(".")[2]).resolve()
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()

    def network(self, **options):
        return self.enterContext(Network(**options))

    def line(self, ended, status, *says):
        """It ended with this status, silent but for one line that says these."""
        self.assertEqual(ended[0], status, ended)
        self.assertEqual(ended[1], "")
        self.assertEqual(len(ended[2].splitlines()), 1, ended[2])
        for words in says:
            self.assertIn(words, ended[2])

    def play(self, net, *words, name="game"):
        """A game in processes: (what its JSON says, the programs' standard error). Nobody is left behind."""
        outputs = "--json", "--log", self.folder / f"{name}.lcm", "-o", self.folder / f"{name}.html"
        status, output, errors = net.run(*demo("--processes", *outputs, *words))
        self.assertEqual(status, 0, errors)
        self.assertEqual(net.inhabitants(), [])
        return json.loads(output), errors

    def check_messages(self, path, game):
        """A log against the JSON of its game, whatever was lost: {kind: how many}."""
        sent = collections.Counter()
        last = 0
        for time, channel, data in lcmlog.read(path):
            kind, number = lcmlog.type_of(channel)
            message = kind.decode(data)
            self.assertLess(8 + len(channel) + 1 + len(data), 1400)
            self.assertEqual(time, message["utime"])
            sent[channel.rpartition("_")[2].lower()] += 1
            if number is not None:
                self.assertEqual(message["robot"], number)
                self.assertLess(number, game["robots"])
            if kind is TERMINATE:
                self.assertIn(message["signal"], (FOUND, DONE))
                self.assertIn(message["sender"], range(game["robots"]))
                self.assertIn(message["territory"], range(game["robots"]))
            if kind in (POSE, SCAN, STATUS):
                self.assertGreaterEqual(time, last)
                last = time
        self.assertLess(last / 1e6, game["duration"])
        self.assertEqual(sent["command"], game["result"]["messages"]["command"])
        self.assertEqual(sent["terminate"], game["result"]["messages"]["terminate"])
        return sent

    def check_story(self, path, game):
        """Where nothing was lost, a log tells when it was found and when each robot stopped."""
        mine_seen, poses = [], collections.defaultdict(list)
        stands_since = {}
        for time, channel, data in lcmlog.read(path):
            kind, number = lcmlog.type_of(channel)
            message = kind.decode(data)
            if kind is POSE:
                poses[number].append(round(time / 1e6 / TICK))
            if kind is SCAN and message["mine"]:
                mine_seen.append(time / 1e6)
            if kind is COMMAND:
                note_order(stands_since, number, message, time / 1e6)
        for ticks in poses.values():
            self.assertEqual(sorted(set(ticks)), list(range(ticks[-1] + 1)))
        found = game["result"]["found_at"]
        self.assertEqual([round(game["pace"] * seen, 3) for seen in mine_seen[:1]], [found] if found is not None else [])
        self.assertEqual(len(stands_since), game["robots"])
        return max(stands_since.values())


def main(description, *needed):
    """Run the tests of the program that is started, with --programs FOLDER and what else it needs: a folder each."""
    parser = argparse.ArgumentParser(description=description)
    for name in ("programs", *needed):
        parser.add_argument(f"--{name}", required=True, type=lambda text: Path(text).resolve())
    words = parser.parse_known_args(namespace=asked)[1]
    os.environ.pop("LCM_DEFAULT_URL", None)
    prepare()
    unittest.main(argv=[sys.argv[0], *words], testRunner=Runner)
