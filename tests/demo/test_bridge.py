"""test_bridge.py [--quarter PATH] [--lcm-gen PATH] [--no-rerun] [unittest's words]: tools/bridge, from outside.

Needs the packages of tools/bridge/requirements.txt; with --no-rerun those of requirements-mcap.txt, and what a Rerun
recording must hold is reported as skipped. QUARTER_TOOL and QUARTER_LCM_GEN stand for the paths. The live bus is in a
network namespace of its own.
"""

import argparse
import importlib.util
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

import network  # noqa: E402
from side_by_side import Telling  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent
BRIDGE = ROOT / "tools" / "bridge"
MISSION = ROOT / "demo" / "missions" / "turtlebot3_world" / "mission.yaml"
STEP = 50_000  # microseconds between poses
LOOPBACK = "ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo && exec \"$@\""
URL = "udpm://239.255.76.67:7667?ttl=0"

asked = argparse.Namespace()
without_rerun = unittest.skipIf("--no-rerun" in sys.argv, "Rerun is a download of 260 MB: -DQUARTER_TEST_RERUN=ON")


def find_lcm_gen():
    found = importlib.util.find_spec("lcm")
    return str(Path(found.origin).parent.parent / "bin" / "lcm-gen") if found else "lcm-gen"


def load_types(folder):
    subprocess.run([asked.lcm_gen, "--python", "--ppath", folder, *map(str, (ROOT / "lcmtypes").glob("*.lcm"))],
                   check=True)
    sys.path.insert(0, folder)
    import quarter
    sys.path.remove(folder)
    return quarter


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


class TestMcap(Bridge):
    def test_every_pose_arrives_exactly_and_at_its_time(self):
        self.convert(self.log(), "--mcap", self.mcap)
        rows, _ = read_mcap(self.mcap)
        self.assertEqual([(1000 * p["utime"], p) for p in story()[1]], poses_in(rows))

    def test_all_kinds_arrive_at_their_times(self):
        self.convert(self.log(), "--mcap", self.mcap)
        rows, schemas = read_mcap(self.mcap)
        self.assertEqual(["command", "pose", "scan", "status", "terminate"],
                         sorted(name.removeprefix("quarter.") for name in schemas))
        self.assertEqual([1e9, 2e9, 2.6e9], [at for topic, at, _ in rows if topic == "QUARTER_STATUS"])
        terminate = [(at, m["sender"], m["signal"]) for topic, at, m in rows if topic == "QUARTER_TERMINATE"]
        repeats = [(1000 * utime, 0, 1) for utime in range(2_500_000, 3_000_000, STEP)]
        self.assertEqual(sorted([*repeats, (2.6e9, 1, 2)]), sorted(terminate))
        scan = next(m for topic, _, m in rows if topic == "QUARTER_R1_SCAN")
        self.assertEqual({"utime", "robot", "read", "mine", "range"}, set(scan))
        self.assertEqual(24, len(scan["range"]))
        self.assertEqual({"type": "array", "items": {"type": "number"}, "minItems": 24, "maxItems": 24},
                         schemas["quarter.scan"]["properties"]["range"])

    def test_the_mission_is_one_message_at_time_zero(self):
        self.convert(self.log(), "--table", self.table(), "--mcap", self.mcap)
        (at, told), = [(at, m) for topic, at, m in read_mcap(self.mcap)[0] if topic == "QUARTER_MISSION"]
        self.assertEqual((0, 96, 14, 3), (at, told["columns"], len(told["place"]), len(told["routes"])))

    def test_it_reports_what_went_where_and_what_did_not(self):
        done = self.convert(self.log(), "--mcap", self.mcap)
        self.assertRegex(done.stdout, r"(?m)^channel +messages +to mcap +skipped$")
        self.assertRegex(done.stdout, r"(?m)^QUARTER_R0_POSE +61 +60 +1$")
        self.assertRegex(done.stdout, r"(?m)^QUARTER_R1_POSE +60 +60 +0$")
        self.assertRegex(done.stdout, rf"(?m)^wrote {re.escape(str(self.mcap))}: \d+ bytes$")
        self.assertEqual("bridge: note: QUARTER_R0_POSE: 1 skipped: does not decode as pose\n", done.stderr)

    def test_messages_that_cannot_be_are_skipped(self):
        good = pose_at(STEP, 0)
        odd = [{**good, "utime": -1}, {**good, "utime": 2**62}, {**good, "robot": 1}, {**good, "x": math.nan}]
        whole = make("pose", **good)
        events = [("QUARTER_R0_POSE", data) for data in
                  [whole, *(make("pose", **o) for o in odd), whole[:-1], whole[:7], b"", status_at(0)]]
        events += [("QUARTER_R0_OTHER", whole), ("CAMERA", b"\0" * 100)]
        done = self.convert(self.log(events), *self.outputs())
        self.assertEqual([(1000 * STEP, good)], poses_in(read_mcap(self.mcap)[0]))
        self.assertRegex(done.stdout, r"(?m)^QUARTER_R0_POSE +9( +1)+ +8$")
        self.assertIn("CAMERA: 1 skipped: not a channel of Quarter's", done.stderr)

    def test_what_a_message_says_must_be_possible(self):
        """As demo/bus/bus.c checks it, field by field."""
        good = {"pose": pose_at(STEP, 0), "scan": {"robot": 0, "read": 1, "mine": 0, "range": [0.5] * 24},
                "command": {"robot": 0, "left": 0.5, "right": -0.5, "read": 1},
                "terminate": {"sender": 1, "signal": 2, "territory": 0},
                "status": {"robots": 2, "places": 3, "mines_found": 1, "state": [0, 3] + [9] * 14,
                           "scanned_by": [-1, 0, 1] + [99] * 125, "found": [0, 1, 0] + [7] * 125}}
        wrong = [math.nan, math.inf, -math.inf, 1e300, -1.1e9]
        bad = {"pose": {name: wrong for name in ("x", "y", "heading")},
               "scan": {"read": [2, -1], "mine": [2, -1], "range": [[0.5] * 23 + [r] for r in (math.nan, math.inf, -0.5, 2e9)]},
               "command": {"left": wrong, "right": wrong, "read": [2, -128]},
               "terminate": {"sender": [-1, 16, 2**31 - 1], "signal": [0, 3, -1], "territory": [-1, 16, -2**31]},
               "status": {"robots": [-1, 17], "places": [-1, 129], "mines_found": [-1, 4], "state": [[0, 4] + [0] * 14, [-1] * 16],
                          "scanned_by": [[2] * 128, [-2] * 128], "found": [[2] + [0] * 127, [0, -1] + [0] * 126]}}
        channels = {"terminate": "QUARTER_TERMINATE", "status": "QUARTER_STATUS"}
        events, counts = [("QUARTER_R16_POSE", make("pose", **pose_at(STEP, 16)))], {"QUARTER_R16_POSE": (1, 0)}
        for kind, fields in bad.items():
            channel = channels.get(kind, f"QUARTER_R0_{kind.upper()}")
            told = [{}, *({name: value} for name, values in fields.items() for value in values)]
            events += [(channel, make(kind, **{"utime": STEP, **good[kind], **change})) for change in told]
            counts[channel] = len(told), 1
        done = self.convert(self.log(events), "--mcap", self.mcap)
        for channel, (messages, sound) in counts.items():
            self.assertRegex(done.stdout, rf"(?m)^{channel} +{messages} +{sound} +{messages - sound}$")
        for name in {"robot", *(name for fields in bad.values() for name in fields)}:
            self.assertIn(f"its {name} cannot be", done.stderr)

    def test_a_report_that_cannot_be_printed_is_said(self):
        with open("/dev/full", "wb") as full:
            done = subprocess.run(self.words(self.log(), "--mcap", self.mcap), stdout=full, stderr=subprocess.PIPE,
                                  encoding="utf-8")
        self.assertEqual(done.returncode, 2)
        self.assertIn("bridge: standard output cannot be written", done.stderr.splitlines()[-1])
        self.assertTrue(self.mcap.exists())

    def test_of_a_log_cut_in_the_middle_what_is_whole_arrives(self):
        events, poses = story()
        whole = self.log([e for e in events if e[0].endswith("POSE") and len(e[1]) == 44]).read_bytes()
        one = len(whole) // len(poses)
        for at in (len(whole) - 1, *(len(whole) - one + more for more in (29, 27, 3, 1))):
            (self.folder / "in.lcm").write_bytes(whole[:at])
            done = self.convert(self.folder / "in.lcm", "--mcap", self.mcap)
            self.assertEqual(poses[:-1], [m for _, m in poses_in(read_mcap(self.mcap)[0])])
            self.assertRegex(done.stderr, rf"in\.lcm: ends in the middle .* byte {len(whole) - one} of {at};")

    def test_around_damage_what_is_whole_arrives(self):
        events, poses = story()
        whole = self.log([e for e in events if e[0].endswith("POSE") and len(e[1]) == 44]).read_bytes()
        one = len(whole) // len(poses)
        damages = {"bytes lost": (whole[: 3 * one + 40] + whole[4 * one :], 3),
                   "head lost": (whole[: 3 * one] + whole[3 * one + 9 :], 3),
                   "lengths wrong": (whole[: 3 * one + 20] + b"\x7f" * 8 + whole[3 * one + 28 :], 3),
                   "length too large": (whole[: 3 * one + 24] + b"\0\0\1\0" + whole[3 * one + 28 :], 3),
                   "bytes between": (whole[: 3 * one] + b"garbage" + whole[3 * one :], None)}
        for name, (damaged, lost) in damages.items():
            with self.subTest(name):
                (self.folder / "in.lcm").write_bytes(damaged)
                done = self.convert(self.folder / "in.lcm", "--mcap", self.mcap)
                self.assertEqual([p for n, p in enumerate(poses) if n != lost],
                                 [m for _, m in poses_in(read_mcap(self.mcap)[0])])
                self.assertRegex(done.stderr, rf"in\.lcm: damaged from byte {3 * one} to \d+;")

    def test_a_world_started_anew_is_noted(self):
        events = [("QUARTER_R0_POSE", make("pose", **pose_at(utime, 0))) for utime in (0, 5_000_000, 0, STEP)]
        done = self.convert(self.log(events), *self.outputs())
        self.assertIn("the world's clock begins again, 1 times", done.stderr)


class TestRerun(Bridge):
    def chunks(self):
        """[(entity, is static, its table)]"""
        import rerun
        return [(c.entity_path, c.is_static, c.to_record_batch()) for c in
                rerun.chunk.RrdReader(str(self.rrd)).stream().to_chunks()]

    def column(self, table, ending):
        return next(table.column(i).to_pylist() for i, name in enumerate(table.schema.names) if name.endswith(ending))

    def times(self, table):
        import pyarrow
        return table.column(table.schema.get_field_index("utime")).cast(pyarrow.int64()).to_pylist()

    def moving(self, entity, ending):
        """[(nanoseconds, value)], flat"""
        return [(at, value[0]) for path, static, table in self.chunks() if path == entity and not static
                for at, value in zip(self.times(table), self.column(table, ending))]

    @without_rerun
    def test_the_recording_has_all_poses(self):
        self.convert(self.log(), "--table", self.table(), "--rerun", self.rrd)
        for robot in (0, 1):
            poses = [p for p in story()[1] if p["robot"] == robot]
            found = self.moving(f"/world/robots/{robot}", "translation")
            self.assertEqual([1000 * p["utime"] for p in poses], [at for at, _ in found])
            turned = self.moving(f"/world/robots/{robot}", "quaternion")
            for pose, (_, at), (_, turn) in zip(poses, found, turned):
                self.assertAlmostEqual(pose["x"], at[0], delta=1e-7)
                self.assertAlmostEqual(pose["y"], at[1], delta=1e-7)
                self.assertAlmostEqual(pose["heading"], 2 * math.atan2(turn[2], turn[3]), delta=1e-6)

    @without_rerun
    def test_the_recording_tells_what_happened_and_when(self):
        self.convert(self.log(), "--rerun", self.rrd)
        found = [(at // 1000, level, text) for entity in ("/events/status", "/events/terminate")
                 for (at, level), (_, text) in zip(self.moving(entity, "level"), self.moving(entity, "text"))]
        self.assertEqual(HAPPENED, sorted(found))
        self.assertEqual(9, len(self.moving("/events/terminate/repeats", "text")))

    @without_rerun
    def test_all_that_moves_is_on_the_timeline_of_the_world(self):
        self.convert(self.log(), "--table", self.table(), "--rerun", self.rrd)
        chunks = self.chunks()
        for entity, static, table in chunks:
            if not static:
                self.assertIn("utime", table.schema.names, entity)
                self.assertNotIn("log_time", table.schema.names, entity)
        self.assertLessEqual({f"/world/{e}" for e in ("border", "places", "plan/0", "plan/2", "robots/1/heading")},
                             {entity for entity, static, _ in chunks if static})
        self.assertLessEqual({"/world/trails", "/world/robots/0/scan", "/commands/1", "/world/mines", "/world/scanned"},
                             {entity for entity, static, _ in chunks if not static})

    @without_rerun
    def test_places_stand_where_the_mission_has_them(self):
        self.convert(self.log(), "--table", self.table(), "--rerun", self.rrd)
        (places,) = [table for entity, _, table in self.chunks() if entity == "/world/places"]
        stated = re.findall(r"(?m)^  - \{x: (\S+), y: (\S+), weight", MISSION.read_text(encoding="utf-8"))
        found = self.column(places, "centers")[0]
        self.assertEqual(14, len(stated))
        for (x, y), at in zip(stated, found):
            self.assertAlmostEqual(float(x), at[0], delta=0.1001)  # half a cell
            self.assertAlmostEqual(float(y), at[1], delta=0.1001)

    @without_rerun
    def test_without_metres_a_cell_is_one(self):
        drawing = self.folder / "map.txt"
        drawing.write_text("S..#\n....\n.#.5\n", encoding="utf-8")
        self.convert(self.log(), "--table", self.table(drawing), "--rerun", self.rrd)
        (places,) = [table for entity, _, table in self.chunks() if entity == "/world/places"]
        self.assertEqual([3.5, 0.5], self.column(places, "centers")[0][0][:2])
        (plan,) = [table for entity, _, table in self.chunks() if entity == "/world/plan/0"]
        self.assertEqual([[0.5, 2.5], [3.5, 0.5]], [p[:2] for p in self.column(plan, "strips")[0][0]])

    @without_rerun
    def test_the_map_is_drawn_as_inspect_tells_it(self):
        drawing = self.folder / "map.txt"
        drawing.write_text("S.#\n.3.\n", encoding="utf-8")
        table = self.table(drawing)
        told = json.loads(subprocess.check_output([asked.quarter, "inspect", str(table), "--json"]))
        told["map"] = [".2#", ".9."]
        tool = self.folder / "tool"
        tool.write_text(f"#!/bin/sh\ncat <<'END'\n{json.dumps(told)}\nEND\n", encoding="utf-8")
        tool.chmod(0o755)
        self.convert(self.log(), "--table", table, "--rerun", self.rrd, quarter=tool)
        (drawn,) = [table for entity, _, table in self.chunks() if entity == "/world/map"]
        self.assertEqual([250, 238, 70, 250, 150, 250], list(self.column(drawn, ":data")[0][0]))


class TestRefusals(Bridge):
    def test_bad_input_is_one_line_that_names_the_mend(self):
        log, text, empty = self.log(), self.folder / "text.lcm", self.folder / "empty.lcm"
        text.write_text("no log\n" * 100, encoding="utf-8")
        empty.write_bytes(b"")
        out = ["--mcap", self.mcap]
        self.refuse("no such file; check its name", self.folder / "none.lcm", *out)
        self.refuse("not an LCM log; name one", text, *out)
        self.refuse("not an LCM log; name one", empty, *out)
        self.refuse("cannot be read .*; name a log", self.folder, *out)
        self.refuse("none.qtr: no such file; check its name", log, "--table", self.folder / "none.qtr", *out)
        self.refuse("not a Quarter policy table; name", log, "--table", text, *out)
        self.refuse("cannot be written .*; name a file in a folder", log, "--mcap", self.folder / "none" / "out.mcap")
        self.refuse("a folder; name a file", log, "--mcap", self.folder)
        self.refuse("name a log, or --live", *out)
        self.refuse("not both", log, "--live", *out)
        self.refuse("nothing to write: name --rerun", log)
        self.refuse("the same", log, "--mcap", log)
        self.refuse("--seconds", log, "--seconds", "3", *out)
        self.refuse("--seconds takes a number", "--live", "--seconds", "0", *out)
        self.refuse("unrecognized arguments", log, "--nonsense", *out)
        self.refuse("LCM cannot open it .*; the default is", "--live", "--lcm-url", "nonsense://", *out)

    def test_programs_that_do_not_start(self):
        words = [self.log(), "--table", self.table(), "--mcap", self.mcap]
        self.refuse("/none: the host tool does not start .*build it", *words, quarter="/none")
        self.refuse("inspect failed with status 1", *words, quarter="false")
        self.refuse("take both from one checkout", *words, quarter="echo")
        self.refuse("/none: does not start .*--lcm-gen PATH", *words, lcm_gen="/none")
        self.refuse("false: failed .*libglib2.0-0", *words, lcm_gen="false")

    def test_a_log_of_other_messages_is_refused(self):
        self.refuse("none of 2 messages fits", self.log([("CAMERA", b"x"), ("QUARTER_R0_POSE", b"y")]), *self.outputs())

    def test_a_missing_package_is_named(self):
        log = self.log()
        live = ["--live", "--seconds", "1", "--mcap", self.mcap]
        for package, module, words in (("rerun-sdk", "rerun", [log, "--rerun", self.rrd]),
                                       ("mcap", "mcap", [log, "--mcap", self.mcap]), ("lcm", "lcm", live)):
            broken = self.folder / package
            broken.mkdir()
            (broken / f"{module}.py").write_text("raise ImportError\n", encoding="utf-8")
            paths = [str(broken), *filter(None, [os.environ.get("PYTHONPATH")])]
            self.refuse(f"package {package} is missing; .*requirements.txt", *words,
                        env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)})

    def little_room(self):
        resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))  # bytes of a file; enough for what lcm-gen writes

    def test_no_room_leaves_nothing(self):
        log = self.log([("QUARTER_R0_POSE", make("pose", **pose_at(utime * 997, 0))) for utime in range(5000)])
        for output in (["--mcap", self.mcap], self.outputs(), self.outputs()[2:]):
            if output:
                self.refuse("cannot be written .*; free some space", log, *output, preexec_fn=self.little_room)

    def test_an_output_of_before_stays_when_the_next_fails(self):
        self.mcap.write_text("of before", encoding="utf-8")
        self.refuse("none of 1 messages", self.log([("CAMERA", b"x")]), "--mcap", self.mcap)
        self.assertEqual("of before", self.mcap.read_text(encoding="utf-8"))


class TestLive(Bridge):
    def in_namespace(self, script, *words, **how):
        network.need_network()
        return subprocess.run([*network.unshare("n"), "sh", "-c", script, "sh", *map(str, words)], capture_output=True,
                              encoding="utf-8", **how)

    def publish(self, ending, *words):
        """A bridge that listens, and a publisher beside it, both in a network of their own."""
        bridge = self.words("--live", *words, *self.outputs())
        done = self.in_namespace(LOOPBACK, sys.executable, "-B", __file__, "--lcm-gen", asked.lcm_gen, "--publish",
                                 ending, *bridge, env={**os.environ, "LCM_DEFAULT_URL": URL})
        self.assertEqual(0, done.returncode, done.stderr)
        return done

    def check_heard(self, done):
        rows = poses_in(read_mcap(self.mcap)[0])
        self.assertGreater(len(rows), 0)
        self.assertEqual([(1000 * m["utime"], pose_at(m["utime"], 0)) for _, m in rows], rows)
        self.assertIn("\nhearing QUARTER_R0_POSE\n", done.stdout)
        self.assertRegex(done.stdout, rf"(?m)^QUARTER_R0_POSE +{len(rows)} .* 0$")
        if not asked.no_rerun:
            self.assertGreater(self.rrd.stat().st_size, 0)

    def test_time_or_an_interrupt_ends_the_listening_and_keeps_the_outputs(self):
        self.check_heard(self.publish("time", "--seconds", "1"))
        self.check_heard(self.publish("interrupt"))

    def test_silence_is_said(self):
        done = self.in_namespace(LOOPBACK, *self.words("--live", "--lcm-url", URL, "--seconds", "0.1", *self.outputs()))
        self.assertEqual(2, done.returncode)
        self.assertRegex(done.stderr, r"\Abridge: .*heard nothing of Quarter's; start the demo.*\n\Z")
        self.assertEqual([], list(self.folder.iterdir()))

    def test_no_multicast_route_is_said(self):
        for script in ('exec "$@"', 'ip link set lo up && exec "$@"'):
            done = self.in_namespace(script, *self.words("--live", "--lcm-url", URL, *self.outputs()))
            self.assertEqual(2, done.returncode)
            self.assertRegex(done.stderr, r"\Abridge: no multicast route; .* dev lo .*\n\Z")


class TestFiles(Bridge):
    def test_help_leads_with_examples(self):
        self.assertTrue(self.convert("--help").stdout.startswith("python3 tools/bridge run.lcm --table mission.qtr"))

    def test_it_knows_the_channels_of_the_demo(self):
        header = (ROOT / "demo" / "bus" / "channels.h").read_text(encoding="utf-8")
        names = re.findall(r'#define CHANNEL_[A-Z]+ "(QUARTER_[A-Z%]\S+)"', header)
        self.assertEqual(5, len(names))
        sys.path.insert(0, str(BRIDGE))
        import decoding
        sys.path.remove(str(BRIDGE))
        for name in names:
            kind, robot = decoding.kind_of(name.replace("%d", "12"))
            self.assertEqual((name.rsplit("_", 1)[1].lower(), 12 if "%d" in name else None), (kind, robot))

    def test_the_short_list_of_packages_is_part_of_the_long_one(self):
        short, full = ((BRIDGE / name).read_text(encoding="utf-8") for name in ("requirements-mcap.txt", "requirements.txt"))
        pins = re.findall(r"(?m)^[a-z].*\n(?: +--hash.*\n)+", short)
        self.assertGreater(len(pins), 2)
        for pin in pins:
            self.assertIn(pin, full)


def publish(ending, *bridge):
    """Inside the namespace: publish poses once the bridge listens; interrupt it once it has heard one, or let it end."""
    import lcm
    bus = lcm.LCM(URL)
    process = subprocess.Popen(bridge, stdout=subprocess.PIPE, encoding="utf-8")
    try:
        said = [process.stdout.readline()]  # from here on it listens
        for number in range(50):
            bus.publish("QUARTER_R0_POSE", make("pose", **pose_at(number * STEP, 0)))
        said.append(process.stdout.readline())  # from here on it has heard something
        if ending == "interrupt":
            process.send_signal(signal.SIGINT)
        print(*said, process.communicate()[0], sep="", end="")
        return process.returncode
    finally:
        process.kill()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quarter", default=os.environ.get("QUARTER_TOOL") or shutil.which("quarter"))
    parser.add_argument("--lcm-gen", default=os.environ.get("QUARTER_LCM_GEN") or find_lcm_gen())
    parser.add_argument("--no-rerun", action="store_true")
    parser.add_argument("--publish", nargs=argparse.REMAINDER, help=argparse.SUPPRESS)
    _, rest = parser.parse_known_args(namespace=asked)
    needed = ["lcm"] if asked.publish else ["lcm", "mcap"] if asked.no_rerun else ["lcm", "mcap", "rerun"]
    missing = [module for module in needed if importlib.util.find_spec(module) is None]
    if missing:
        sys.exit(f"test_bridge.py: no Python package {', '.join(missing)}; install tools/bridge/requirements.txt")
    with tempfile.TemporaryDirectory(prefix="quarter-bridge-types-") as folder:
        asked.types = load_types(folder)
    if asked.publish:
        sys.exit(publish(*asked.publish))
    if asked.quarter is None:
        sys.exit("test_bridge.py: no quarter; name it: --quarter PATH")
    asked.quarter = str(Path(asked.quarter).resolve())
    unittest.main(argv=[sys.argv[0], *rest], testRunner=Telling)


if __name__ == "__main__":
    main()
