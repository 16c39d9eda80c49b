"""The bridge from outside: messages and logs to give it, and what its tests share."""

import argparse
import json
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BRIDGE = ROOT / "tools" / "bridge"
MISSION = ROOT / "demo" / "missions" / "turtlebot3_world" / "mission.yaml"
STEP = 50_000  # microseconds between poses
asked = argparse.Namespace()
without_rerun = unittest.skipIf("--no-rerun" in sys.argv, "Rerun is a download of 260 MB: -DQUARTER_TEST_RERUN=ON")


def make(kind, **fields):
    message = getattr(asked.types, kind)()
    for name, value in fields.items():
        assert hasattr(message, name)
        setattr(message, name, value)
    return message.encode()


def pose_at(utime, robot):
    """Numbers that no shorter decimal stands for."""
    angle = utime / 1e6 + robot
    return {"utime": utime, "robot": robot, "x": math.cos(angle) / 3, "y": math.sin(angle) / 7, "heading": angle / 11}


def status_at(utime, scanned=(), found=(), state=(0, 0)):
    by = [dict(scanned).get(place, -1) for place in range(128)]
    return make("status", utime=utime, robots=2, places=14, mines_found=len(found), scanned_by=by,
                found=[int(place in found) for place in range(128)], state=[*state, *[0] * 14])


def story():
    """(channel, data) of three seconds of two robots, and the poses in it."""
    events, poses = [], []
    for utime in range(0, 3_000_000, STEP):
        for robot in (0, 1):
            poses.append(pose_at(utime, robot))
            events.append((f"QUARTER_R{robot}_POSE", make("pose", **poses[-1])))
            events.append((f"QUARTER_R{robot}_SCAN",
                           make("scan", utime=utime, robot=robot, read=0, mine=0, range=[0.5 + 0.01 * r for r in range(24)])))
            events.append((f"QUARTER_R{robot}_COMMAND",
                           make("command", utime=utime, robot=robot, left=0.1, right=utime / 3e7)))
        if utime == 1_000_000:
            events.append(("QUARTER_STATUS", status_at(utime, {3: 1})))
        if utime == 2_000_000:
            events.append(("QUARTER_STATUS", status_at(utime, {3: 1, 5: 0}, [5], (0, 2))))
            events.append(("QUARTER_R0_POSE", b"neither a pose nor anything else"))
        if utime >= 2_500_000:
            events.append(("QUARTER_TERMINATE", make("terminate", utime=utime, sender=0, signal=1)))
        if utime == 2_600_000:
            events.append(("QUARTER_TERMINATE", make("terminate", utime=utime, sender=1, signal=2, territory=1)))
            events.append(("QUARTER_STATUS", status_at(utime, {3: 1, 5: 0}, [5], (3, 2))))
    return events, poses


HAPPENED = [  # what the story tells, worked out by hand
    (1_000_000, "INFO", "place 3: scanned, robot 1 was there first"),
    (2_000_000, "INFO", "place 5: mine found"),
    (2_000_000, "INFO", "place 5: scanned, robot 0 was there first"),
    (2_000_000, "WARN", "robot 1: lost"),
    (2_500_000, "INFO", "robot 0 says: target found"),
    (2_600_000, "INFO", "robot 1 says: territory 1 done"),
    (2_600_000, "WARN", "robot 0: stuck"),
]


def write_log(path, events):
    import lcm
    log = lcm.EventLog(str(path), "w", overwrite=True)
    for number, (channel, data) in enumerate(events):
        log.write_event(1_700_000_000_000_000 + number, channel, data)
    log.close()
    return path


def read_mcap(path):
    """[(topic, log time, message)] in the order of time, and the schemas by name."""
    from mcap.reader import make_reader
    with open(path, "rb") as file:
        reader, rows, schemas = make_reader(file), [], {}
        for schema, channel, message in reader.iter_messages():
            assert schema.encoding == "jsonschema" and channel.message_encoding == "json"
            schemas[schema.name] = json.loads(schema.data)
            rows.append((channel.topic, message.log_time, json.loads(message.data)))
    return rows, schemas


def poses_in(rows):
    return sorted(((at, m) for topic, at, m in rows if topic.endswith("_POSE")), key=lambda r: (r[0], r[1]["robot"]))


class Bridge(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="quarter-bridge-test-")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.rrd, self.mcap = self.folder / "out.rrd", self.folder / "out.mcap"

    def words(self, *words, quarter=None, lcm_gen=None):
        return [sys.executable, "-B", str(BRIDGE), *map(str, words), "--quarter", str(quarter or asked.quarter),
                "--lcm-gen", lcm_gen or asked.lcm_gen]

    def run_bridge(self, *words, quarter=None, lcm_gen=None, **how):
        return subprocess.run(self.words(*words, quarter=quarter, lcm_gen=lcm_gen), capture_output=True,
                              encoding="utf-8", **how)

    def convert(self, *words, **how):
        done = self.run_bridge(*words, **how)
        self.assertEqual(0, done.returncode, done.stderr)
        return done

    def outputs(self):
        return [word for word in ("--mcap", self.mcap, *(() if asked.no_rerun else ("--rerun", self.rrd)))]

    def refuse(self, pattern, *words, **how):
        """One line on the error output, status 2, and nothing left behind."""
        before = sorted(self.folder.iterdir())
        done = self.run_bridge(*words, **how)
        self.assertEqual(2, done.returncode, (words, done.stderr))
        self.assertRegex(done.stderr, re.compile(r"\Abridge: .*(?:" + pattern + r").*\n\Z"))
        self.assertEqual("", done.stdout)
        self.assertEqual(before, sorted(self.folder.iterdir()))

    def log(self, events=None):
        return write_log(self.folder / "in.lcm", story()[0] if events is None else events)

    def table(self, mission=MISSION):
        table = self.folder / "mission.qtr"
        subprocess.run([asked.quarter, "learn", str(mission), "-q", "-o", str(table)], check=True)
        return table
