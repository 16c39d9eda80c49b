"""Signals that are sealed by a key, and signals that are forged."""

import json
import os

import network
from lcmlog import DONE, FOUND, STATUS, TERMINATE
from network import Network
from programs import TAG, Case, asked, demo, program, robot, tag_of, terminate, world
from scripted_world import ScriptedWorld

KEY, OTHER = bytes(range(32)), bytes(range(1, 41))
NUMBER = 1


class Seals(Case):
    def key(self, name, contents=KEY, mode=0o600):
        path = self.folder / name
        path.write_bytes(contents)
        path.chmod(mode)
        return path

    def has_seals(self):
        return "without libsodium" not in network.Program(robot(0, "--key", self.folder / "none.key")).end()[2]

    def need_seals(self):
        if not self.has_seals():
            self.skipTest("libsodium is missing: install libsodium-dev and configure anew")

    def drive(self, *words):
        """Robot 1 in a scripted world, on its way."""
        scripted = ScriptedWorld(asked.plan, NUMBER, self.network())
        scripted.start(*robot(NUMBER, *words))
        while scripted.stands(scripted.tick()):
            self.assertLess(scripted.utime, 10e6, "it does not drive")
        return scripted

    def forgeries(self):
        """FOUND, as somebody says it who heard a signal of this team and has not its key."""
        said = {"utime": 1, "sender": 0, "signal": FOUND}
        sealed = terminate(key=KEY, utime=1, sender=0, signal=DONE, territory=0)
        yield terminate(**said)
        yield terminate(key=OTHER, **said)
        yield terminate(**said)[:-TAG] + os.urandom(TAG)
        yield terminate(**said)[:-TAG] + sealed[-TAG:]
        for tag in (KEY[:TAG], tag_of(b"", KEY)):
            yield terminate(**said)[:-TAG] + tag

    def test_a_forged_find_does_not_stop_a_sealed_robot_and_a_sealed_one_does(self):
        self.need_seals()
        scripted = self.drive("--key", self.key("team.key"))
        forged = list(self.forgeries())
        for word in forged:
            scripted.publisher.send("QUARTER_TERMINATE", word)
            self.assertFalse(scripted.stands(scripted.tick()))
        scripted.publisher.send("QUARTER_TERMINATE", terminate(key=KEY, utime=1, sender=0, signal=FOUND))
        self.assertTrue(scripted.stands(scripted.tick()))
        self.assertEqual(scripted.said, {(NUMBER, FOUND, 0)})
        for source, channel, data in list(scripted.listener.heard):
            if channel == "QUARTER_TERMINATE" and source != scripted.publisher.port:
                self.assertEqual(data[-TAG:], tag_of(data[:-TAG], KEY))
        status, _, errors = scripted.program.end()
        self.assertEqual(status, 0)
        self.assertIn(f"robot {NUMBER}: {len(forged)} signals without this key's seal ignored", errors)

    def test_the_same_stops_a_robot_that_has_no_key(self):
        for word in self.forgeries():
            with self.subTest(tag=word[-TAG:].hex()):
                scripted = self.drive()
                scripted.publisher.send("QUARTER_TERMINATE", word)
                self.assertTrue(scripted.stands(scripted.tick()))
                scripted.program.kill()

    def test_a_sealed_team_searches_as_any_other_whatever_is_forged(self):
        self.need_seals()
        net = self.network()
        game = net.start(*demo("--processes", "--json", "--mine", asked.soon[0], "--speed", 2, "--key", self.key("team.key")))
        publisher, listener = net.publisher(), net.listen()
        at = 0
        while game.runs():  # as often as the world says how things stand
            heard = listener.await_message(lambda _, channel, data: channel == "QUARTER_STATUS", "a status", at, seconds=1)
            at = heard[1] + 1 if heard else at
            for word in self.forgeries():
                publisher.send("QUARTER_TERMINATE", word)
        status, output, errors = game.end()
        self.assertEqual(status, 0, errors)
        self.assertIn("without this key's seal ignored", errors)
        result = json.loads(output)["result"]
        self.assertIsNotNone(result["found_at"])
        stops = [STATUS.decode(data) for _, channel, data in listener.heard if channel == "QUARTER_STATUS"]
        before = [status for status in stops if status["utime"] / 1e6 < result["found_at"] and status["utime"] > 2e6]
        self.assertTrue(before)
        self.assertTrue(all(1 not in status["state"][: asked.robots] for status in before), "one stood before the find")

    def test_robots_of_different_keys_do_not_believe_one_another(self):
        self.need_seals()
        mission, table = self.folder / "small.txt", self.folder / "small.qtr"
        mission.write_text("S.1\nS.1\nS.1\n", encoding="utf-8")
        learnt = network.Program(program("quarter-demo", mission, "--save-table", table, "--mine", "none", "-q")).end()
        self.assertEqual(learnt, (0, "", ""))
        key, other = self.key("team.key"), self.key("other.key", OTHER)
        with Network() as net:
            listener = net.listen()
            game = net.start(*program("quarter-world", mission, "--table", table, "--mine", "none", "--speed", 4, "--key", key,
                                      "--json"))
            crew = [net.start(*program("quarter-robot", table, "--robot", number, "--key", other if number == 2 else key))
                    for number in range(3)]
            status, output, errors = game.end()
            self.assertEqual(status, 0, errors)
            self.assertIn("without this key's seal ignored", errors)
            for number, ended in enumerate(one.end() for one in crew):
                self.assertEqual(ended[0], 0, ended)
                self.assertIn("without this key's seal ignored", ended[2], (number, ended))
        said = {}
        for _, channel, data in listener.heard:
            if channel == "QUARTER_TERMINATE":
                word = TERMINATE.decode(data)
                said.setdefault(word["sender"], set()).add(data[-TAG:] == tag_of(data[:-TAG], OTHER if word["sender"] == 2 else KEY))
        self.assertEqual(said, {number: {True} for number in range(3)})
        self.assertEqual(json.loads(output)["result"]["scanned"], 3)

    def test_keys_that_are_none_are_refused_with_one_line(self):
        self.need_seals()
        keys = ((self.key("short.key", KEY[:-1]), "31"), (self.key("empty.key", b""), "empty"),
                (self.key("open.key", mode=0o640), "chmod 600"), (self.key("long.key", bytes(5000)), "4096 bytes"),
                (self.folder / "none.key", "none.key"), (self.folder, "folder"))
        for path, says in keys:
            for words in (robot(0, "--key", path), world("--key", path), demo("--processes", "--key", path),
                          demo("--follow", "--key", path)):
                with self.subTest(words=[str(word) for word in words]):
                    self.line(network.Program(words, cwd=self.folder).end(), 2, says)
        self.line(network.Program(demo("--key", keys[0][0])).end(), 2, "--key goes with --processes")

    def test_without_libsodium_a_key_is_refused_with_one_line(self):
        if self.has_seals():
            self.skipTest("this build has libsodium")
        for words in (robot(0), world(), demo("--processes")):
            self.line(network.Program([*words, "--key", self.key("team.key")]).end(), 2, "without libsodium")
