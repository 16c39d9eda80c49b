"""test_processes.py --programs FOLDER --lcm FOLDER [unittest's words]: the demo's programs, from outside.

Games over udpm, each in a network of its own, with packets lost, robots killed, strangers on the bus and bad input. The
tests run side by side: a game in real time waits most of the time. What must come soon is counted in messages, in the
order in which they were heard: how fast the machine is does not matter. Writes into the working directory alone.
"""

import argparse
import collections
import concurrent.futures
import contextlib
import http.client
import itertools
import json
import math
import os
import random
import re
import shutil
import signal
import struct
import sys
import threading
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

import lcmlog  # noqa: E402
import network  # noqa: E402
from lcmlog import COMMAND, DONE, FOUND, POSE, SCAN, STATUS, TERMINATE  # noqa: E402
from network import Network, Wire, await_file  # noqa: E402
from scripted_world import ScriptedWorld  # noqa: E402
from side_by_side import Runner  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent
MISSIONS = ROOT / "demo" / "missions"
MISSION = MISSIONS / "minefield" / "mission.yaml"
TICK = 0.05
LINE = re.compile(r'<script id="replay" type="application/json">(.*?)</script>', re.DOTALL)

asked = argparse.Namespace()  # the command line, and what prepare() made


def demo(*words):
    return asked.programs / "quarter-demo", MISSION, "--table", asked.table, *words


def world(*words):
    return asked.programs / "quarter-world", MISSION, "--table", asked.table, *words


def robot(number, *words):
    return asked.programs / "quarter-robot", asked.table, "--robot", number, *words


def page_data(path):
    return json.loads(LINE.search(Path(path).read_text(encoding="utf-8"))[1])


def prepare():
    """One table for all tests, what it plans, and the places that it reaches soon."""
    folder = Path("prepared").resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    asked.table = folder / "mission.qtr"
    status, _, errors = network.Program(
        [asked.programs / "quarter-demo", MISSION, "--learn-limit", 2, "--save-table", asked.table, "--mine", "none",
         "-o", folder / "plan.html", "--quiet"]).end()
    assert status == 0, errors
    asked.plan = page_data(folder / "plan.html")
    planned = sorted((place["planned"], number) for number, place in enumerate(asked.plan["places"])
                     if place["planned"] is not None)
    asked.soon = [number for seconds, number in planned if seconds < 20]  # the soonest first
    assert len(asked.soon) >= 2, planned


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.id().rpartition(".")[2]).resolve()
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()

    def network(self, **options):
        return self.enterContext(Network(**options))

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
            if kind is COMMAND and (message["left"] or message["right"]):
                stands_since.pop(number, None)
            elif kind is COMMAND:
                stands_since.setdefault(number, time / 1e6)
        for ticks in poses.values():
            self.assertEqual(sorted(set(ticks)), list(range(ticks[-1] + 1)))
        self.assertEqual(mine_seen[:1], [game["result"]["found_at"]] if game["result"]["found_at"] is not None else [])
        self.assertEqual(len(stands_since), game["robots"])
        return max(stands_since.values())


# ---- games ----

def is_found(channel, data):
    return channel == "QUARTER_TERMINATE" and TERMINATE.decode(data)["signal"] == FOUND


class Games(Case):
    TOLD, OVERTAKEN = 5, 3

    def check_all_stop(self, path, robots):
        """Who was told TOLD times that it is found drives no more.

        All programs of a network hear the same packets, so a log has what every robot heard, in the order in which it
        did: a pose that comes after FOUND is answered by an order to stand, however late. A few poses may have overtaken
        it on another processor. There is no chance in this, whatever share is lost: a lost packet is lost for all.
        """
        events = lcmlog.read(path)
        told = [index for index, (_, channel, data) in enumerate(events) if is_found(channel, data)]
        self.assertGreater(len(told), self.TOLD)
        after = events[told[self.TOLD - 1] + 1:]
        for robot in range(robots):
            poses = [time for time, channel, _ in after if channel == f"QUARTER_R{robot}_POSE"]
            orders = [COMMAND.decode(data) for _, channel, data in after if channel == f"QUARTER_R{robot}_COMMAND"]
            late = [order for order in orders if len(poses) > self.OVERTAKEN and order["utime"] >= poses[self.OVERTAKEN]]
            self.assertTrue(orders)
            self.assertEqual([order for order in late if order["left"] or order["right"]], [], f"robot {robot}")

    def play_all(self, loss, seeds, *words):
        """A game for each seed, side by side, the mine at each of the near places in turn.

        With 60 % lost: a robot over the mine has its sensor read in a tick if its order and the scan come through, 0.16,
        and stays until it has; of the rest of the game's time limit, 2000 ticks and more, 1 in 0.84 ** -2000 has none.
        All that must come through at all is repeated as often.
        """
        network.need_network(loss > 0)

        def play(seed):
            with Network(loss=loss) as net:
                mine = asked.soon[seed % len(asked.soon)]
                game, errors = self.play(net, "--seed", seed, "--mine", mine, *words, name=f"seed{seed}")
            self.assertEqual(errors, "")
            self.assertEqual(game["mine"], mine)
            self.assertIsNotNone(game["result"]["found_at"], game)
            self.assertIsNotNone(game["result"]["all_stopped_at"], game)
            log = self.folder / f"seed{seed}.lcm"
            sent = self.check_messages(log, game)
            self.check_all_stop(log, game["robots"])
            if loss > 0:
                self.assertLess(sent["pose"], game["result"]["messages"]["pose"])
            else:  # the world hears an order no sooner than it is given
                self.assertLessEqual(self.check_story(log, game), game["result"]["all_stopped_at"] + 1e-9)
        with concurrent.futures.ThreadPoolExecutor(len(seeds)) as pool:
            list(pool.map(play, seeds))

    def test_all_stop_once_it_is_found(self):
        self.play_all(0, [1, 2, 3])

    def test_all_stop_with_30_percent_of_packets_lost(self):
        self.play_all(30, [1, 2, 3])

    def test_all_stop_with_60_percent_of_packets_lost(self):
        self.play_all(60, [1, 2, 3], "--speed", 2)

    def test_logs_of_games_in_one_process(self):
        for mission in ("minefield", "site", "turtlebot3_world", "warehouse"):
            for mode in ([], ["--clear-all"], ["--mine", "none"]):
                with self.subTest(mission=mission, mode=mode):
                    log = self.folder / f"{mission}.lcm"
                    status, output, errors = network.Program(
                        [asked.programs / "quarter-demo", MISSIONS / mission / "mission.yaml", "--learn-limit", 1,
                         "--json", "--log", log, *mode]).end()
                    self.assertEqual((status, errors), (0, ""))
                    game = json.loads(output)
                    self.assertEqual(game["result"]["found_at"] is None, mode[-1:] == ["none"])
                    sent = self.check_messages(log, game)
                    for kind in ("pose", "scan"):
                        self.assertEqual(sent[kind], game["result"]["messages"][kind])
                    self.assertAlmostEqual(self.check_story(log, game), game["result"]["all_stopped_at"])


# ---- one robot alone ----

class RobotAlone(Case):
    NUMBER = 1

    def begin(self):
        net = self.network()
        scripted = ScriptedWorld(asked.plan, self.NUMBER, net)
        wire = Wire(net)
        scripted.start(*robot(self.NUMBER))
        return scripted, wire

    def check_wire(self, scripted, wire):
        wire.close()
        own = {kind for source, kind in wire.seen if source != scripted.publisher.port}
        self.assertLessEqual(own - {"LCM_SELF_TEST"}, {f"QUARTER_R{self.NUMBER}_COMMAND", "QUARTER_TERMINATE"})
        self.assertIn(f"QUARTER_R{self.NUMBER}_COMMAND", own)

    def check_handles(self, pid):
        """Sockets and pipes, no file; what faketime opens in every program to tell it another date is not the robot's."""
        handles = [os.readlink(handle) for handle in Path(f"/proc/{pid}/fd").iterdir() if int(handle.name) > 2]
        allowed = ("socket:", "pipe:", "anon_inode:", "/dev/shm/faketime")
        files = [handle for handle in handles if not handle.startswith(allowed)]
        self.assertEqual(files, [])

    def test_it_sweeps_everything_and_says_only_its_own_command_and_terminate(self):
        scripted, wire = self.begin()
        self.check_handles(scripted.program.pid)
        stood = 0
        while stood < 20 and scripted.utime < 1000e6:
            if scripted.utime % 500_000 == 0:
                scripted.distract()
            stood = stood + 1 if scripted.stands(scripted.tick()) else 0
        self.assertEqual(sorted(scripted.scanned), list(range(len(scripted.places))))
        places = asked.plan["places"]
        own = [place for place in scripted.scanned if places[place]["territory"] == self.NUMBER]
        self.assertEqual(own, sorted(own, key=lambda place: places[place]["planned"]))
        self.assertEqual({(sender, signal) for sender, signal, _ in scripted.said}, {(self.NUMBER, DONE)})
        self.assertIn((self.NUMBER, DONE, self.NUMBER), scripted.said)
        self.assertEqual(scripted.program.end()[0], 0)  # the world is silent: it is over
        self.check_wire(scripted, wire)

    def test_it_stops_and_says_so_when_its_sensor_sees_the_mine(self):
        scripted, wire = self.begin()
        while not scripted.scanned:
            scripted.tick(mine=True)
            self.assertLess(scripted.utime, 200e6, "it never reads its sensor")
        while not scripted.stands(scripted.tick(mine=True)):
            self.assertEqual(len(scripted.scanned), 1)
            self.assertLess(scripted.utime, 200e6)
        for _ in range(10):
            self.assertTrue(scripted.stands(scripted.tick()))
        self.assertEqual(scripted.said, {(self.NUMBER, FOUND, 0)})
        self.check_wire(scripted, wire)

    def test_it_stops_at_once_when_another_has_found_it_and_passes_that_on(self):
        scripted, wire = self.begin()
        while scripted.stands(scripted.tick()):
            self.assertLess(scripted.utime, 10e6, "it does not drive")
        scripted.tell(FOUND)
        self.assertTrue(scripted.stands(scripted.tick()))
        for _ in range(10):
            self.assertTrue(scripted.stands(scripted.tick()))
        self.assertEqual(scripted.said, {(self.NUMBER, FOUND, 0)})
        self.check_wire(scripted, wire)


# ---- bad input ----

class BadInput(Case):
    def refuse(self, words, *says, status=2, net=None):
        """Ends with this status and one line that says these; writes nothing."""
        before = sorted(self.folder.iterdir())
        program = net.start(*words, cwd=self.folder) if net else network.Program(words, cwd=self.folder)
        ended, output, errors = program.end()
        self.assertEqual(ended, status, errors)
        self.assertEqual(output, "")
        lines = errors.splitlines()
        if net is not None:  # LCM's own complaints stand before it
            lines = [line for line in lines if line.startswith("quarter")]
        self.assertEqual(len(lines), 1, errors)
        self.assertRegex(lines[0], r"^quarter(-robot)?: ")
        for words_said in says:
            self.assertIn(words_said, lines[0])
        self.assertEqual(sorted(self.folder.iterdir()), before)

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def test_command_lines(self):
        demo_program, world_program = asked.programs / "quarter-demo", asked.programs / "quarter-world"
        outputs = "-o", "page.html", "--log", "game.lcm", "--json=out.json", "--save-table", "out.qtr"
        for words, says in (
                ([demo_program], ["mission"]),
                ([demo_program, "nowhere.yaml", *outputs], ["nowhere.yaml"]),
                ([*demo("--runs", 3, "-o", "page.html")], ["--runs", "-o"]),
                ([*demo("--runs", 3, "--log", "game.lcm")], ["--runs", "--log"]),
                ([*demo("--runs", 3, "--processes")], ["--runs", "--processes"]),
                ([*demo("--processes", "--live")], ["--live", "--processes"]),
                ([*demo("--processes", "--strategy", "nearest")], ["--strategy"]),
                ([*demo("--mine", 4000, *outputs)], ["--mine"]),
                ([*demo("--mine", len(asked.plan["places"]), "-o", "page.html", "--log", "game.lcm")], ["--mine"]),
                ([*demo("--seed", "-1", *outputs)], ["--seed"]),
                ([*demo("--speed", "nan", *outputs)], ["--speed"]),
                ([*demo("--nonsense", *outputs)], ["--nonsense"]),
                ([*demo("--log", "no/such/folder.lcm")], ["no/such/folder.lcm"]),
                ([*demo("-o", "no/such/folder.html")], ["no/such/folder.html"]),
                ([world_program], ["mission"]),
                ([*world("--seed", "x")], ["--seed"])):
            with self.subTest(words=[str(word) for word in words[1:]]):
                self.refuse(words, *says)
        for words in ([], [asked.table], [asked.table, "--robot", "-1"], [asked.table, "--robot", "x"]):
            status, output, errors = network.Program([asked.programs / "quarter-robot", *words]).end()
            self.assertEqual((status, output), (2, ""))
            self.assertIn("--robot N", errors)
        self.refuse(robot(len(asked.plan["starts"])), "--robot")

    def test_tables(self):
        other = MISSIONS / "warehouse" / "mission.yaml"
        whole = asked.table.read_bytes()
        outputs = "-o", "page.html", "--log", "game.lcm"
        for program in ("quarter-demo", "quarter-world"):
            self.refuse([asked.programs / program, other, "--table", asked.table, *outputs], "mission.qtr", "not of")
            self.refuse([asked.programs / program, MISSION, "--table", "none.qtr", *outputs], "none.qtr")
        self.refuse([asked.programs / "quarter-demo", other, "--table", asked.table, "--processes", *outputs], "not of")
        self.refuse([asked.programs / "quarter-robot", "none.qtr", "--robot", "0"], "none.qtr")
        for size in sorted({0, 1, 7, 8, 63, 64, len(whole) // 2, len(whole) - 1}):
            table = self.file("part.qtr", whole[:size])
            for program in ("quarter-demo", "quarter-world"):
                self.refuse([asked.programs / program, MISSION, "--table", table, *outputs], "part.qtr")
            self.refuse([asked.programs / "quarter-robot", table, "--robot", "0"], "part.qtr")
        forged = Path(__file__).resolve().parents[1] / "data" / "forged" / "walled-off.qtr"
        for program in ("quarter-demo", "quarter-world"):
            self.refuse([asked.programs / program, MISSION, "--table", forged, *outputs], "walled-off.qtr", "no way")
        self.refuse([asked.programs / "quarter-robot", forged, "--robot", "0"], "walled-off.qtr", "no way")

    def test_faults(self):
        for text, says in (("faults: [{at: 3, lost: 9}]", "9"), ("faults: [{at: 3}]", "lost"), ("faults: 7", "list"),
                           ("faults: [{at: x, lost: 1}]", "at"), ("faults: [{at: 1, loss: 2.0}]", "loss"),
                           ("faults: [{at: 1, lots: 2}]", "lots"), ("faults: [", "faults.yaml"), ("", "faults")):
            path = self.file("faults.yaml", text.encode())
            with self.subTest(text=text):
                outputs = "-o", "page.html", "--log", "game.lcm"
                for words in (demo("--faults", path, *outputs), demo("--faults", path, "--processes", *outputs),
                              world("--faults", path, *outputs)):
                    self.refuse(words, "faults.yaml", says)
        self.refuse(demo("--faults", "none.yaml"), "none.yaml")

    def test_a_bus_that_cannot_be_opened(self):
        commands = "ip link set lo multicast on", "ip route add 224.0.0.0/4 dev lo"
        net = self.network()
        for url in ("nonsense://there", "udpm://nowhere", "tcpq://127.0.0.1:1", "file:///no/such/folder.lcm?mode=r"):
            with self.subTest(url=url):
                self.refuse(robot(0, "--lcm-url", url), url, *commands, net=net)
                self.refuse(world("--lcm-url", url, "-o", "page.html", "--log", "game.lcm"), url, *commands, net=net)

    def test_no_multicast_route(self):
        commands = "ip link set lo multicast on", "ip route add 224.0.0.0/4 dev lo"
        net = self.network(multicast=False)
        self.refuse(robot(0), *commands, net=net)
        self.refuse(world("-o", "page.html", "--log", "game.lcm"), *commands, net=net)
        status, _, errors = net.run(*demo("--processes", "-o", "page.html", "--log", "game.lcm"), cwd=self.folder)
        self.assertEqual(status, 2)
        for command in commands:
            self.assertIn(command, errors)
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertEqual(net.inhabitants(), [])

    def test_a_robot_without_a_world(self):
        net = self.network()
        self.refuse(robot(0), "start quarter-world", status=3, net=net)

    def test_a_world_without_its_robots_and_a_second_world(self):
        net = self.network()
        first = net.start(*world("-o", "page.html"), cwd=self.folder)
        one = net.start(*robot(0))
        net.listen().await_message(lambda _, channel, data: channel == "QUARTER_R0_COMMAND", "a command")
        self.refuse(world("-o", "page.html", "--log", "game.lcm"), "another world", net=net)
        status, output, errors = first.end()
        self.assertEqual((status, output, len(errors.splitlines())), (2, "", 1), errors)
        self.assertIn("robot 1", errors)
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertEqual(one.end()[0], 3)


# ---- strangers on the bus ----

class Strangers(Case):
    def channels(self):
        return ["QUARTER_TERMINATE", "QUARTER_STATUS"] + [f"QUARTER_R{number}_{kind}" for number in range(5)
                                                         for kind in ("POSE", "SCAN", "COMMAND")]

    def unsound(self, dice):
        """Messages that decode, and say what cannot be."""
        number = dice.randrange(4)
        bad = dice.choice([math.nan, math.inf, -math.inf])
        far = dice.choice([-1, 16, 99, -2**31, 2**31 - 1])
        signal_number = dice.choice([0, 3, -1, 2**31 - 1])
        at = {"utime": dice.choice([0, -1, 2**63 - 1])}
        return dice.choice([
            (f"QUARTER_R{number}_POSE", POSE.encode(robot=number, x=bad, y=0.0, heading=0.0, **at)),
            (f"QUARTER_R{number}_POSE", POSE.encode(robot=far, x=1.0, y=0.0, heading=0.0, **at)),
            (f"QUARTER_R{number}_SCAN", SCAN.encode(robot=number, read=1, mine=1, range=[bad] * 24, **at)),
            (f"QUARTER_R{number}_SCAN", SCAN.encode(robot=number, read=1, mine=1, range=[-1.0] * 24, **at)),
            (f"QUARTER_R{number}_COMMAND", COMMAND.encode(robot=number, left=bad, right=0.0, read=1, **at)),
            (f"QUARTER_R{number}_COMMAND", COMMAND.encode(robot=far, left=1.0, right=0.0, read=1, **at)),
            ("QUARTER_TERMINATE", TERMINATE.encode(sender=far, signal=FOUND, territory=0, **at)),
            ("QUARTER_TERMINATE", TERMINATE.encode(sender=number, signal=signal_number, territory=0, **at)),
            ("QUARTER_TERMINATE", TERMINATE.encode(sender=number, signal=DONE, territory=far, **at))])

    def cut(self, dice):
        """A sound message's first bytes, or with more behind them, or with its mark alone."""
        channel = dice.choice(self.channels())
        kind, _ = lcmlog.type_of(channel)
        mark = struct.pack(">Q", kind.mark)
        size = dice.choice([0, 8, kind.layout.size - 9, dice.randrange(kind.layout.size - 8)])
        return channel, mark + dice.randbytes(size)

    def disturb(self, net, over):
        """Many strange messages for each pose of the game's, until it is over."""
        publisher, listener = net.publisher(), net.listen()
        dice = random.Random(7)
        at = 0

        def is_pose(source, channel, _):
            return channel == "QUARTER_R0_POSE" and source != publisher.port or over.is_set()
        while not over.is_set():
            (_, _, _), at = listener.await_message(is_pose, "a pose", begin=at)
            at += 1
            self.volley(publisher, dice)

    def volley(self, publisher, dice):
        for _ in range(8):
            noise = dice.randbytes(dice.choice([0, 1, 4, 7, 8, 9, 16, 28, 36, 44, 117, 300, dice.randrange(1400)]))
            publisher.send(dice.choice(self.channels()), noise)
            publisher.send(*self.unsound(dice))
            publisher.send(*self.cut(dice))
            publisher.send_raw(noise)
            # A name without an end, and a part of a message of many packets.
            publisher.send_raw(struct.pack(">II", network.SHORT, 0) + noise.replace(b"\0", b"x"))
            head = (0x4C433033, dice.randrange(9), dice.choice([0, 5000, 2**32 - 1]), dice.choice([0, 1400, 2**31]),
                    dice.randrange(4), dice.randrange(5))
            publisher.send_raw(struct.pack(">IIIIHH", *head) + noise)

    def test_malformed_messages_change_nothing(self):
        net = self.network()
        over = threading.Event()
        thread = threading.Thread(target=self.disturb, args=(net, over), daemon=True)
        thread.start()
        try:
            mine = asked.soon[0]
            game, _ = self.play(net, "--mine", mine)
        finally:
            over.set()
            net.publisher().send("OTHER", b"it is over")  # for who waits for the next message
            thread.join()
        self.assertIsNotNone(game["result"]["found_at"], game)
        self.assertIsNotNone(game["result"]["all_stopped_at"], game)
        self.assertGreater(game["result"]["messages"]["ignored"], 0)  # thousands, but fewer where the game outruns them
        lcmlog.read(self.folder / "game.lcm")
        self.assertEqual(page_data(self.folder / "game.html")["result"], game["result"])

    def test_a_second_game_on_the_bus_is_refused_and_the_first_ends_as_it_should(self):
        net = self.network()
        first = net.start(*demo("--processes", "--json", "--mine", asked.soon[-1]), cwd=self.folder)
        net.listen().await_message(
            lambda _, channel, data: channel == "QUARTER_R0_POSE" and POSE.decode(data)["utime"] > 1e6,
            "the game's first second")
        status, _, errors = net.run(*demo("--processes", "-o", "page.html", "--log", "game.lcm"), cwd=self.folder)
        self.assertEqual(status, 2)
        self.assertIn("another world", errors)
        self.assertEqual(list(self.folder.iterdir()), [])
        status, output, errors = first.end()
        self.assertEqual((status, errors), (0, ""))
        self.assertIsNotNone(json.loads(output)["result"]["all_stopped_at"])
        self.assertEqual(net.inhabitants(), [])


# ---- LCM's own tools ----

class LcmTools(Case):
    def start_tool(self, net, name, *words):
        environment = os.environ | {"LD_LIBRARY_PATH": str(asked.lcm.parent / "lib")}
        return net.start(asked.lcm / name, *words, env=environment)

    def test_lcm_logger_beside_a_game_hears_the_same_signals(self):
        net = self.network()
        path = self.folder / "beside.lcm"
        listener = net.listen()
        logger = self.start_tool(net, "lcm-logger", "--quiet", "--flush-interval=1", "--lcm-url", network.URL, path)
        listener.await_members(1)
        log = self.folder / "game.lcm"
        status, _, errors = net.run(*demo("--processes", "--json", "--mine", asked.soon[0], "--log", log))
        self.assertEqual(status, 0, errors)
        said = self.signals(lcmlog.read(log))
        # The logger writes when something comes, and what waits it would drop at the end.
        publisher = net.publisher()
        await_file(path, lambda: said <= self.signals(lcmlog.read_so_far(path)),
                   nudge=lambda: publisher.send("OTHER", b"more"))
        logger.send(signal.SIGINT)
        logger.end()
        self.assertEqual(self.signals(lcmlog.read(path)), said)
        self.assertEqual({(sender, number) for sender, number, _ in said if number == FOUND},
                         {(sender, FOUND) for sender in range(asked.plan["robots"])})

    def signals(self, events):
        """Who said what: each says it again and again, so that no copy matters."""
        said = [TERMINATE.decode(data) for _, channel, data in events if channel == "QUARTER_TERMINATE"]
        return {(message["sender"], message["signal"], message["territory"]) for message in said}

    def test_lcm_logplayer_plays_a_log_into_the_bus(self):
        net = self.network()
        log = self.folder / "game.lcm"
        self.assertEqual(network.Program([*demo("--mine", asked.soon[0], "--log", log, "--quiet")]).end()[0], 0)
        listener = net.listen()
        player = self.start_tool(net, "lcm-logplayer", "--speed=10", f"--lcm-url={network.URL}", log)
        status, _, errors = player.end()
        self.assertEqual(status, 0, errors)
        played = collections.Counter((channel, data) for _, channel, data in lcmlog.read(log))
        listener.await_that(lambda: sum(played.values()) <= len(self.ours(listener)), "all that was played")
        self.assertEqual(collections.Counter(self.ours(listener)), played)

    def ours(self, listener):
        return [(channel, data) for _, channel, data in list(listener.heard) if channel.startswith("QUARTER_")]


# ---- ends before the end ----

class Ends(Case):
    def start_game(self, net, *words, after=2.0):
        """A game in processes, `after` so many of its seconds: (launcher, its children by process id, listener)."""
        launcher = net.start(*demo("--processes", "--json", "--log", self.folder / "game.lcm", "-o",
                                   self.folder / "game.html", *words))
        listener = net.listen()
        robots = len(asked.plan["starts"])
        for number in range(robots):
            def commands(_, channel, data, wanted=f"QUARTER_R{number}_COMMAND"):
                return channel == wanted and COMMAND.decode(data)["utime"] > after * 1e6
            listener.await_message(commands, f"a command of robot {number}'s")
        children = launcher.children()
        self.assertEqual(len(children), robots + 1, children)
        return launcher, children, listener

    def robot_of(self, children, number):
        return next(pid for pid, words in children.items() if words[0] == "quarter-robot" and
                    words[words.index("--robot") + 1] == str(number))

    def check_gone(self, net, children):
        self.assertEqual(net.inhabitants(), [])
        self.assertEqual([pid for pid in children if Path(f"/proc/{pid}").exists()], [])
        tables = {words[1] for words in children.values() if words[0] == "quarter-robot"}
        self.assertEqual([path for path in tables if Path(path).exists()], [])

    def check_records(self, game):
        events = lcmlog.read(self.folder / "game.lcm")
        page = page_data(self.folder / "game.html")
        self.assertEqual(page["result"], game["result"])
        self.assertEqual(page["duration"], game["duration"])
        self.assertLess(max(time for time, channel, _ in events if channel.endswith("POSE")) / 1e6, game["duration"])

    def test_interrupt_of_a_game_in_processes(self):
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number=number), Network() as net:
                launcher, children, _ = self.start_game(net, "--mine", "none")
                launcher.send(number)
                ended, output, errors = launcher.end()
                self.assertEqual((ended, errors), (status, ""))
                self.check_gone(net, children)
                self.check_records(json.loads(output))

    def test_interrupt_before_the_game_begins(self):
        net = self.network()
        robots = len(asked.plan["starts"])
        for there in (1, robots, robots + 1):  # so many of its programs are on the bus
            listener = net.listen()
            launcher = net.start(*demo("--processes", "--quiet", "-o", self.folder / "game.html"))
            listener.await_members(there)
            children = launcher.children()
            launcher.send(signal.SIGINT)
            status, _, errors = launcher.end()
            self.assertEqual((status, errors), (130, ""))
            self.check_gone(net, children)
        net.start(*robot(0))
        alone = net.start(*world("--quiet"))
        net.listen().await_message(lambda _, channel, data: channel == "QUARTER_R0_COMMAND", "a command")
        alone.send(signal.SIGINT)
        self.assertEqual(alone.end(), (130, "", ""))

    def test_interrupt_of_a_game_in_one_process(self):
        log = self.folder / "game.lcm"
        program = network.Program(
            demo("--speed", 1, "--mine", "none", "--json", "--log", log, "-o", self.folder / "game.html"))
        await_file(log, lambda: log.exists() and log.stat().st_size > 20000)
        program.send(signal.SIGINT)
        status, output, errors = program.end()
        self.assertEqual((status, errors), (130, ""))
        self.check_records(json.loads(output))

    def test_a_robot_killed_is_replaced_by_the_others(self):
        net = self.network()
        mine = asked.soon[-1]  # long enough after the killing
        victim = asked.plan["places"][mine]["territory"]
        launcher, children, listener = self.start_game(net, "--mine", mine, "--speed", 4)
        os.kill(self.robot_of(children, victim), signal.SIGKILL)
        status, output, errors = launcher.end()
        self.assertEqual(status, 0, errors)
        self.assertEqual(errors, f"quarter-demo: robot {victim}'s process ended (signal 9)\n")
        self.check_gone(net, children)
        game = json.loads(output)
        self.check_records(game)
        result = game["result"]
        self.assertIsNotNone(result["found_at"], game)
        self.assertGreater(result["found_at"], result["planned_at"])
        last = {}
        for _, channel, data in lcmlog.read(self.folder / "game.lcm"):
            if channel.endswith("COMMAND"):
                last[channel] = COMMAND.decode(data)
        dead = last.pop(f"QUARTER_R{victim}_COMMAND")
        self.assertLess(dead["utime"] / 1e6, result["planned_at"])
        self.assertEqual({(command["left"], command["right"]) for command in last.values()}, {(0.0, 0.0)})
        self.assertLess(game["duration"] - result["found_at"], 30, "the survivors stopped, but the game goes on")

    def test_the_world_killed(self):
        net = self.network()
        launcher, children, _ = self.start_game(net, "--mine", "none", after=0.5)
        os.kill(next(pid for pid, words in children.items() if words[0] == "quarter-world"), signal.SIGKILL)
        status, output, errors = launcher.end()
        self.assertEqual((status, output), (3, ""))
        self.assertEqual(len(errors.splitlines()), 1, errors)
        self.check_gone(net, children)
        self.assertFalse((self.folder / "game.html").exists())


# ---- the live view ----

class Live(Case):
    def start_live(self, *words):
        net = self.network()
        program = net.start(*demo("--live", "--json", "-o", self.folder / "game.html", *words))
        return net, program, int(program.await_line(r"http://127\.0\.0\.1:(\d+)/")[1])

    def get(self, net, port, path):
        one = net.socket("tcp")
        one.connect(("127.0.0.1", port))
        connection = http.client.HTTPConnection("127.0.0.1", port)
        connection.sock = one
        connection.request("GET", path)
        return connection.getresponse()

    def events(self, response):
        """(name, data) of each event until the stream ends."""
        name = None
        for line in iter(response.readline, b""):
            text = line.decode().rstrip("\n")
            if text.startswith("event: "):
                name = text[7:]
            elif text.startswith("data: "):
                yield name, json.loads(text[6:])

    def check_stream(self, events):
        self.assertEqual(events[0][0], "hello")
        self.assertEqual(events[-1][0], "end")
        self.assertEqual({name for name, _ in events[1:-1]}, {"frame"})
        frames = [data for name, data in events if name == "frame"]
        times = [frame["t"] for frame in frames]
        self.assertEqual(times, sorted(times))
        self.assertEqual(len(set(times[:-1])), len(times) - 1)  # the last one is of the end, at whatever time
        self.assertEqual({len(frame["robots"]) for frame in frames}, {len(asked.plan["starts"])})
        return list(itertools.chain(*(frame["events"] for frame in frames)))

    def test_the_page_the_stream_and_nobody_from_elsewhere(self):
        net, program, port = self.start_live("--speed", 2, "--mine", asked.soon[-1])
        for host in (network.OTHER_ADDRESS, "127.0.0.2"):
            with self.assertRaises(ConnectionRefusedError):
                net.socket("tcp").connect((host, port))
        page = self.get(net, port, "/")
        self.assertEqual((page.status, page.headers.get_content_type()), (200, "text/html"))
        self.assertEqual(json.loads(LINE.search(page.read().decode())[1]), {"live": True})
        self.assertEqual(self.get(net, port, "/nothing").status, 404)
        response = self.get(net, port, "/events")
        self.assertEqual((response.status, response.headers.get_content_type()), (200, "text/event-stream"))
        stream = self.events(response)
        seen = [next(stream) for _ in range(10)]  # of some hundreds
        late = self.get(net, port, "/events")
        seen += list(stream)
        late_seen = list(self.events(late))
        status, output, _ = program.end()
        self.assertEqual(status, 0)
        game = json.loads(output)
        replay = page_data(self.folder / "game.html")
        for events in (seen, late_seen):
            self.assertEqual(self.check_stream(events), replay["events"])
            self.assertEqual(events[-1][1], {"result": game["result"], "duration": game["duration"]})
        self.assertEqual(seen[0][1]["live"], True)
        self.assertEqual(seen[0][1], late_seen[0][1])
        self.assertEqual({key: seen[0][1][key] for key in ("map", "places", "routes", "plan")},
                         {key: replay[key] for key in ("map", "places", "routes", "plan")})

    def test_interrupt_while_somebody_watches(self):
        net, program, port = self.start_live("--mine", "none")
        stream = self.events(self.get(net, port, "/events"))
        seen = [next(stream) for _ in range(5)]
        program.send(signal.SIGINT)
        seen += list(stream)
        status, output, _ = program.end()
        self.assertEqual(status, 130)
        self.check_stream(seen)
        self.assertEqual(page_data(self.folder / "game.html")["result"], json.loads(output)["result"])

    def test_interrupt_while_nobody_watches_yet(self):
        net, program, port = self.start_live()
        program.send(signal.SIGINT)
        self.assertEqual(program.end()[0], 130)
        page_data(self.folder / "game.html")


# ---- the command ----

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", required=True, type=lambda text: Path(text).resolve())
    parser.add_argument("--lcm", required=True, type=lambda text: Path(text).resolve())
    words = parser.parse_known_args(namespace=asked)[1]
    os.environ.pop("LCM_DEFAULT_URL", None)
    prepare()
    unittest.main(argv=[sys.argv[0], *words], testRunner=Runner)


if __name__ == "__main__":
    main()
