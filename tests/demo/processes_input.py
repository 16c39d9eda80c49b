"""Command lines, tables and faults that cannot be, buses that cannot be opened."""

from pathlib import Path

import network
from programs import MISSION, MISSIONS, Case, asked, demo, program, robot, world


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
        for words, says in (
                ([], ["--robot N"]), ([asked.table], ["--robot N"]), (["--robot", "0"], ["mission.qtr"]),
                ([asked.table, asked.table, "--robot", "0"], ["one table"]), ([asked.table, "--robot"], ["--robot"]),
                ([asked.table, "--robot", "-1"], ["--robot -1"]), ([asked.table, "--robot", "x"], ["--robot x"]),
                ([asked.table, "--robot", "256"], ["--robot 256"]), ([asked.table, "--robt", "0"], ["--robot?"]),
                ([asked.table, "--clear-all=1", "--robot", "0"], ["--clear-all=1"])):
            self.refuse([asked.programs / "quarter-robot", *words], *says)
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
