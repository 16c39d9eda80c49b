"""Games in processes, with packets lost, and one robot alone in a world that is scripted."""

import concurrent.futures
import json
import os
import signal
from pathlib import Path

import lcmlog
import network
from lcmlog import COMMAND, DONE, FOUND
from network import Network, Wire, await_file
from programs import MISSIONS, Case, asked, drives, is_found, page_data, program, robot
from scripted_world import ScriptedWorld


def without_notes(errors):
    return "".join(line for line in errors.splitlines(True) if not line.startswith("quarter: note: "))


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
            self.check_robot_stops(after, robot)

    def check_robot_stops(self, after, robot):
        poses = [time for time, channel, _ in after if channel == f"QUARTER_R{robot}_POSE"]
        orders = [COMMAND.decode(data) for _, channel, data in after if channel == f"QUARTER_R{robot}_COMMAND"]
        self.assertTrue(orders)
        if len(poses) > self.OVERTAKEN:
            late = [order for order in orders if order["utime"] >= poses[self.OVERTAKEN]]
            self.assertEqual([order for order in late if drives(order)], [], f"robot {robot}")

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
        for mission in ("minefield", "site", "turtlebot3_world", "warehouse", "demining", "flat"):
            for mode in ([], ["--clear-all"], ["--mine", "none"]):
                with self.subTest(mission=mission, mode=mode):
                    log = self.folder / f"{mission}.lcm"
                    status, output, errors = network.Program(
                        [asked.programs / "quarter-demo", MISSIONS / mission / "mission.yaml", "--learn-limit", 1,
                         "--json", "--log", log, *mode]).end()
                    self.assertEqual((status, without_notes(errors)), (0, ""))
                    game = json.loads(output)
                    self.assertEqual(game["result"]["found_at"] is None, mode[-1:] == ["none"])
                    sent = self.check_messages(log, game)
                    for kind in ("pose", "scan"):
                        self.assertEqual(sent[kind], game["result"]["messages"][kind])
                    stopped = game["pace"] * self.check_story(log, game)
                    self.assertAlmostEqual(stopped, game["result"]["all_stopped_at"], places=3)


class Terms(Case):
    """Robots of two speeds that take time to scan, wait and tire, each a process that knows its table alone."""

    def play_flat(self, net, *words):
        page = self.folder / "flat.html"
        status, output, errors = net.run(*program("quarter-demo", MISSIONS / "flat" / "mission.yaml", "--processes", "--speed", 8,
                                                  "--json", "-o", page, *words))
        self.assertEqual((status, errors), (0, ""))
        return json.loads(output), page_data(page)

    def test_they_find_it_and_no_sooner_than_a_look_and_its_way_take(self):
        """How late it is the machine's load says."""
        network.need_network(False)
        with Network() as net:
            game, page = self.play_flat(net, "--mine", 1)
        result = game["result"]
        self.assertGreater(result["found_at"], 0.9 * result["planned_at"])
        ready = [event for event in page["events"] if event["kind"] == "ready"]
        self.assertEqual([event["robot"] for event in ready], [2])
        self.assertGreaterEqual(ready[0]["t"], 30)

    def test_who_is_held_up_is_low_on_battery_and_goes_home(self):
        network.need_network(False)
        faults = self.folder / "faults.yaml"
        faults.write_text("faults:\n  - {at: 100, stuck: Vera, for: 120}\n", encoding="utf-8")
        with Network() as net:
            game, page = self.play_flat(net, "--mine", "none", "--faults", faults)
        events = [(event["kind"], event.get("robot")) for event in page["events"]]
        self.assertIn(("battery", 1), events)
        for robot in range(3):
            self.assertIn(("home", robot), events)
        self.assertNotIn(("territory_done", 1), [(event["kind"], event.get("territory")) for event in page["events"]
                                                 if event.get("robot") == 1])
        self.assertIsNotNone(game["result"]["all_stopped_at"])


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

    def start_again(self, scripted, save):
        """It is killed and started anew; the places that it reads over before its next new one."""
        scripted.program.kill()
        seen, scripted.reads = len(scripted.scanned), []
        scripted.start(*robot(self.NUMBER, "--save", save))
        while len(scripted.scanned) == seen:
            scripted.tick()
            self.assertLess(scripted.utime, 2000e6)
        return set(scripted.reads) - set(scripted.scanned[seen:])

    def test_killed_and_started_again_it_goes_on_from_its_save_and_anew_from_a_torn_one(self):
        save = self.folder / "robot.save"
        scripted = ScriptedWorld(asked.plan, self.NUMBER, self.network())
        scripted.start(*robot(self.NUMBER, "--save", save))
        while len(scripted.scanned) < 2:
            scripted.tick()
        scripted.tick()  # it has heard what was under its sensor
        self.assertEqual(self.start_again(scripted, save), set())
        scripted.tick()
        known = set(scripted.scanned)
        save.write_bytes(save.read_bytes()[:-1])
        self.assertEqual(self.start_again(scripted, save), known)
        scripted.program.kill()

    def test_its_save_ends_with_its_world(self):
        save = self.folder / "robot.save"
        scripted = ScriptedWorld(asked.plan, self.NUMBER, self.network())
        scripted.start(*robot(self.NUMBER, "--save", save))
        while not scripted.scanned:
            scripted.tick()
        await_file(save, save.exists)
        self.line(scripted.program.end(), 3, "its search is not over")
        self.assertFalse(save.exists(), "in another search it would go on from this one")

    def test_what_it_reads_it_does_not_save_over(self):
        table = self.folder / "own.qtr"
        whole = asked.table.read_bytes()
        table.write_bytes(whole)
        words = program("quarter-robot", table, "--robot", self.NUMBER, "--save", table)
        status, output, errors = self.network().start(*words).end()
        self.assertEqual((status, output), (2, ""))
        self.assertEqual(errors, f"quarter-robot: {table}: is what is read; name another file to save in\n")
        self.assertEqual(table.read_bytes(), whole)

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
