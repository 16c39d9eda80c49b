"""Opening the viewer's page in a browser, and what its tests share."""

import argparse
import copy
import json
import pathlib
import tempfile
import unittest

import webdriver

LINE = '<script id="replay" type="application/json">null</script>'
SCANS = ("scanned", "found")  # a place where a mine was found was scanned
OPEN_PLACES = "document.querySelector('#places').open = true"
FAULTS = ("lost", "stuck", "reset", "shut", "loss", "slip")
NUMBERS = ("found-at", "planned-at", "all-stopped-at", "duplicates", "collisions", "deadlocks", "messages-pose",
           "messages-terminate")
TIME = "parseFloat(document.querySelector('#time').dataset.value)"
PLAY = "document.querySelector('#play').click()"
SAMPLE = {}  # a replay
# What follows from the sample: robot 0 was done at 20.2, robot 1 is lost at 20.4, and robot 0 searches its places from 28.2 on.
TAKEOVER = {"t": 20.4, "kind": "takeover", "robot": 0, "text": "robot 0 takes over what robot 1 left: 2 places"}
asked = argparse.Namespace()  # the page without a replay, as test_viewer.py was told


def page_of(text):
    """The template with `text` for the replay, as the host program makes it."""
    return asked.template.replace(LINE, LINE.replace("null", text.replace("</", "<\\/")))


def told_events():
    """The sample's events with those that follow from them, in the order in which the page lists them."""
    return sorted([*SAMPLE["events"], TAKEOVER], key=lambda event: event["t"])


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
