"""The ghost: the same mines searched without a plan, beside the planned game."""

from pages import SAMPLE, Pages

FINISHED, DURATION = 58.3, 58.4
SCANS = [[9.0, 7], [12.0, 0], [25.0, 4], [FINISHED, 5]]  # place 5 has the mine
# Each walks from its start to the right, a cell in ten seconds.
GHOST = {"strategy": "nearest", "finished_at": FINISHED, "duration": DURATION, "duplicates": 4, "scans": SCANS, "tick": 2,
         "tracks": [{"x": [150 + 20 * k for k in range(30)], "y": [y] * 30} for y in (350, 450, 550)]}


class Ghost(Pages):
    def open_with_ghost(self, **changes):
        self.open_replay(ghost={**GHOST, **changes})

    def lane(self, name):
        return self.browser.run("""
            const lane = document.querySelector(`#lane-${arguments[0]}`);
            return [lane.dataset.state, lane.querySelector("b").textContent, lane.querySelector("i").getBoundingClientRect().width]""", name)

    def test_a_record_without_it_is_played_without_it(self):
        self.open_replay()
        self.assertEqual(self.browser.run("return ['#race', '#legend-ghost', '#key-ghost'].map(id => document.querySelector(id).hidden)"),
                         [True, True, True])
        self.assert_shows("duration", SAMPLE["duration"])

    def test_both_come_to_their_ends_in_their_own_times(self):
        self.open_with_ghost()
        found = SAMPLE["result"]["found_at"]
        self.scrub(15)
        self.assertEqual([self.lane(name)[:2] for name in ("plan", "ghost")],
                         [["running", "4 of 9 places"], ["running", "2 of 9 places"]])
        self.assertEqual(self.lane("plan")[2], self.lane("ghost")[2])
        self.scrub(found)
        self.assertEqual(self.lane("plan")[:2], ["finished", f"{found} s"])
        self.assertEqual(self.lane("ghost")[:2], ["running", "3 of 9 places"])
        self.assertEqual(self.browser.text("#story-text"), "Robot 0 found it at place 5.")
        self.scrub(FINISHED)
        self.assertEqual(self.lane("ghost")[:2], ["finished", f"{FINISHED} s"])
        self.assertAlmostEqual(self.lane("ghost")[2] / self.lane("plan")[2], FINISHED / found, 1)
        self.assertEqual(self.browser.text("#story-text"),
                         f"Found after {found} s, without a plan after {FINISHED} s: {FINISHED / found:.1f} times as long.")

    def test_a_ghost_that_comes_first_is_told_as_plainly(self):
        self.open_with_ghost(finished_at=25.0, duration=25.1, scans=SCANS[:2])
        self.scrub(SAMPLE["duration"])
        found = SAMPLE["result"]["found_at"]
        self.assertEqual(self.browser.text("#story-text"), f"Found after {found} s, without a plan after 25 s.")
        self.assert_shows("duration", SAMPLE["duration"])

    def test_a_ghost_that_never_gets_there_has_no_time(self):
        self.open_with_ghost(finished_at=None, scans=SCANS[:3])
        self.scrub(DURATION)
        self.assertEqual(self.lane("ghost")[:2], ["over", "3 of 9 places"])
        self.assertEqual(self.browser.text("#story-text"), "Robot 0 found it at place 5.")

    def test_where_no_find_ends_the_search_the_last_place_does(self):
        last = max(event["t"] for event in SAMPLE["events"] if event["kind"] in ("scanned", "found"))
        self.open_replay(mode="clear", ghost=GHOST)
        self.scrub(DURATION)
        self.assertEqual(self.lane("plan")[:2], ["finished", f"{last} s"])
        self.assertIn(f"All was searched after {last} s", self.browser.text("#story-text"))

    def test_the_time_line_leads_to_the_ghosts_end(self):
        self.open_with_ghost()
        self.assert_shows("duration", DURATION)
        self.browser.press("end")
        self.wait_time(DURATION)
        self.assert_shows("found-at", SAMPLE["result"]["found_at"])
        self.assert_shows("scanned-total", SAMPLE["result"]["scanned"])

    def test_it_can_be_switched_off(self):
        self.open_with_ghost()
        self.browser.press("end")
        self.wait_time(DURATION)
        self.browser.click("#show-ghost")
        self.wait_time(SAMPLE["duration"])
        self.assert_shows("duration", SAMPLE["duration"])
        self.assertTrue(self.browser.run("return document.querySelector('#race').hidden"))
        self.assertEqual(self.browser.attribute("#chart-ghost", "d"), "")
        self.browser.click("#show-ghost")
        self.browser.wait_for("return !document.querySelector('#race').hidden")
        self.assert_shows("duration", DURATION)

    def test_its_chance_of_the_find_is_in_the_chart(self):
        self.open_with_ghost()
        self.scrub(26)
        expected = sum(SAMPLE["places"][place]["likelihood"] for t, place in SCANS if t <= 26)
        self.assertAlmostEqual(self.number("ghost-now"), expected, 3)

    def pixel(self, x, y):
        return self.browser.run("""
            const map = document.querySelector("#map"), [x, y] = [...arguments].map((at, axis) =>
              (at - (axis === 0 ? view.left : view.top)) * view.cell * view.ratio);
            const pixel = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
            pixel.drawImage(map, -Math.floor(x), -Math.floor(y));
            return [...pixel.getImageData(0, 0, 1, 1).data]""", x, y)

    def test_it_is_pale_on_the_map_and_where_its_robots_were(self):
        """At 30 s robot 0's ghost is at (4.5, 3.5)."""
        for scheme in ("light", "dark"):
            self.browser.media(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            seen = []
            for shown in (True, False):
                self.open_with_ghost()
                if not shown:
                    self.browser.click("#show-ghost")
                self.scrub(30)
                self.browser.draw(2)
                seen.append(self.pixel(4.7, 3.6))
            there, gone = seen
            self.assertNotEqual(there, gone)
            self.assertLess(max(there[:3]) - min(there[:3]), 60, "it has no robot's colour")

    def test_signals_between_robots_are_counted_as_they_are_sent(self):
        self.open_replay(said=[[20.3, 3], [23.7, 11]])
        for t, count in ((20.2, 0), (20.3, 3), (23.6, 3), (30, 11)):
            self.scrub(t)
            self.assert_shows("messages-terminate", count)
        self.scrub(SAMPLE["duration"])
        self.assert_shows("messages-terminate", SAMPLE["result"]["messages"]["terminate"])

    def test_a_phone_shows_both_and_the_map_on_its_first_screen(self):
        for scheme in ("light", "dark"):
            self.browser.resize(390, 844, 3)
            self.browser.media(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            self.open_with_ghost()
            self.scrub(DURATION)
            bottom = self.browser.run("return document.querySelector('#map').getBoundingClientRect().bottom + scrollY")
            self.assertLess(bottom, 844)
            self.browser.wait_for("const e = document.documentElement; return e.scrollWidth === e.clientWidth")
