"""The page beside a host that sends a run while it goes on."""

import http.server
import json
import queue
import threading

from pages import SAMPLE, TAKEOVER, Pages, distinct_places, page_of


class Host(http.server.ThreadingHTTPServer):
    """The page at /, and at /events whatever is put into `messages`; None there breaks the connection."""

    daemon_threads = True

    def __init__(self):
        super().__init__(("127.0.0.1", 0), Handler)
        self.messages, self.asked = queue.Queue(), []
        self.is_open = threading.Event()
        self.is_open.set()
        threading.Thread(target=self.serve_forever, args=(0.05,), daemon=True).start()

    def close(self):
        self.is_open.set()
        self.messages.put(None)
        self.shutdown()
        self.server_close()

    def send(self, name, data):
        self.messages.put(f"event: {name}\ndata: {json.dumps(data)}\n\n")

    def url(self):
        return f"http://127.0.0.1:{self.server_address[1]}/"


class Handler(http.server.BaseHTTPRequestHandler):
    def log_message(self, *_):
        pass

    def do_GET(self):
        self.server.asked.append(self.path)
        {"/": self.send_page, "/events": self.send_events}.get(self.path, lambda: self.send_error(404))()

    def start(self, kind):
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.end_headers()

    def send_page(self):
        self.start("text/html; charset=utf-8")
        self.wfile.write(page_of('{"format": 1, "live": true}').encode())

    def send_events(self):
        self.server.is_open.wait()
        self.start("text/event-stream")
        self.wfile.write(b"retry: 50\n\n")
        while (message := self.server.messages.get()) is not None:
            self.wfile.write(message.encode())
            self.wfile.flush()


class Live(Pages):
    def setUp(self):
        super().setUp()
        self.host = Host()
        self.addCleanup(self.host.close)
        # First the page goes: left open, it would ask a host that is no more, into the next test's log.
        self.addCleanup(self.browser.open, "about:blank")
        self.hello = {name: value for name, value in SAMPLE.items() if name not in ("tracks", "events", "result")}
        self.browser.open(self.host.url())
        self.sent = 0.0

    def frame(self, t):
        """What the sample has at t, and the events since the last frame."""
        k = round(t / SAMPLE["tick"])
        robots = [[track[name][k] / 100 for name in ("x", "y", "heading")] for track in SAMPLE["tracks"]]
        events = [event for event in SAMPLE["events"] if self.sent < event["t"] <= t]
        self.host.send("frame", {"t": t, "robots": robots, "events": events})
        self.sent = t

    def test_follows_the_run_to_its_end(self):
        self.wait_until("#badge[data-state='connecting']")
        self.host.send("hello", self.hello)
        self.wait_until("#badge[data-state='live']")
        self.assertEqual(self.browser.text("#title"), SAMPLE["title"])
        for t in (0.1, 5.0, 14.0, 21.0):
            self.frame(t)
            self.wait_time(t)
            self.assert_shows("scanned", distinct_places(SAMPLE["events"], t))
            self.assert_shows("found-at", None)
        self.frame(34.0)
        self.wait_time(34.0)
        self.assert_shows("found-at", SAMPLE["result"]["found_at"])
        self.host.send("end", {"result": SAMPLE["result"], "duration": SAMPLE["duration"]})
        self.wait_until("#badge[data-state='ended']")
        self.wait_time(SAMPLE["duration"])
        self.assert_shows("messages-terminate", SAMPLE["result"]["messages"]["terminate"])
        self.assert_shows("planned-at", SAMPLE["result"]["planned_at"])
        # It must not ask for the events again, as the browser by itself would.
        self.assertTrue(self.browser.run("return live.source.readyState === EventSource.CLOSED"))
        # From here on it is a replay as any other, and nothing but the page and its events was asked for.
        self.scrub(5.0)
        self.assert_shows("scanned", distinct_places(SAMPLE["events"], 5.0))
        self.assertEqual(self.host.asked, ["/", "/events"])

    def test_moves_smoothly_to_the_newest_frame(self):
        self.browser.media(prefers_reduced_motion="no-preference")
        self.host.send("hello", self.hello)
        self.frame(0.1)
        self.frame(2.0)
        self.wait_time(2.0)

    def test_looking_back_does_not_lose_the_run(self):
        self.host.send("hello", self.hello)
        self.frame(10.0)
        self.wait_time(10.0)
        self.browser.press("space")
        self.scrub(5.0)
        self.frame(15.0)
        self.browser.wait_for("return Number(document.querySelector('#duration').textContent) === 15")
        self.assertEqual(self.time(), 5.0)
        self.browser.click("#follow")
        self.wait_time(15.0)

    def test_a_connection_that_comes_back_goes_on(self):
        self.host.send("hello", self.hello)
        self.frame(10.0)
        self.wait_time(10.0)
        self.host.is_open.clear()
        self.host.messages.put(None)
        self.wait_until("#badge[data-state='lost']")
        self.host.is_open.set()
        self.host.send("hello", self.hello)
        self.sent = 0.0  # the host tells whoever connects all events so far
        self.frame(15.0)
        self.wait_until("#badge[data-state='live']")
        self.wait_time(15.0)
        self.assert_shows("scanned", distinct_places(SAMPLE["events"], 15.0))
        self.assert_lists_once(15.0)

    def assert_lists_once(self, t):
        rows = self.browser.run("return document.querySelectorAll('#events li').length")
        self.assertEqual(rows, sum(event["t"] <= t for event in SAMPLE["events"]))

    def test_who_takes_over_is_listed_when_it_shows(self):
        """Where it set out to, which no message says, shows when it searches there."""
        self.host.send("hello", self.hello)
        self.frame(22.0)
        self.wait_time(22.0)
        self.assertIn("Robot 1 is lost", self.browser.text("#story"))
        self.frame(29.0)
        self.wait_time(29.0)
        self.assertEqual(self.browser.text("#events button[data-kind='takeover'] .what"), TAKEOVER["text"])
        rows = self.browser.run("return document.querySelectorAll('#events li').length")
        self.assertEqual(rows, 1 + sum(event["t"] <= 29.0 for event in SAMPLE["events"]))

    def test_who_comes_late_sees_what_was_before(self):
        self.host.send("hello", self.hello)
        self.frame(22.0)
        self.wait_time(22.0)
        self.assert_lists_once(22.0)
        self.assert_shows("scanned", distinct_places(SAMPLE["events"], 22.0))

    def test_events_of_a_moment_that_was_shown_are_not_lost(self):
        self.host.send("hello", self.hello)
        self.frame(10.0)
        self.wait_time(10.0)
        last = {"t": 10.0, "kind": "unstuck", "robot": 1, "text": "robot 1 drives again"}
        self.host.send("frame", {"t": 10.0, "robots": [[1, 1, 0]] * SAMPLE["robots"], "events": [last]})
        self.wait_until("#events button[data-kind='unstuck']:not(.future)")

    def test_a_hello_may_tell_what_was_before(self):
        self.host.send("hello", {**self.hello, "events": SAMPLE["events"][:4]})
        self.sent = SAMPLE["events"][3]["t"]
        self.frame(15.0)
        self.wait_time(15.0)
        self.assert_shows("scanned", distinct_places(SAMPLE["events"], 15.0))

    def test_a_run_that_starts_again_is_followed_from_its_start(self):
        self.host.send("hello", self.hello)
        self.frame(10.0)
        self.wait_time(10.0)
        self.sent = 0.0
        self.frame(5.0)
        self.wait_time(5.0)
        self.assert_shows("duration", 5.0)
        self.assert_shows("scanned", distinct_places(SAMPLE["events"], 5.0))

    def test_a_run_of_another_format_is_refused(self):
        self.host.send("hello", {**self.hello, "format": 3})
        self.wait_until("#problem:not([hidden])")
        self.assertIn("of format 3", self.browser.text("#problem"))
