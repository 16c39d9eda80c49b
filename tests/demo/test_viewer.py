"""test_viewer.py TEMPLATE SAMPLE: the demo's viewer in a browser without a window. Ends with 77 where there is none.

SAMPLE is a replay; what the page is to show is worked out from it here, by code that shares nothing with the page's.
"""

import copy
import http.server
import json
import pathlib
import queue
import sys
import tempfile
import threading
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

import webdriver  # noqa: E402

LINE = '<script id="replay" type="application/json">null</script>'
SCANS = ("scanned", "found")  # a place where a mine was found was scanned
OPEN_PLACES = "document.querySelector('#places').open = true"
FAULTS = ("lost", "stuck", "loss", "slip")
NUMBERS = ("found-at", "planned-at", "all-stopped-at", "duplicates", "collisions", "deadlocks", "messages-pose",
           "messages-terminate")
TIME = "parseFloat(document.querySelector('#time').dataset.value)"
PLAY = "document.querySelector('#play').click()"


def page_of(text):
    """The template with `text` for the replay, as the host program makes it."""
    return TEMPLATE.replace(LINE, LINE.replace("null", text.replace("</", "<\\/")))


def distinct_places(events, t):
    return len({event["place"] for event in events if event["t"] <= t and event["kind"] in SCANS})


class Pages(unittest.TestCase):
    """One browser for all tests of a class; each opens a page of its own, which does not play by itself."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="pages-", dir=pathlib.Path.cwd())
        cls.addClassCleanup(cls.folder.cleanup)
        cls.browser = webdriver.Browser()
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.resize(1280, 900)
        self.browser.media(prefers_color_scheme="light", prefers_reduced_motion="reduce")
        self.browser.log()

    def tearDown(self):
        self.assertEqual([line for line in self.browser.log() if line["level"] in ("SEVERE", "WARNING")], [])

    def open_text(self, text):
        path = pathlib.Path(self.folder.name, "page.html")
        path.write_text(page_of(text), encoding="utf-8")
        self.browser.open(path.as_uri())

    def open_replay(self, **changes):
        self.open_text(json.dumps({**copy.deepcopy(SAMPLE), **changes}))
        self.wait_until("main:not([hidden])")

    def wait_until(self, selector):
        self.browser.wait_for("return document.querySelector(arguments[0]) !== null", selector)

    def wait_time(self, t):
        self.browser.wait_for(f"return Math.abs({TIME} - arguments[0]) < 1e-6", t)

    def wait_past(self, t, first=""):
        self.browser.wait_for(f"return {TIME} > arguments[0]", t, first=first)

    def time(self):
        return float(self.browser.attribute("#time", "data-value") or "nan")

    def scrub(self, t):
        """As a pointer does: sets the range and says so."""
        script = "const s = arguments[0]; s.value = arguments[1]; s.dispatchEvent(new Event('input', {bubbles: true}))"
        self.browser.run(script, {webdriver.ELEMENT: self.browser.find("#scrub")}, t)
        self.wait_time(t)

    def number(self, name):
        return float(self.browser.text(f"#{name}"))

    def assert_shows(self, name, expected):
        with self.subTest(name):
            if expected is None:
                self.assertEqual(self.browser.text(f"#{name}"), "–")
                self.assertEqual(self.browser.attribute(f"#{name}", "data-value"), "")
            else:
                self.assertEqual(self.number(name), expected)


class Playing(Pages):
    def test_plays_by_itself_unless_the_system_wishes_less_motion(self):
        self.open_replay()
        self.assertEqual(self.browser.attribute("#play", "data-playing"), "false")
        self.assertEqual(self.time(), 0)
        self.browser.media(prefers_reduced_motion="no-preference")
        self.open_replay()
        self.wait_past(0)
        self.assertEqual(self.browser.attribute("#play", "data-playing"), "true")

    def test_play_advances_time_and_pause_stops_it(self):
        self.open_replay()
        self.browser.click("#play")
        self.assertEqual(self.browser.text("#play").strip(), "Pause")
        self.wait_past(0.3)
        self.browser.click("#play")
        self.assertEqual(self.browser.text("#play").strip(), "Play")
        # Two more frames drawn: time enough for a clock that had not stopped.
        self.browser.draw(2)
        paused = self.time()
        self.browser.draw(2)
        self.assertEqual(self.time(), paused)

    def test_plays_to_the_end_and_starts_again(self):
        self.open_replay()
        self.browser.click("#speeds button[data-speed='20']")
        self.browser.click("#play")
        self.wait_until("#play[data-playing='false']")
        self.assertEqual(self.time(), SAMPLE["duration"])
        self.assertEqual(self.number("scanned"), SAMPLE["result"]["scanned"])
        self.browser.wait_for(f"return 0 < {TIME} && {TIME} < arguments[0]", SAMPLE["duration"], first=PLAY)

    def test_scrubbing_shows_the_places_scanned_by_then(self):
        self.open_replay()
        scans = [event["t"] for event in SAMPLE["events"] if event["kind"] in SCANS]
        for t in [0, *scans, *(t - 0.05 for t in scans), SAMPLE["duration"]]:
            self.scrub(t)
            scanned = {e["place"] for e in SAMPLE["events"] if e["kind"] in SCANS and e["t"] <= t}
            self.assert_shows("scanned", len(scanned))
            likelihood = sum(SAMPLE["places"][place]["likelihood"] for place in scanned)
            self.assertAlmostEqual(self.number("achieved-now"), likelihood, 3)
            planned = max((p for at, p in SAMPLE["plan"] if at <= t), default=0)
            self.assertAlmostEqual(self.number("expected-now"), planned, 3)
            passed = self.browser.run("return document.querySelectorAll('#events button:not(.future)').length")
            self.assertEqual(passed, sum(e["t"] <= t for e in SAMPLE["events"]))

    def test_an_event_leads_to_its_time(self):
        self.open_replay()
        buttons = "return [...document.querySelectorAll('#events button')].map(b => [+b.dataset.t, b.dataset.kind, " \
            "b.querySelector('.what').textContent, b.classList.contains('fault')])"
        expected = [[e["t"], e["kind"], e["text"], e["kind"] in FAULTS] for e in SAMPLE["events"]]
        self.assertEqual(self.browser.run(buttons), expected)
        self.scrub(SAMPLE["duration"])
        lost = next(e for e in SAMPLE["events"] if e["kind"] == "lost")
        self.browser.click("#events button[data-kind='lost']")
        self.wait_time(lost["t"])

    def test_the_chart_leads_to_its_time(self):
        self.open_replay()
        self.browser.click("#chart")
        self.wait_past(0)

    def test_keys(self):
        self.open_replay()
        steps = [
            ("right", False, 1), ("right", True, 11), ("left", False, 10), ("left", True, 0), ("left", False, 0),
            ("end", False, SAMPLE["duration"]), ("home", False, 0),
        ]  # fmt: skip
        for focus in ("body", "#scrub"):
            self.browser.run("document.querySelector(arguments[0]).focus()", focus)
            for key, shift, expected in steps:
                self.browser.press(key, shift)
                self.wait_time(expected)
            self.browser.press("space")
            self.wait_until("#play[data-playing='true']")
            self.browser.press("space")
            self.wait_until("#play[data-playing='false']")
            self.browser.press("home")
        for key, speed in [("+", 2), ("+", 5), ("+", 10), ("+", 20), ("+", 20), ("-", 10)]:
            self.browser.press(key)
            self.wait_until(f"#speeds button[data-speed='{speed}'][aria-pressed='true']")

    def test_space_on_a_button_presses_it_once(self):
        self.open_replay()
        self.browser.run("document.querySelector('#play').focus()")
        self.browser.press("space")
        self.wait_until("#play[data-playing='true']")
        self.browser.press("space")
        self.wait_until("#play[data-playing='false']")


class Showing(Pages):
    def test_every_number_is_the_replays(self):
        self.open_replay()
        self.scrub(SAMPLE["duration"])
        result = SAMPLE["result"]
        for name in ("found_at", "planned_at", "all_stopped_at", "duplicates", "collisions", "deadlocks"):
            self.assert_shows(name.replace("_", "-"), result[name])
        self.assert_shows("scanned-total", result["scanned"])
        self.assert_shows("places-total", len(SAMPLE["places"]))
        self.assert_shows("duration", SAMPLE["duration"])
        for name, count in result["messages"].items():
            self.assert_shows(f"messages-{name}", count)
        late = result["found_at"] - result["planned_at"]
        self.assertEqual(self.browser.text("#late"), f"({late:.1f} s late)")

    def shown(self):
        """What is on the page: times of the events listed, of those marked on the time line, and the numbers' values."""
        return self.browser.run("""
            const seen = (list) => [...list].filter((e) => e.checkVisibility());
            return [seen(document.querySelectorAll("#events button")).map((b) => Number(b.dataset.t)),
                    seen(document.querySelectorAll("#marks svg")).map((m) => Number(m.dataset.t)),
                    arguments[0].map((id) => document.getElementById(id).dataset.value)]""", list(NUMBERS))

    def told_at(self, t):
        """The same, from the sample."""
        result = SAMPLE["result"]
        known = {**result, **{f"messages_{kind}": count for kind, count in result["messages"].items()}}
        since = {"found_at": result["found_at"], "planned_at": result["found_at"],
                 "all_stopped_at": result["all_stopped_at"]}
        past = [event["t"] for event in SAMPLE["events"] if event["t"] <= t]
        marks = [event["t"] for event in SAMPLE["events"] if event["t"] <= t and event["kind"] != "end"]
        names = [name.replace("-", "_") for name in NUMBERS]
        numbers = [known[name] if t >= since.get(name, SAMPLE["duration"]) else None for name in names]
        return [past, marks, numbers]

    def test_nothing_is_told_before_it_has_happened(self):
        self.open_replay()
        result = SAMPLE["result"]
        moments = [0.01, *(event["t"] for event in SAMPLE["events"][:4]), result["found_at"], result["all_stopped_at"],
                   SAMPLE["duration"]]
        for t in sorted({t for moment in moments for t in (moment - 0.01, moment)}):
            with self.subTest(t):
                self.scrub(t)
                past, marks, numbers = self.shown()
                self.assertEqual([past, marks, [float(value) if value else None for value in numbers]], self.told_at(t))

    def test_who_goes_back_still_sees_what_was_seen(self):
        self.open_replay()
        self.scrub(20)
        seen = self.shown()
        self.assertGreater(len(seen[0]), 3)
        self.scrub(0)
        self.assertEqual(self.shown(), seen)
        self.assert_shows("scanned", 0)

    def test_a_run_without_a_find_has_no_time_to_it(self):
        self.open_replay(result={**SAMPLE["result"], "found_at": None, "planned_at": None})
        self.scrub(SAMPLE["duration"])
        self.assert_shows("found-at", None)
        self.assert_shows("planned-at", None)
        self.assertEqual(self.browser.text("#late"), "")

    def test_places_are_told_one_by_one(self):
        self.open_replay()
        self.scrub(SAMPLE["duration"])
        self.browser.run(OPEN_PLACES)
        states = "return [...document.querySelectorAll('#place-rows tr')].map(row => row.cells[5].textContent)"
        rows = self.browser.run(states)
        found = {e["place"] for e in SAMPLE["events"] if e["kind"] == "found"}
        self.assertEqual(rows, ["found" if p in found else "clear" for p in range(len(SAMPLE["places"]))])

    def test_text_stays_text(self):
        nasty = "</script><img src=x onerror='document.title=1'>&amp;"
        events = [{"t": 1, "kind": "scanned", "place": 0, "robot": 0, "text": nasty}]
        self.open_replay(title=nasty, events=events)
        self.assertEqual(self.browser.text("#title"), nasty)
        self.assertEqual(self.browser.text("#events .what"), nasty)
        self.assertEqual(self.browser.run("return document.images.length"), 0)

    def test_the_map_is_drawn_and_changes_with_time(self):
        self.open_replay()
        picture = "document.querySelector('#map').toDataURL()"
        before = self.browser.run(f"return {picture}")
        self.scrub(20)
        self.browser.wait_for(f"return {picture} !== arguments[0]", before)
        self.assertEqual(self.colours_at(SAMPLE["places"][8]), 2)

    def walled(self, left, top, right, bottom):
        """The sample within walls of so many cells on each side."""
        told = copy.deepcopy(SAMPLE)
        width = left + told["map"]["columns"] + right
        rows = ["#" * width] * top + ["#" * left + row + "#" * right for row in told["map"]["rows_text"]]
        rows += ["#" * width] * bottom
        told["map"].update(columns=width, rows=len(rows), rows_text=rows)
        for at in told["places"]:
            at.update(x=at["x"] + left, y=at["y"] + top)
        told["starts"] = [[x + left, y + top] for x, y in told["starts"]]
        told["routes"] = [[[x + left, y + top] for x, y in route] for route in told["routes"]]
        for track in told["tracks"]:
            track.update(x=[x + 100 * left for x in track["x"]], y=[y + 100 * top for y in track["y"]])
        return told

    def test_only_the_part_of_the_map_that_is_used_is_shown(self):
        pictures = []
        for walls in ((1, 1, 1, 1), (40, 1, 2, 90), (1, 33, 70, 1)):
            self.open_text(json.dumps(self.walled(*walls)))
            self.wait_until("main:not([hidden])")
            self.scrub(20)
            self.browser.draw(2)
            pictures.append(self.coarse_picture())
        for size, colours in pictures[1:]:
            self.assertEqual(size, pictures[0][0])
            self.assertLess(max(abs(a - b) for a, b in zip(colours, pictures[0][1])), 10)

    def coarse_picture(self):
        """The map's size, and its colours on a coarse grid, which rounding does not change."""
        return self.browser.run("""
            const map = document.querySelector("#map"), small = document.createElement("canvas");
            small.width = small.height = 40;
            const context = small.getContext("2d");
            context.imageSmoothingQuality = "high";
            context.drawImage(map, 0, 0, 40, 40);
            return [[map.width, map.height], [...context.getImageData(0, 0, 40, 40).data]]""")

    def test_a_bar_shows_the_scale(self):
        for cell_size, unit in ((1.0, "m"), (0.05, "m"), (0.2, "m"), (7.3, "m"), (1000.0, "m"), (1.0, "cells")):
            for width in (320, 1280):
                self.browser.resize(width, 900)
                self.open_replay(map={**SAMPLE["map"], "cell_size": cell_size, "unit": unit})
                bar, cell, map_width, text = self.browser.run("""
                    const map = document.querySelector("#map").getBoundingClientRect(), scale = document.querySelector("#scale");
                    return [scale.firstChild.getBoundingClientRect().width, map.width / arguments[0], map.width,
                            scale.textContent]""", SAMPLE["map"]["columns"])
                length, _, of = text.partition(" ")
                self.assertIn(of, ("cell", "cells") if unit == "cells" else ("m",))
                self.assertAlmostEqual(float(length) / cell_size * cell, bar, 0)
                self.assertIn(float(f"{float(length):e}".partition("e")[0]), (1, 2, 5))
                self.assertLess(bar, map_width / 2)
                self.assertGreater(bar, 15)

    def colours_at(self, place):
        """How many of a place's two sides differ from the bare ground: a mark is drawn there."""
        script = """
            const [placeX, placeY, columns] = arguments;
            const map = document.querySelector("#map"), cell = map.width / columns;
            const image = new Uint32Array(map.getContext("2d").getImageData(0, 0, map.width, map.height).data.buffer);
            const at = (x, y) => image[Math.floor(y * cell) * map.width + Math.floor(x * cell)];
            return [-0.2, 0.2].filter((d) => at(placeX + d, placeY) !== at(0.5, 0.5)).length"""
        return self.browser.run(script, place["x"], place["y"], SAMPLE["map"]["columns"])

    def test_the_canvas_has_the_screens_pixels(self):
        for ratio in (1, 2, 3):
            self.browser.resize(1000, 800, ratio)
            self.open_replay()
            size = "const m = document.querySelector('#map'); return m.width / m.getBoundingClientRect().width"
            self.assertAlmostEqual(self.browser.run(size), ratio, 1)

    def test_no_width_scrolls_sideways(self):
        for width in (320, 390, 700, 901, 1280, 1920):
            self.browser.resize(width, 844)
            self.open_replay()
            self.browser.run(OPEN_PLACES)
            self.browser.wait_for("const e = document.documentElement; return e.scrollWidth === e.clientWidth")

    def test_dark_as_the_system_wishes_or_by_hand(self):
        background = "return getComputedStyle(document.body).backgroundColor"
        self.open_replay()
        light = self.browser.run(background)
        self.browser.media(prefers_color_scheme="dark", prefers_reduced_motion="reduce")
        self.browser.wait_for(f"{background} !== arguments[0]", light)
        dark = self.browser.run(background)
        self.open_replay()
        self.assertEqual(self.browser.run(background), dark)
        self.browser.click("#theme")
        self.assertEqual(self.browser.run(background), light)

    def test_every_control_has_a_name(self):
        self.open_replay()
        self.scrub(SAMPLE["duration"])
        nodes = self.browser.devtools("Accessibility.getFullAXTree")["nodes"]
        roles = ("button", "slider", "checkbox", "image", "DisclosureTriangle")
        names = [(n["role"]["value"], n["name"]["value"]) for n in nodes if n.get("role", {}).get("value") in roles]
        self.assertGreater(len(names), len(SAMPLE["events"]) + 8)
        self.assertEqual([entry for entry in names if entry[1].strip() == ""], [])


class Refusing(Pages):
    def assert_refused(self, text, sentence):
        with self.subTest(text[:60]):
            self.open_text(text)
            self.wait_until("#problem:not([hidden])")
            self.assertEqual(self.browser.text("#problem"), sentence)
            self.assertFalse(self.browser.run("return document.querySelector('main').checkVisibility()"))

    def test_no_replay(self):
        for text in ("null", "7", '"replay"'):
            self.assert_refused(text, "This page holds no replay: the host program puts one in.")

    def test_another_format(self):
        text = json.dumps({**SAMPLE, "format": 2})
        self.assert_refused(text, "This page reads replays of format 1, and this one is of format 2.")

    def test_no_json(self):
        self.assert_refused("{", "The replay in this page is not JSON.")

    def test_damage(self):
        tracks = copy.deepcopy(SAMPLE["tracks"])
        tracks[0]["x"].pop()
        damages = {
            "map": {**SAMPLE["map"], "rows": 99},
            "robots": 0,
            "places": [{"x": "1"}],
            "starts": [],
            "routes": None,
            "plan": [[1]],
            "tick": 0,
            "duration": None,
            "tracks": tracks,
            "events": [{"t": 1, "kind": "scanned", "place": 99}],
        }
        for part, damage in damages.items():
            text = json.dumps({**SAMPLE, part: damage})
            self.assert_refused(text, f"This replay is damaged: its {part} cannot be read.")


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


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    if webdriver.installed() is None:
        print("SKIPPED: the replay page in a browser: there is no chromium with a chromedriver (Ubuntu's packages of these names are stubs)")
        sys.exit(77)
    if not webdriver.knows_localhost():
        print("SKIPPED: the replay page in a browser: this machine does not know the name localhost (/etc/hosts)")
        sys.exit(77)
    template, sample = sys.argv[1:3]
    TEMPLATE = pathlib.Path(template).read_text(encoding="utf-8")
    SAMPLE = json.loads(pathlib.Path(sample).read_text(encoding="utf-8"))
    assert TEMPLATE.count(LINE) == 1, "the line that the host program replaces is there once"
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
