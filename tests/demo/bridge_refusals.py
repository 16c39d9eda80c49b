"""What the bridge refuses, and what it says of itself."""

import os
import re
import resource
import sys

from bridging import BRIDGE, ROOT, Bridge, make, pose_at


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
