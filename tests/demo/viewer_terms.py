"""What the page shows of the field's terms: looks that miss and are repeated, batteries that end, a mission's own seconds."""

import copy
import json

from pages import SAMPLE, Pages

PLACE, LOOKS = 4, [0.09, 0.02]  # robot 1's first place, and what each look at it counts
MISSED, AGAIN, LOW, HOME = 13.2, 14.5, 20.4, 24.0  # robot 1 misses, looks again, is low on battery in place of lost, is home


def places():
    changed = copy.deepcopy(SAMPLE["places"])
    changed[PLACE]["looks"] = LOOKS
    return changed


def events():
    """The sample's with a look that misses, a second one, and a battery that ends where robot 1 was lost."""
    changed = [event for event in copy.deepcopy(SAMPLE["events"]) if event["t"] != MISSED and event["kind"] != "lost"]
    own = [(MISSED, "missed", "scanned place 4 and missed what is there", PLACE), (AGAIN, "looked", "scanned place 4 again: clear", PLACE),
           (LOW, "battery", "is low on battery: it goes home", None), (HOME, "home", "is home", None)]
    for t, kind, text, place in own:
        changed.append({"t": t, "kind": kind, "robot": 1, "text": f"robot 1 {text}", **({} if place is None else {"place": place})})
    return sorted(changed, key=lambda event: event["t"])


class Terms(Pages):
    def open_terms(self, **changes):
        self.open_replay(**{"places": places(), "events": events(), "tires": True, "pace": 2.5, **changes})

    def legend(self):
        return self.browser.run("return [...document.querySelectorAll('.of-terms')].filter((e) => e.checkVisibility()).length")

    def row(self, kind):
        """(text, whether it stands out) of an event of this kind in the list."""
        return self.browser.run("""const b = document.querySelector(`#events button[data-kind="${arguments[0]}"]`);
            return [b.querySelector('.what').textContent, b.classList.contains('fault')]""", kind)

    def test_the_legend_names_what_there_is(self):
        self.open_replay()
        self.assertEqual(self.legend(), 0)
        self.assertNotIn("battery", self.browser.text("#sentence"))
        self.open_terms()
        self.assertEqual(self.legend(), 4)
        self.assertIn("A look may miss what is there, and who is low on battery goes home.", self.browser.text("#sentence"))
        self.open_terms(tires=False)
        self.assertIn("A look may miss what is there.", self.browser.text("#sentence"))

    def test_a_look_counts_what_it_is_worth_and_a_place_once(self):
        self.open_terms()
        likelihood, scanned = 0.0, set()
        looks = [0] * len(SAMPLE["places"])
        for event in events():
            if event["kind"] not in ("scanned", "looked", "missed", "found"):
                continue
            worth = places()[event["place"]].get("looks", [SAMPLE["places"][event["place"]]["likelihood"]])
            likelihood += worth[looks[event["place"]]] if looks[event["place"]] < len(worth) else 0.0
            looks[event["place"]] += 1
            scanned.add(event["place"])
            self.scrub(event["t"])
            self.assertEqual(self.browser.text("#scanned"), str(len(scanned)))
            self.assertAlmostEqual(float(self.browser.attribute("#achieved-now", "data-value")), likelihood)

    def test_a_miss_and_a_low_battery_stand_out_and_are_no_faults(self):
        self.open_terms()
        self.scrub(MISSED)
        self.assertEqual(self.row("missed"), ["robot 1 scanned place 4 and missed what is there", True])
        self.assertEqual(self.browser.text("#story-text"), "Robot 1 scanned place 4 and missed what is there.")
        self.assertEqual(self.browser.attribute("#story-icon", "href"), "#icon-missed")
        faults = self.browser.text("#faults")
        self.scrub(LOW)
        self.assertEqual(self.row("battery"), ["robot 1 is low on battery: it goes home", True])
        self.assertEqual(self.browser.text("#faults"), "4 faults so far")
        self.assertEqual(faults, "3 faults so far")
        self.assertEqual(self.row("looked"), ["robot 1 scanned place 4 again: clear", False])

    def test_what_a_tired_robot_leaves_another_takes_over(self):
        self.open_terms()
        self.scrub(LOW)
        words = self.browser.run("return [...document.querySelectorAll('#events button[data-kind=takeover] .what')].map((e) => e.textContent)")
        self.assertEqual(words, ["robot 0 takes over what robot 1 left: 2 places"])
        self.scrub(HOME)
        self.assertEqual(self.row("home"), ["robot 1 is home", False])

    def test_looks_that_are_none_are_refused(self):
        for looks in ([], "two", [0.1, None], 3):
            with self.subTest(looks):
                broken = places()
                broken[PLACE]["looks"] = looks
                self.open_replay_refused(broken)

    def open_replay_refused(self, broken):
        self.open_text(json.dumps({**copy.deepcopy(SAMPLE), "places": broken}))
        self.wait_until("#problem:not([hidden])")
        self.assertEqual(self.browser.text("#problem"), "This replay is damaged: its places cannot be read.")
