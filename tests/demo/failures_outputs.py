"""Disks that are full, files that may not be written, standard output that does not take it."""

import shutil
import signal
import sys

import network
from programs import MISSION, ROOT, Case, asked, demo, program, world

LONG = ROOT / "tests" / "data" / "long.txt"  # is not learnt to the end
PROGRAMS = ("quarter-demo", "quarter-world", "quarter-robot")


class Outputs(Case):
    def make_disk(self):
        network.need("m")
        (self.folder / "disk").mkdir()

    def run_on(self, mount, *words):
        """In a mount namespace where the disk is mounted: (status, output, errors)."""
        script = f'mount -t tmpfs -o {mount} none disk && exec "$@"'
        return network.Program([*network.unshare("m"), "sh", "-c", script, "sh", *words], cwd=self.folder).end()

    def test_every_output_on_a_full_device_fails_with_one_line(self):
        for option in ("--log", "-o", "--json", "--save-table"):
            words = [f"{option}=/dev/full"] if option.startswith("--") else [option, "/dev/full"]
            with self.subTest(option=option):
                self.line(network.Program(demo(*words, "-q")).end(), 2, "/dev/full", "space")
                self.assertEqual(list(self.folder.iterdir()), [])

    def test_standard_output_on_a_full_device_fails_with_one_line(self):
        games = [demo(), demo("--json"), demo("--runs", 2), demo("--runs", 2, "--json")]
        helps = [program(name, word) for name in PROGRAMS for word in ("--help", "--version")]
        for words in games + helps:
            with self.subTest(words=[str(word) for word in words]):
                script = 'exec "$@" >/dev/full'
                self.line(network.Program(["sh", "-c", script, "sh", *words]).end(), 2, "cannot")

    def test_help_and_version_are_printed(self):
        for name in PROGRAMS:
            status, output, errors = network.Program(program(name, "--version")).end()
            self.assertEqual((status, errors), (0, ""))
            self.assertRegex(output, rf"^{name} \d+\.\d+\.\d+\n$")
            status, output, errors = network.Program(program(name, "--help")).end()
            self.assertEqual((status, errors), (0, ""))
            self.assertIn("Exit status", output)

    def test_a_disk_that_fills_up_leaves_nothing_half_written(self):
        self.make_disk()
        for words in (["--log", "disk/game.lcm"], ["-o", "disk/game.html"]):
            with self.subTest(words=words):
                ended = self.run_on("size=32k", "sh", "-c", '"$@"; status=$?; ls disk >&2; exit $status', "sh",
                                    *demo("-q", *words))
                self.line(ended, 2, words[1], "space")  # ls has nothing to say

    def test_a_world_with_a_log_on_a_full_device_ends_at_once(self):
        net = self.network()
        page = self.folder / "game.html"
        status, output, errors = net.run(*demo("--processes", "--log", "/dev/full", "--mine", "none", "-o", page))
        self.assertEqual((status, output), (2, ""))
        self.assertIn("quarter: /dev/full: ", errors)
        self.assertFalse(page.exists())
        self.assertEqual(net.inhabitants(), [])

    def test_a_folder_that_may_not_be_written_is_found_out_before_the_learning(self):
        self.make_disk()
        for words in (["--log", "disk/a"], ["-o", "disk/a"], ["--json=disk/a"], ["--save-table", "disk/a"]):
            with self.subTest(words=words):
                self.line(self.run_on("ro", *program("quarter-demo", "no-mission.yaml", *words)), 2, "disk/a", "Read-only")

    def test_no_file_is_named_twice(self):
        table = self.folder / "own.qtr"
        shutil.copy(asked.table, table)
        (self.folder / "link.qtr").symlink_to(table)
        for words in (["-o", "a", "--log", "./a"], ["--json=b", "-o", "b"], ["--save-table", "c", "--log", "c"],
                      ["--log", "own.qtr"], ["-o", "link.qtr"], ["--save-table", "link.qtr"]):
            with self.subTest(words=words):
                for name in ("quarter-demo", "quarter-world")[: 1 if "--save-table" in words else 2]:
                    ended = network.Program(program(name, MISSION, "--table", table, *words), cwd=self.folder).end()
                    self.line(ended, 2, "named twice")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["link.qtr", "own.qtr"])
        self.assertEqual(table.read_bytes(), asked.table.read_bytes())

    def test_what_a_mission_names_is_not_overwritten(self):
        own = self.folder / "own.yaml"
        inputs = {"map.txt": "S.1\n...\n", "places.csv": "column,row,weight\n2,1,3\n"}
        own.write_text("map: map.txt\nplaces_csv: places.csv\n", encoding="utf-8")
        (self.folder / "link").symlink_to("map.txt")
        for name, contents in inputs.items():
            (self.folder / name).write_text(contents, encoding="utf-8")
        for name in (*inputs, "link"):
            for words in (["-o", name], ["--log", name], [f"--json={name}"], ["--save-table", name]):
                for does in ("quarter-demo", "quarter-world")[: 1 if "--save-table" in words else 2]:
                    with self.subTest(program=does, words=words):
                        ended = network.Program(program(does, own, *words), cwd=self.folder).end()
                        self.line(ended, 2, f"{name}: ", "overwrite the input")
        for name, contents in inputs.items():
            self.assertEqual((self.folder / name).read_text(encoding="utf-8"), contents)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["link", "map.txt", "own.yaml", "places.csv"])

    def test_a_signal_before_there_is_a_plan_ends_it_at_once(self):
        script = "import os, signal, sys\nsignal.pthread_sigmask(signal.SIG_BLOCK, [int(sys.argv[1])])\n" \
                 "os.kill(os.getpid(), int(sys.argv[1]))\nos.execv(sys.argv[2], sys.argv[2:])"
        for number in (signal.SIGINT, signal.SIGTERM):  # it is there before the program is
            for name in ("quarter-demo", "quarter-world"):
                with self.subTest(program=name, number=number):
                    words = program(name, LONG, "--learn-limit", 10000, "-o", "page.html", "--log", "game.lcm")
                    ended = network.Program([sys.executable, "-c", script, int(number), *words], cwd=self.folder).end()
                    self.line(ended, 128 + number, "(interrupted)", "nothing was written")
                    ended = network.Program([sys.executable, "-c", script, int(number), *words, "-q"], cwd=self.folder).end()
                    self.assertEqual(ended, (128 + number, "", ""))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_world_refuses_what_it_does_not_do(self):
        for words in (["--save-table", "a.qtr"], ["--runs", 3], ["--live"], ["--follow"], ["--processes"], ["--lose-one"],
                      ["--strategy", "nearest"]):
            self.line(network.Program(world(*words), cwd=self.folder).end(), 2, words[0])
        self.line(network.Program(world("--mine", asked.places), cwd=self.folder).end(), 2, "--mine")
        self.assertEqual(list(self.folder.iterdir()), [])
