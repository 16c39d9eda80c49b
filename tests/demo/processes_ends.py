"""Games that are ended before their end."""

import json
import os
import signal
from pathlib import Path

import lcmlog
import network
from lcmlog import COMMAND
from network import Network, await_file
from programs import Case, asked, demo, page_data, program, robot, world


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
        self.assertEqual([path for path in self.own_folders(children) if path.exists()], [])

    def own_folders(self, children):
        """Of the game: one."""
        return {Path(words[1]).parent for words in children.values() if words[0] == "quarter-robot"}

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

    def test_robots_whose_power_fails_go_on_from_their_saves(self):
        net = self.network()
        script = self.folder / "faults.yaml"
        resets = ", ".join(f"{{at: {2 + number}, reset: {number}, for: 1.5}}" for number in range(asked.robots))
        script.write_text(f"faults: [{resets}]\n", encoding="utf-8")
        game, errors = self.play(net, "--mine", asked.soon[-1], "--speed", 2, "--faults", script)
        self.assertEqual(errors, "")
        self.assertIsNotNone(game["result"]["found_at"], game)
        self.assertIsNotNone(game["result"]["all_stopped_at"], game)
        events = page_data(self.folder / "game.html")["events"]
        for kind in ("reset", "restarted"):
            self.assertEqual({event["robot"] for event in events if event["kind"] == kind}, set(range(asked.robots)))
        self.assertEqual([event for event in events if event["kind"] == "lost"], [])

    def test_what_a_game_keeps_for_itself_is_its_users_alone_and_goes_with_it(self):
        net = self.network()
        script = self.folder / "faults.yaml"
        script.write_text("faults: [{at: 1000, reset: 0}]\n", encoding="utf-8")
        launcher, children, _ = self.start_game(net, "--mine", "none", "--faults", script)
        folder, = self.own_folders(children)
        self.assertEqual(folder.stat().st_mode & 0o777, 0o700)
        saves = {words[words.index("--save") + 1] for words in children.values() if words[0] == "quarter-robot"}
        self.assertEqual(len(saves), asked.robots)
        self.assertEqual({Path(save).parent for save in saves}, {folder})
        (folder / "robot0.half").write_bytes(b"Q")  # as a robot leaves it that is killed while it writes
        launcher.send(signal.SIGINT)
        self.assertEqual(launcher.end()[0], 130)
        self.check_gone(net, children)

    def test_the_world_killed(self):
        net = self.network()
        launcher, children, _ = self.start_game(net, "--mine", "none", after=0.5)
        os.kill(next(pid for pid, words in children.items() if words[0] == "quarter-world"), signal.SIGKILL)
        status, output, errors = launcher.end()
        self.assertEqual((status, output), (3, ""))
        self.assertEqual(len(errors.splitlines()), 1, errors)
        self.check_gone(net, children)
        self.assertFalse((self.folder / "game.html").exists())
