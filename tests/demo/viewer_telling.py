"""What the page tells at a glance: what it is about, a loss and who takes over, what robots said to one another."""

import copy

from pages import SAMPLE, TAKEOVER, Pages

LOST, TAKEN = 15.0, 20.2  # robot 1 is lost before robot 0 is done, which searches its places later


def earlier_loss():
    """The sample's events, robot 1 lost while robot 0 still has places of its own."""
    events = copy.deepcopy(SAMPLE["events"])
    next(event for event in events if event["kind"] == "lost")["t"] = LOST
    return events


class Telling(Pages):
    def test_one_sentence_says_what_it_is_about(self):
        self.open_replay()
        sentence = self.browser.text("#sentence")
        self.assertEqual(sentence.count("."), 1)
        for part in (f"divided among {SAMPLE['robots']} robots beforehand", "so that the find comes early", "where one is lost"):
            self.assertIn(part, sentence)
        self.open_replay(mode="clear")
        self.assertIn("so that all of it is searched soon", self.browser.text("#sentence"))

    def test_a_loss_is_shouted_and_then_told(self):
        self.open_replay(events=earlier_loss())
        loud = "return ['#story', '#map'].map(id => document.querySelector(id).classList.contains('alarm'))"
        self.scrub(LOST - 0.1)
        self.assertEqual(self.browser.run(loud), [False, False])
        self.assertIn("3 robots set out", self.browser.text("#story"))
        self.scrub(LOST)
        self.assertEqual(self.browser.run(loud), [True, True])
        told = "Robot 1 is lost. Nobody is told: who is done with its own part comes for the 2 places that it left."
        self.assertEqual(self.browser.text("#story-text"), told)
        self.assertEqual(self.browser.attribute("#story-icon", "href"), "#icon-lost")
        self.browser.click("#speeds button[data-speed='1']")
        self.scrub(LOST + 3.1)
        self.assertEqual(self.browser.run(loud), [False, False])
        self.assertEqual(self.browser.text("#story-text"), told)
        self.scrub(TAKEN)
        self.assertEqual(self.browser.text("#story-text"), "Robot 0 takes over what robot 1 left: 2 places.")
        self.scrub(SAMPLE["duration"])
        self.assertEqual(self.browser.text("#story-text"), "Robot 0 found it at place 5.")

    def test_a_loss_is_loud_at_any_speed_it_is_played_at(self):
        self.open_replay(events=earlier_loss())
        self.browser.click("#speeds button[data-speed='20']")
        self.scrub(LOST + 4)
        self.assertEqual(self.browser.attribute("#map", "class"), "alarm")

    def test_a_loss_that_leaves_nothing_says_so(self):
        scan = {"kind": "scanned", "robot": 1}
        events = [{**scan, "t": t, "place": place} for t, place in ((1, 3), (2, 4), (3, 5))]
        self.open_replay(events=[*events, {"t": 4, "kind": "lost", "robot": 1}])
        self.scrub(5)
        self.assertEqual(self.browser.text("#story-text"), "Robot 1 is lost. Its part was searched.")

    def test_who_takes_over_is_an_event(self):
        self.open_replay()
        self.scrub(SAMPLE["duration"])
        row = "#events button[data-kind='takeover']"
        self.assertEqual(self.browser.text(f"{row} .what"), TAKEOVER["text"])
        self.assertEqual(float(self.browser.attribute(row, "data-t")), TAKEOVER["t"])
        self.assertEqual(self.browser.text(f"{row} .chip"), "0")
        self.browser.click(row)
        self.wait_time(TAKEOVER["t"])
        # At the moment of the loss it hides nothing of it.
        self.assertTrue(self.browser.text("#story-text").startswith("Robot 1 is lost. Robot 0 takes over"))

    def test_who_comes_second_helps(self):
        """Places 3, 4 and 5 are robot 1's."""
        scans = [{"t": t, "kind": "scanned", "robot": robot, "place": place} for t, robot, place in ((5, 0, 3), (6, 2, 5), (7, 0, 4))]
        self.open_replay(events=[{"t": 1, "kind": "lost", "robot": 1}, *scans])
        self.scrub(10)
        texts = "return [...document.querySelectorAll('#events [data-kind=takeover] .what')].map(e => e.textContent)"
        self.assertEqual(self.browser.run(texts), ["robot 0 takes over what robot 1 left: 3 places",
                                                   "robot 2 helps with what robot 1 left"])
        owners = "return player.state.owners.slice(3, 6).map(({ owner }) => owner)"
        self.assertEqual(self.browser.run(owners), [0, 0, 2])

    def test_who_takes_over_may_be_lost_too(self):
        events = [{"t": 1, "kind": "lost", "robot": 1}, {"t": 5, "kind": "scanned", "robot": 0, "place": 3},
                  {"t": 6, "kind": "lost", "robot": 0}, {"t": 9, "kind": "scanned", "robot": 2, "place": 4}]
        self.open_replay(events=events)
        for t, expected in ((1.5, [0, 0, 2]), (5.5, [0, 0, 2]), (6.5, [2, 2, 2]), (9.5, [2, 2, 2])):
            self.scrub(t)
            owners = self.browser.run("return [4, 5, 6].map((place) => player.state.owners[place].owner)")
            self.assertEqual(owners, expected, t)

    def ground_at(self, column, row):
        """The colour of a cell's ground, away from lines and routes."""
        return self.browser.run("""
            const [x, y] = [...arguments].map((at, axis) => (at + 0.3 - (axis === 0 ? view.left : view.top)) * view.cell * view.ratio);
            const pixel = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
            pixel.drawImage(view.ground, -Math.floor(x), -Math.floor(y));
            return [...pixel.getImageData(0, 0, 1, 1).data].slice(0, 3)""", column, row)

    def test_the_ground_of_a_lost_robot_loses_its_colour_and_takes_its_successors(self):
        """Cell (20, 5) lies by place 3, which is robot 1's; (7, 2) by place 1, which is robot 0's."""
        for scheme in ("light", "dark"):
            self.browser.media(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            self.open_replay(events=earlier_loss())
            seen = []
            for t in (LOST - 0.1, LOST, TAKEN):
                self.scrub(t)
                self.browser.draw(2)
                seen.append(self.ground_at(20, 5))
            own, left, taken = seen
            self.assertEqual(taken, self.ground_at(7, 2))
            self.assertEqual(len({tuple(colour) for colour in seen}), 3, seen)
            self.assertLess(max(left) - min(left), 20, "it is grey")
            self.assertGreater(max(own) - min(own), 5, "and was not")

    def test_what_robots_say_is_counted_apart_from_the_simulators_messages(self):
        self.open_replay()
        self.scrub(SAMPLE["duration"])
        under = """
            let heading = document.querySelector(arguments[0]).closest("dl");
            while (heading.tagName !== "H3") heading = heading.previousElementSibling;
            return heading.textContent"""
        for name in ("terminate", "lost", "ignored"):
            self.assertEqual(self.browser.run(under, f"#messages-{name}"), "Between robots")
        for name in ("pose", "scan", "command"):
            self.assertEqual(self.browser.run(under, f"#messages-{name}"), "The simulator’s own messages")

    def test_a_phone_reads_it_without_zoom(self):
        """At 390 px the sentence, what happens and the map stand on the first screen, in letters of 16 px or more."""
        for scheme in ("light", "dark"):
            self.browser.resize(390, 844, 3)
            self.browser.media(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            self.open_replay(events=earlier_loss())
            self.scrub(LOST)
            sizes = self.browser.run("""
                return ["#sentence", "#story"].map((id) => parseFloat(getComputedStyle(document.querySelector(id)).fontSize))""")
            self.assertGreaterEqual(min(sizes), 16)
            bottom = self.browser.run("return document.querySelector('#map').getBoundingClientRect().bottom + scrollY")
            self.assertLess(bottom, 844)
            self.browser.wait_for("const e = document.documentElement; return e.scrollWidth === e.clientWidth")
