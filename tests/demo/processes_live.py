"""The live view of a game in processes."""

import http.client
import itertools
import json
import signal

import network
from programs import LINE, Case, asked, demo, page_data, program


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
