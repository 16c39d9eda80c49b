"""The viewer's port: who is answered, who is not, and who is given up."""

import contextlib
import json
import signal

from lcmlog import POSE
from programs import LINE, Case, demo

VIEWERS = 24  # at a time


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
        self.assertEqual(json.loads(LINE.search(page.decode())[1]), {"live": True})
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
