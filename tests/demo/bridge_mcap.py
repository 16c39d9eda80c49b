"""Logs to MCAP."""

import hashlib
import math
import os
import re
import subprocess

from bridging import STEP, Bridge, make, pose_at, poses_in, read_mcap, status_at, story


def one_wrong_ray(*wrong):
    return [[0.5] * 23 + [ray] for ray in wrong]


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
                "command": {"robot": 0, "left": 0.5, "right": -0.5, "read": 1, "intent": 3},
                "terminate": {"sender": 1, "signal": 2, "territory": 0},
                "status": {"robots": 2, "places": 3, "mines_found": 1, "state": [0, 3] + [9] * 14,
                           "scanned_by": [-1, 0, 1] + [99] * 125, "found": [0, 1, 0] + [7] * 125}}
        wrong = [math.nan, math.inf, -math.inf, 1e300, -1.1e9]
        bad = {"pose": {name: wrong for name in ("x", "y", "heading")},
               "scan": {"read": [2, -1], "mine": [2, -1], "range": one_wrong_ray(math.nan, math.inf, -0.5, 2e9)},
               "command": {"left": wrong, "right": wrong, "read": [2, -128], "intent": [4, -1]},
               "terminate": {"sender": [-1, 16, 2**31 - 1], "signal": [0, 3, -1], "territory": [-1, 16, -2**31]},
               "status": {"robots": [-1, 17], "places": [-1, 129], "mines_found": [-1, 4], "state": [[0, 6] + [0] * 14, [-1] * 16],
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

    def sealed(self, key, **fields):
        data = make("terminate", **fields)
        inner = hashlib.blake2b(key, digest_size=32).digest()
        return data[:-16] + hashlib.blake2b(data[:-16], key=inner, digest_size=16).digest()

    def test_with_a_key_signals_without_its_seal_are_left_out(self):
        team, other = b"k" * 32, b"o" * 40
        key = self.folder / "team.key"
        key.write_bytes(team)
        key.chmod(0o600)
        said = {"utime": STEP, "sender": 1, "signal": 1}
        log = self.log([("QUARTER_R0_POSE", make("pose", **pose_at(STEP, 0))), ("QUARTER_TERMINATE", make("terminate", **said)),
                        ("QUARTER_TERMINATE", self.sealed(other, **said)), ("QUARTER_TERMINATE", self.sealed(team, **said))])
        done = self.convert(log, "--mcap", self.mcap, "--key", key)
        self.assertRegex(done.stdout, r"(?m)^QUARTER_TERMINATE +3 +1 +2$")
        self.assertIn("QUARTER_TERMINATE: 2 skipped: without the key's seal", done.stderr)
        done = self.convert(log, "--mcap", self.mcap)
        self.assertRegex(done.stdout, r"(?m)^QUARTER_TERMINATE +3 +3 +0$")
        key.chmod(0o644)
        self.refuse("chmod 600", log, "--mcap", self.mcap, "--key", key)
        key.write_bytes(b"short")
        key.chmod(0o600)
        self.refuse("32 to 4096 bytes", log, "--mcap", self.mcap, "--key", key)
        os.mkfifo(self.folder / "pipe.key", 0o600)
        self.refuse("pipe.key: is a device or pipe", log, "--mcap", self.mcap, "--key", self.folder / "pipe.key")
        self.refuse("no.key: cannot be read", log, "--mcap", self.mcap, "--key", self.folder / "no.key")

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
