"""Time: playing, scrubbing, keys; and replays that cannot be played."""

import copy
import json

from pages import FAULTS, PLAY, SAMPLE, SCANS, TIME, Pages, told_events


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
            self.check_moment(t)

    def check_moment(self, t):
        self.scrub(t)
        scanned = {e["place"] for e in SAMPLE["events"] if e["kind"] in SCANS and e["t"] <= t}
        self.assert_shows("scanned", len(scanned))
        likelihood = sum(SAMPLE["places"][place]["likelihood"] for place in scanned)
        self.assertAlmostEqual(self.number("achieved-now"), likelihood, 3)
        planned = max((p for at, p in SAMPLE["plan"] if at <= t), default=0)
        self.assertAlmostEqual(self.number("expected-now"), planned, 3)
        passed = self.browser.run("return document.querySelectorAll('#events button:not(.future)').length")
        self.assertEqual(passed, sum(e["t"] <= t for e in told_events()))

    def test_an_event_leads_to_its_time(self):
        self.open_replay()
        buttons = "return [...document.querySelectorAll('#events button')].map(b => [+b.dataset.t, b.dataset.kind, " \
            "b.querySelector('.what').textContent, b.classList.contains('fault')])"
        expected = [[e["t"], e["kind"], e["text"], e["kind"] in FAULTS] for e in told_events()]
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
            "ghost": {"tick": 1, "duration": 9, "scans": [[1, 99]], "tracks": []},
            "said": [[1]],
        }
        for part, damage in damages.items():
            text = json.dumps({**SAMPLE, part: damage})
            self.assert_refused(text, f"This replay is damaged: its {part} cannot be read.")
