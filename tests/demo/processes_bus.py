"""Who else is on the bus: strangers, a second game, LCM's own tools."""

import collections
import json
import math
import os
import random
import signal
import struct
import threading

import lcmlog
import network
from lcmlog import COMMAND, DONE, FOUND, POSE, SCAN, TERMINATE
from network import await_file
from programs import Case, asked, demo, page_data, terminate


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
            (f"QUARTER_R{number}_COMMAND", COMMAND.encode(robot=number, left=bad, right=0.0, read=1, intent=0, **at)),
            (f"QUARTER_R{number}_COMMAND", COMMAND.encode(robot=far, left=1.0, right=0.0, read=1, intent=0, **at)),
            ("QUARTER_TERMINATE", terminate(sender=far, signal=FOUND, **at)),
            ("QUARTER_TERMINATE", terminate(sender=number, signal=signal_number, **at)),
            ("QUARTER_TERMINATE", terminate(sender=number, signal=DONE, territory=far, **at))])

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
