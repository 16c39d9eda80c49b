"""What the page shows of a replay: numbers, map, places, in any width and light."""

import copy
import json

from pages import NUMBERS, OPEN_PLACES, SAMPLE, SCANS, Pages, told_events


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
        past = [event["t"] for event in told_events() if event["t"] <= t]
        marks = [event["t"] for event in told_events() if event["t"] <= t and event["kind"] != "end"]
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

    def test_a_place_that_is_shut_is_told_so_unless_it_was_scanned(self):
        shut = [{"t": 2, "kind": "shut", "place": place, "x": 5.5, "y": 14.5, "text": "shut"} for place in (0, 1)]
        self.open_replay(events=[{"t": 1, "kind": "scanned", "place": 0, "robot": 0, "text": "scanned"}, *shut])
        self.browser.run(OPEN_PLACES)
        states = "return [...document.querySelectorAll('#place-rows tr')].map(row => row.cells[5].textContent)"
        self.scrub(1.5)
        self.assertEqual(self.browser.run(states)[:3], ["clear", "suspected", "suspected"])
        self.scrub(2.5)
        self.assertEqual(self.browser.run(states)[:3], ["clear", "shut", "suspected"])

    def test_the_legend_has_every_mark_of_the_time_line(self):
        self.open_replay()
        used = "return [...document.querySelectorAll(arguments[0])].map(use => use.getAttribute('href'))"
        marks = set(self.browser.run(used, "#marks use")) - {"#icon-other"}
        self.assertIn("#icon-territory_done", marks)
        self.assertEqual(marks - set(self.browser.run(used, "#legend use")), set())

    def test_eight_robots_stand_out_from_the_ground_on_a_light_page_and_on_a_dark_one(self):
        """Their colours' contrast with the ground is 1.7 to 1 or more (WCAG's measure), dark 3.5 to 1."""
        script = """
            const light = (text) => text.match(/[0-9.]+/g).slice(0, 3).map((part) => part / 255)
              .map((part) => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4)
              .reduce((sum, part, k) => sum + part * [0.2126, 0.7152, 0.0722][k], 0.05);
            const probe = document.body.appendChild(document.createElement("i"));
            probe.style.color = style.ground;
            const ground = light(getComputedStyle(probe).color);
            return Math.min(...[0, 1, 2, 3, 4, 5, 6, 7].map((robot) => light(colour(robot)))
              .map((robot) => Math.max(robot, ground) / Math.min(robot, ground)))"""
        for scheme, least in (("light", 1.7), ("dark", 3.5)):
            self.browser.media(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            self.open_replay()
            self.assertGreater(self.browser.run(script), least, scheme)

    def test_the_numbers_of_places_stand_under_one_another(self):
        """Each column has as many decimals in all rows."""
        self.open_replay()
        self.scrub(SAMPLE["duration"])
        self.browser.run(OPEN_PLACES)
        column = "return [...document.querySelectorAll('#place-rows tr')].map(row => row.cells[arguments[0]].textContent)"
        scanned = {}
        for event in SAMPLE["events"]:
            if event["kind"] in SCANS:
                scanned.setdefault(event["place"], event["t"])
        places = range(len(SAMPLE["places"]))
        self.assertEqual(self.browser.run(column, 1), [f"{SAMPLE['places'][p]['likelihood']:.4f}" for p in places])
        self.assertEqual(self.browser.run(column, 4), [f"{scanned[p]:.2f}" for p in places])

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

    def labels_of_places(self):
        """What is written beside the places, as the page draws it: the last of all labels."""
        labels = self.browser.run("""
            const drawn = [], plain = window.label;
            window.label = (context, text, x, y, ...rest) => { drawn.push([text, x, y]); plain(context, text, x, y, ...rest); };
            show();
            window.label = plain;
            return drawn;""")
        return labels[-len(SAMPLE["places"]):]

    def test_no_number_of_a_place_lies_under_a_robot(self):
        """Each place's number is drawn after the robots, at a corner of the place that no robot is at."""
        self.open_replay()
        self.scrub(1)
        labels = self.labels_of_places()
        self.assertEqual([text for text, _, _ in labels], [str(place) for place in range(len(SAMPLE["places"]))])
        corner = """return cornerOf(view.cell * (view.left + 3), view.cell * (view.top + 3), view.cell,
            arguments[0].map(([x, y]) => ({ x: view.cell * (view.left + x), y: view.cell * (view.top + y), reach: view.cell / 2 })))
            .map((at, axis) => Math.round(at / view.cell - (axis === 0 ? view.left : view.top)))"""
        for robots, expected in (([], [4, 2]), ([[4, 2]], [2, 2]), ([[4, 2], [2, 2]], [4, 4]),
                                 ([[4, 2], [2, 2], [4, 4]], [2, 4]), ([[4, 2], [2, 2], [4, 4], [2, 4]], [4, 2])):
            self.assertEqual(self.browser.run(corner, robots), expected)

    def test_places_go_by_their_names_on_the_map(self):
        """Whole where there is room, cut on a map as narrow as a phone's; no name lies on another one."""
        names = ["Well", "B07", "Washing machine", *(f"Orchard C{number:02}" for number in range(3, len(SAMPLE["places"])))]
        places = [{**place, "name": name} for place, name in zip(SAMPLE["places"], names)]
        for width, expected in ((1280, names[:4]), (390, ["Well", "B07", "Washing…", "Orchard…"])):
            self.browser.resize(width, 844)
            self.open_replay(places=places)
            self.browser.draw(2)
            labels = self.labels_of_places()
            self.assertEqual([text for text, _, _ in labels[:4]], expected)
            near = [(one, other) for at, one in enumerate(labels) for other in labels[:at]
                    if abs(one[2] - other[2]) < 10 and abs(one[1] - other[1]) < 3 * (len(one[0]) + len(other[0]) - 2)]
            self.assertEqual(near, [])

    def test_the_charts_figures_lie_inside_it(self):
        for duration in (807.9, 98.5, 400.0, 41.2):
            self.open_replay(duration=duration, plan=[[0, 0.5], [duration, 1]])
            outside = self.browser.run("""
                const edge = document.querySelector("#chart").getBoundingClientRect();
                return [...document.querySelectorAll("#chart text")].map((text) => text.getBoundingClientRect())
                    .filter((box) => box.width > 0 && (box.left < edge.left - 0.5 || box.right > edge.right + 0.5)).length""")
            self.assertEqual(outside, 0, duration)

    def move(self, many, left, top):
        """Whatever has a place on the map."""
        for one in many:
            if "x" in one:
                one.update(x=one["x"] + left, y=one["y"] + top)

    def walled(self, left, top, right, bottom):
        """The sample within walls of so many cells on each side."""
        told = copy.deepcopy(SAMPLE)
        width = left + told["map"]["columns"] + right
        rows = ["#" * width] * top + ["#" * left + row + "#" * right for row in told["map"]["rows_text"]]
        rows += ["#" * width] * bottom
        told["map"].update(columns=width, rows=len(rows), rows_text=rows)
        self.move(told["places"], left, top)
        told["starts"] = [[x + left, y + top] for x, y in told["starts"]]
        told["routes"] = [[[x + left, y + top] for x, y in route] for route in told["routes"]]
        self.move(told["events"], left, top)
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

    def test_a_door_that_is_shut_and_a_robot_without_power_are_marked_from_then_on(self):
        door = next(event for event in SAMPLE["events"] if event["kind"] == "shut")
        bars = []
        for t, kind in ((10.0, "moving"), (11.0, "reset"), (13.0, "moving")):
            self.open_replay()
            self.scrub(t)
            self.browser.draw(2)
            bars.append(self.browser.run("""
                const [left, right, y, columns] = arguments, map = document.querySelector("#map"), cell = map.width / columns;
                const image = new Uint32Array(map.getContext("2d").getImageData(0, 0, map.width, map.height).data.buffer);
                return [left, right].map((x) => image[Math.floor(y * cell) * map.width + Math.floor(x * cell)])""",
                door["x"] - 1 / 6, door["x"] + 1 / 6, door["y"], SAMPLE["map"]["columns"]))
            self.assertEqual(self.browser.run("return player.state.robots[2].kind"), kind)
        self.assertTrue(all(before != after for before, after in zip(bars[0], bars[1])), bars)
        self.assertEqual(bars[1], bars[2])

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
