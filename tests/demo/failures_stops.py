"""Worlds and robots that stop, fall silent, or are held up."""

import json
import os
import re
import signal
import zlib

import lcmlog
import network
from lcmlog import COMMAND, FOUND, POSE, SCAN
from network import Network
from programs import ROOT, TICK, Case, asked, demo, identity_of, page_data, program, robot, terminate, world

BROKEN_OFF = 3  # exit status


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

    def learn_small(self):
        """A mission of three places that one robot sweeps in seconds, and its table."""
        mission, table = self.folder / "small.txt", self.folder / "small.qtr"
        mission.write_text("S.1\nS.1\nS.1\n", encoding="utf-8")
        learnt = network.Program(program("quarter-demo", mission, "--save-table", table, "--mine", "none", "-q")).end()
        self.assertEqual(learnt, (0, "", ""))
        return mission, table

    def other_table(self, path):
        """The same division by the same plan, in a table of another seed."""
        table = bytearray(path.read_bytes())
        identity = identity_of(bytes(table))
        table[48] ^= 1
        size = int.from_bytes(table[8:12], "little")  # of the part that robots read
        table[12:16] = zlib.crc32(table[16:size]).to_bytes(4, "little")
        self.assertNotEqual(identity_of(bytes(table)), identity)
        other = self.folder / "other.qtr"
        other.write_bytes(table)
        return other

    def test_a_robot_of_another_table_or_run_is_not_believed_and_the_game_says_so(self):
        mission, table = self.learn_small()
        other = self.other_table(table)
        for number, words in ((1, (table, "--run-number", 7)), (2, (other,))):
            with self.subTest(number=number), Network() as net:
                game = net.start(*program("quarter-world", mission, "--table", table, "--mine", "none", "--speed", 4))
                crew = [net.start(*program("quarter-robot", *(words if one == number else (table,)), "--robot", one))
                        for one in range(3)]
                status, output, errors = game.end()
                self.assertEqual((status, output), (BROKEN_OFF, ""))
                self.assertIn(f"robot {number} plays another table", errors)
                for one, ended in enumerate(each.end() for each in crew):
                    self.assertEqual(ended[0], 0, ended)
                    self.assertIn("of another table, other starts or another run ignored", ended[2], (one, ended))

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
        word = terminate(utime=1, sender=0, signal=2, territory=15)
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
                           (self.folder / "none", "no such file")):
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
                publisher.send("QUARTER_TERMINATE", terminate(utime=1, sender=0, signal=FOUND))
            publisher.send("QUARTER_R1_POSE", POSE.encode(utime=1, robot=1, x=2.5, y=2.5, heading=0.0))
            publisher.send("QUARTER_R1_SCAN", SCAN.encode(utime=1, robot=1, read=0, mine=0, range=[1.5] * 24))
