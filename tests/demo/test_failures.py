"""test_failures.py --programs FOLDER [unittest's words]: what the demo does when something fails around it.

Disks that are full, worlds and robots that stop, strangers on the bus and at the viewer's port. Each game is in a network
of its own. Writes into the working directory alone.
"""

import argparse
import contextlib
import json
import os
import re
import shutil
import signal
import socket
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

import lcmlog  # noqa: E402
import network  # noqa: E402
from lcmlog import COMMAND, FOUND, POSE, SCAN, STATUS, TERMINATE  # noqa: E402
from network import Network  # noqa: E402
from side_by_side import Runner  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent
MISSION = ROOT / "demo" / "missions" / "minefield" / "mission.yaml"
TICK = 0.05
LONG = ROOT / "tests" / "data" / "long.txt"  # is not learnt to the end
BROKEN_OFF = 3  # exit status
EVENTS = 2048  # that are kept of a game
VIEWERS = 24  # at a time
DATA = re.compile(r'<script id="replay" type="application/json">(.*?)</script>', re.DOTALL)
PROGRAMS = ("quarter-demo", "quarter-world", "quarter-robot")

asked = argparse.Namespace()  # the command line, and what prepare() made


def program(name, *words):
    return asked.programs / name, *words


def demo(*words):
    return program("quarter-demo", MISSION, "--table", asked.table, *words)


def world(*words):
    return program("quarter-world", MISSION, "--table", asked.table, *words)


def robot(number, *words):
    return program("quarter-robot", asked.table, "--robot", number, *words)


def prepare():
    """One table for all tests."""
    folder = Path("prepared").resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    asked.table = folder / "mission.qtr"
    asked.page = folder / "game.html"
    status, output, errors = network.Program(program(
        "quarter-demo", MISSION, "--learn-limit", 2, "--save-table", asked.table, "--json", "-o", asked.page)).end()
    assert status == 0, errors
    asked.robots = json.loads(output)["robots"]
    asked.places = len(page_data(asked.page)["places"])


def page_data(path):
    return json.loads(DATA.search(Path(path).read_text(encoding="utf-8"))[1])


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


# ---- outputs ----

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


# ---- worlds and robots that stop ----

class BrokenOff(Case):
    def start_game(self, *words):
        """A game in processes in which all drive: (network, launcher, {name: process id})."""
        net = self.network()
        outputs = "--log", self.folder / "game.lcm", "-o", self.folder / "game.html"
        launcher = net.start(*demo("--processes", "--mine", "none", "--json", *outputs, *words))
        listener = net.listen()
        for number in range(asked.robots):
            listener.await_message(lambda _, channel, data, wanted=f"QUARTER_R{number}_COMMAND": channel == wanted
                                   and COMMAND.decode(data)["utime"] > 1e6, f"a command of robot {number}'s")
        children = launcher.children()
        names = {"world" if words[0] == "quarter-world" else int(words[words.index("--robot") + 1]): pid
                 for pid, words in children.items()}
        self.assertEqual(len(names), asked.robots + 1, children)
        return net, launcher, names

    def await_robots_gone(self, launcher):
        launcher.await_that(lambda: sum("process ended" in line for line in launcher.lines) == asked.robots)

    def check_broken_off(self, net, launcher, whole):
        status, output, errors = launcher.end()
        self.assertEqual((status, output), (BROKEN_OFF, ""), errors)
        self.assertIn("broken off", errors.splitlines()[-1])
        self.assertEqual(net.inhabitants(), [])
        self.assertEqual((self.folder / "game.html").exists(), whole)
        if whole:
            self.assertGreater(len(lcmlog.read(self.folder / "game.lcm")), 100)
            self.assertIsNone(page_data(self.folder / "game.html")["result"]["all_stopped_at"])
        return errors

    def test_a_world_that_stands_still_until_its_robots_leave(self):
        net, launcher, names = self.start_game("--speed", 4)
        os.kill(names["world"], signal.SIGSTOP)
        self.await_robots_gone(launcher)
        os.kill(names["world"], signal.SIGCONT)
        errors = self.check_broken_off(net, launcher, whole=True)
        self.assertEqual(errors.count("its search is not over"), asked.robots, errors)
        self.assertEqual(errors.count(f"(status {BROKEN_OFF})"), asked.robots, errors)
        self.assertRegex(errors, r"quarter: the game was broken off: this world stood still for \d+\.\d s")

    def test_a_world_that_never_goes_on(self):
        net, launcher, names = self.start_game("--speed", 4)
        os.kill(names["world"], signal.SIGSTOP)
        self.check_broken_off(net, launcher, whole=False)

    def test_robots_that_are_all_killed(self):
        net, launcher, names = self.start_game("--speed", 4)
        for number in range(asked.robots):
            os.kill(names[number], signal.SIGKILL)
        errors = self.check_broken_off(net, launcher, whole=True)
        self.assertIn("no robot has answered since", errors)

    def test_no_program_goes_by_the_wall_clock(self):
        """It may be set back or forth while a game runs."""
        wall = re.compile(r"\btime\(|CLOCK_REALTIME|gettimeofday|\bftime\b|clock_get\w+\((?!CLOCK_MONOTONIC)|recv_utime")
        sources = [*(ROOT / "demo").rglob("*.[ch]")]
        self.assertGreater(len(sources), 30)
        self.assertEqual([(path.name, word) for path in sources for word in wall.findall(path.read_text(encoding="utf-8"))], [])

    def test_a_flood_of_messages_holds_up_no_game(self):
        net = self.network()
        launcher = net.start(*demo("--processes", "--json", "--speed", 2, "--seed", 1))
        publisher, listener = net.publisher(), net.listen()
        listener.await_message(lambda _, channel, data: channel == "QUARTER_R0_COMMAND"
                               and COMMAND.decode(data)["utime"] > 1e6, "the game's first second")
        listener.close()  # what comes now is not for it to keep
        word = TERMINATE.encode(utime=1, sender=0, signal=2, territory=15)
        noise = POSE.encode(utime=1, robot=15, x=1.0, y=1.0, heading=0.0)
        while launcher.runs():  # the game's own pace: as fast as this process can send
            publisher.send("QUARTER_TERMINATE", word)
            publisher.send("QUARTER_R15_POSE", noise)
        status, output, errors = launcher.end()
        self.assertEqual((status, errors), (0, ""))
        self.assertIsNotNone(json.loads(output)["result"]["found_at"])

    def test_two_worlds_that_begin_in_the_same_moment_do_not_play_both(self):
        net = self.network()
        both = [net.start(*world("-q")) for _ in range(2)]
        ended = [one.end() for one in both]
        self.assertTrue(any("another world" in errors for _, _, errors in ended), ended)
        self.assertEqual([status for status, _, _ in ended], [2, 2])

    def test_a_robot_reads_its_table_from_a_plain_file_alone(self):
        os.mkfifo(self.folder / "pipe")
        for path, says in ((self.folder / "pipe", "pipe"), ("/dev/zero", "device"), (self.folder, "folder"),
                           (self.folder / "none", "cannot be read")):
            ended = network.Program(program("quarter-robot", path, "--robot", 0)).end()
            self.line(ended, 2, str(path), says)

    def test_a_world_that_is_held_up_for_a_moment_goes_on(self):
        net = self.network()
        held = net.start(*world("-q", "--mine", "none"))
        crew = [net.start(*robot(number)) for number in range(asked.robots)]
        listener = net.listen()
        listener.await_message(lambda _, channel, data: channel == "QUARTER_R0_COMMAND"
                               and COMMAND.decode(data)["utime"] > 1e6, "the game's first second")
        held.send(signal.SIGSTOP)
        os.waitid(os.P_PID, held.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
        moment = max(POSE.decode(data)["utime"] for _, channel, data in list(listener.heard) if channel == "QUARTER_R0_POSE")
        held.send(signal.SIGCONT)
        listener.await_message(lambda _, channel, data: channel == "QUARTER_R0_COMMAND"
                               and COMMAND.decode(data)["utime"] > moment + 1e6, "the second after")
        held.send(signal.SIGINT)
        self.assertEqual(held.end()[0], 130)
        for one in crew:
            one.send(signal.SIGTERM)
            one.end()

    def test_a_robot_whose_world_falls_silent_says_whether_its_search_was_over(self):
        for found, status in ((False, BROKEN_OFF), (True, 0)):
            with self.subTest(found=found), Network() as net:
                publisher, listener = net.publisher(), net.listen()
                one = net.start(*robot(1))
                self.drive(one, publisher, listener, found)
                ended = one.end()
                self.assertEqual((ended[0], ended[1]), (status, ""))
                self.assertEqual("its search is not over" in ended[2], not found, ended[2])

    def drive(self, one, publisher, listener, found):
        """A world that falls silent when the robot has answered, or passed on a find. The find is told before the pose: from
        its first pose on the robot waits 5 s for the next word, and this process may be held up for longer."""
        awaited = "QUARTER_TERMINATE" if found else "QUARTER_R1_COMMAND"

        def answers(source, channel, _):
            return source != publisher.port and channel == awaited
        while one.runs() and not listener.await_message(answers, awaited, seconds=TICK):  # as a world does: every tick
            if found:
                publisher.send("QUARTER_TERMINATE", TERMINATE.encode(utime=1, sender=0, signal=FOUND, territory=0))
            publisher.send("QUARTER_R1_POSE", POSE.encode(utime=1, robot=1, x=2.5, y=2.5, heading=0.0))
            publisher.send("QUARTER_R1_SCAN", SCAN.encode(utime=1, robot=1, read=0, mine=0, range=[1.5] * 24))


# ---- the viewer's port ----

class Served(Case):
    """A viewer's server in a network of its own."""

    def serve(self, *words):
        net = self.network()
        served = net.start(*demo(*words))
        return net, served, int(served.await_line(r"http://127\.0\.0\.1:(\d+)/")[1])

    def connect(self, net, port):
        one = net.socket("tcp")
        one.connect(("127.0.0.1", port))
        return one

    def ask(self, net, port, path="/", method="GET", **fields):
        """(status, {field: value}, body) of an answer that ends; a value None leaves the field out."""
        fields = {"Host": f"localhost:{port}", **{name.replace("_", "-"): value for name, value in fields.items()}}
        lines = [f"{name}: {value}" for name, value in fields.items() if value is not None]
        with self.connect(net, port) as one:
            one.sendall("\r\n".join([f"{method} {path} HTTP/1.1", *lines, "", ""]).encode("latin-1"))
            head, _, body = b"".join(iter(lambda: one.recv(65536), b"")).partition(b"\r\n\r\n")
        first, *rest = head.decode("latin-1").split("\r\n")
        return int(first.split()[1]), dict(line.split(": ", 1) for line in rest), body

    def watch(self, net, port):
        """A viewer's connection, its stream begun."""
        one = self.connect(net, port)
        one.sendall(f"GET /events HTTP/1.1\r\nHost: localhost:{port}\r\n\r\n".encode())
        stream = one.makefile("rb")
        self.assertEqual(stream.readline().split()[1], b"200")
        return one, stream

    def until_event(self, stream, fits):
        """The first event's data that fits(name, data). A server with nothing to tell sends an empty line now and then."""
        name, empty = None, 0
        for line in iter(stream.readline, b""):
            text = line.decode().rstrip("\n")
            empty += text == ":"
            self.assertLess(empty, 5, "nothing comes any more")
            if text.startswith("event: "):
                name = text[7:]
            elif text.startswith("data: ") and fits(name, json.loads(text[6:])):
                return json.loads(text[6:])
        self.fail("the stream ended")


class Doors(Served):
    def test_only_this_machines_own_names_are_answered(self):
        net, _, port = self.serve("--live", "--mine", "none")
        for host in ("localhost", f"localhost:{port}", f"127.0.0.1:{port}", "127.0.0.1", f"[::1]:{port}", "[::1]",
                     "LocalHost:1"):
            self.assertEqual(self.ask(net, port, Host=host)[0], 200, host)
        for host in (None, "", "evil.example", f"evil.example:{port}", "localhost.evil.example", "127.0.0.1.evil.example",
                     "localhost@evil", "127.0.0.2", "0.0.0.0", "[::1", "localhost:", "localhost:x", "localhost:123456",
                     "localhost:80:80", "::1", "localhost."):
            for path in ("/", "/events", "/nothing"):
                status, fields, body = self.ask(net, port, path, Host=host)
                self.assertEqual(status, 421, host)
                self.assertNotIn(b"<html", body)
                self.check_fields(fields)

    def test_a_page_from_elsewhere_gets_nothing(self):
        net, _, port = self.serve("--live", "--mine", "none")
        for origin in ("http://evil.example", f"http://evil.example:{port}", "null", "https://localhost", "file://",
                       "http://localhost.evil.example", f"http://localhost:{port}/", ""):
            for path in ("/", "/events"):
                self.assertEqual(self.ask(net, port, path, Origin=origin)[0], 421, origin)
        for origin in (f"http://localhost:{port}", f"http://127.0.0.1:{port}", f"http://[::1]:{port}"):
            self.assertEqual(self.ask(net, port, Origin=origin)[0], 200, origin)
        status, fields, _ = self.ask(net, port, method="OPTIONS", Origin="http://evil.example",
                                     Access_Control_Request_Method="GET")
        self.assertEqual(status, 421)
        self.assertEqual([name for name in fields if name.lower().startswith("access-control")], [])

    def check_fields(self, fields):
        policy = dict(part.strip().split(" ", 1) for part in fields["Content-Security-Policy"].split(";"))
        self.assertEqual(policy["default-src"], "'none'")
        self.assertEqual(policy["connect-src"], "'self'")
        self.assertEqual(policy["frame-ancestors"], "'none'")
        self.assertEqual(fields["X-Content-Type-Options"], "nosniff")
        self.assertEqual(fields["Referrer-Policy"], "no-referrer")
        self.assertEqual(fields["Cross-Origin-Resource-Policy"], "same-origin")
        self.assertEqual(fields["Cache-Control"], "no-store")

    def test_methods_paths_and_fields(self):
        net, _, port = self.serve("--live", "--mine", "none")
        status, fields, page = self.ask(net, port)
        self.assertEqual((status, fields["Content-Type"]), (200, "text/html; charset=utf-8"))
        self.check_fields(fields)
        self.assertEqual(json.loads(DATA.search(page.decode())[1]), {"live": True})
        self.assertEqual(self.ask(net, port, method="HEAD")[::2], (200, b""))
        for method in ("POST", "PUT", "DELETE", "PROPFIND"):
            self.assertEqual(self.ask(net, port, method=method, Content_Length=0)[0], 405, method)
        for path in ("/nothing", "/../../etc/passwd", "/%2e%2e/etc/passwd", "/events/", "/index.html"):
            status, fields, _ = self.ask(net, port, path)
            self.assertEqual(status, 404, path)
            self.check_fields(fields)
        with self.watch(net, port)[1] as stream:
            head = dict(line.decode().rstrip().split(": ", 1) for line in iter(stream.readline, b"\r\n"))
        self.check_fields(head)
        self.assertEqual(head["Content-Type"], "text/event-stream")


class Crowds(Served):
    def test_connections_that_ask_for_nothing_are_given_up(self):
        net, _, port = self.serve("--live", "--mine", "none")
        idle = [self.connect(net, port) for _ in range(64)]
        self.assertEqual(self.ask(net, port)[0], 200)
        idle[0].sendall(b"GET / HTTP/1.1\r\nHost: loc")  # gone by then, or gone soon
        for one in idle:
            with contextlib.suppress(ConnectionResetError):
                self.assertEqual(one.recv(1), b"")

    def test_who_does_not_read_makes_room_for_who_does(self):
        net, _, port = self.serve("--live", "--mine", "none")
        unread = [self.connect(net, port) for _ in range(3 * VIEWERS)]
        for one in unread:
            one.sendall(b"GET /events HTTP/1.1\r\nHost: localhost\r\n\r\n")
        for _ in range(3):
            one, stream = self.watch(net, port)
            self.until_event(stream, lambda name, _: name == "frame")
        self.assertEqual(self.ask(net, port)[0], 200)

    def test_viewers_that_went_away_while_nothing_happened_take_no_room(self):
        net, served, port = self.serve("--follow")
        for _ in range(3 * VIEWERS):
            self.watch(net, port)[0].close()
        self.assertEqual(self.ask(net, port)[0], 200)
        publisher = net.publisher()
        one, stream = self.watch(net, port)
        for utime in (100_000, 200_000, 400_000):
            publisher.send("QUARTER_R0_POSE", POSE.encode(utime=utime, robot=0, x=1.0, y=1.0, heading=0.0))
        self.until_event(stream, lambda name, _: name == "frame")
        served.send(signal.SIGINT)
        self.assertEqual(served.end()[0], 130)


# ---- what is followed ----

class Followed(Served):
    """A game on the bus that is anything but sound."""

    def begin(self):
        net, served, port = self.serve("--follow", "--robots", asked.robots)
        served.await_line("^Following")
        self.publisher = net.publisher()
        return net, served, port

    def status(self, utime, scanned=-1, state=0, robots=None, found=0):
        robots = asked.robots if robots is None else robots
        self.publisher.send("QUARTER_STATUS", STATUS.encode(
            utime=utime, robots=robots, places=asked.places, mines_found=0, state=[state] * 16,
            scanned_by=[scanned] * 128, found=[found] * 128))

    def pose(self, utime, number=0):
        self.publisher.send(f"QUARTER_R{number}_POSE", POSE.encode(utime=utime, robot=number, x=1.0, y=1.0, heading=0.0))

    def events_at(self, stream, begin):
        """All events that are told until a frame of `begin` seconds or later came. Poses are sent until then."""
        events = []

        def collect(name, data):
            if name != "frame":
                return False
            events.extend(data["events"])
            return data["t"] >= begin
        self.until_event(stream, collect)
        return events

    def catch_up(self, stream, second):
        """Until a frame of that second is shown: no more may be on the way at a time than a socket holds."""
        self.pose(round(1e6 * second))
        self.pose(round(1e6 * second) + 500_000)
        self.until_event(stream, lambda name, data: name == "frame" and abs(data["t"] - second) < 0.01)

    def test_robots_that_cannot_be_are_not_told_of(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        utime = 0
        for scanned in (asked.robots, 15, 16, 127, -2, -128):
            for found in (0, 1, 2, -1):
                utime += 10_000
                self.status(utime, scanned=scanned, found=found, robots=16)
        for state in (-1, 4, 99):
            self.status(utime, state=state)
        for number in range(asked.robots, 16):
            for territory in (0, number, -1, 99):
                self.publisher.send("QUARTER_TERMINATE", TERMINATE.encode(utime=utime, sender=number, signal=2,
                                                                         territory=territory))
        self.status(1_000_000, scanned=1)
        for utime in (2_000_000, 3_000_000):
            self.pose(utime)
        events = self.events_at(stream, 2.0)
        self.assertEqual([(event["kind"], event["robot"]) for event in events], [("scanned", 1)] * asked.places)

    def test_the_events_of_a_game_are_bounded_and_the_last_one_says_so(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for utime in range(1_000_000, 1_000_000 + 4 * EVENTS // asked.places + 40):
            self.status(utime, scanned=-1 if utime % 2 else 0)
            if utime % 30 == 0:
                self.catch_up(stream, utime % 1_000_000 / 30 + 3)
        for utime in (60_000_000, 61_000_000):
            self.pose(utime)
        _, late = self.watch(net, port)
        events = self.events_at(late, 60.0)
        self.assertEqual(len(events), EVENTS)
        self.assertEqual(events[-1]["kind"], "more")
        self.assertEqual({event["kind"] for event in events[:-1]}, {"scanned"})

    def test_a_clock_that_goes_back_begins_another_game_without_the_events_of_the_one_before(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for game in range(200):
            for second in (0, 1, 100):
                self.status(1_000_000 * second, scanned=0 if second else -1)
            if game % 10 == 9:
                self.catch_up(stream, 100 + game)
        self.catch_up(stream, 400)
        _, late = self.watch(net, port)
        self.assertEqual(len(self.events_at(late, 400)), asked.places)
        self.assertEqual(served.runs(), True)

    def test_a_message_that_comes_late_begins_no_other_game(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for utime in (5_000_000, 4_500_000, 5_200_000, 4_300_000, 5_400_000):
            self.status(utime, scanned=2)
        for utime in (6_000_000, 7_000_000):
            self.pose(utime)
        self.assertEqual(len(self.events_at(stream, 6.0)), asked.places)

    def test_frames_go_on_when_the_last_robot_is_lost(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for utime in range(0, 5_000_000, 50_000):
            self.pose(utime, number=0)
        self.until_event(stream, lambda name, data: name == "frame" and data["t"] >= 4.5)


# ---- the command ----

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", required=True, type=lambda text: Path(text).resolve())
    words = parser.parse_known_args(namespace=asked)[1]
    os.environ.pop("LCM_DEFAULT_URL", None)
    prepare()
    unittest.main(argv=[sys.argv[0], *words], testRunner=Runner)


if __name__ == "__main__":
    main()
