"""test_export.py --quarter PATH [--no-proj] [unittest's words]: what `quarter export` writes, read back by other parsers.

What is expected comes from `quarter inspect --json` (map, frame, routes) and from geodesics of geographiclib.
"""

import argparse
import json
import math
import random
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "demo"))

from geographiclib.geodesic import Geodesic  # noqa: E402

import export_readers as readers  # noqa: E402
from side_by_side import Telling  # noqa: E402

asked = argparse.Namespace()
CSV, ONE_FILE = "csv", ("csv", "geojson", "gpx")
DEGREES = ("geojson", "gpx", "qgc-plan", "qgc-wpl")
READERS = {"csv": readers.read_csv, "geojson": readers.read_geojson, "gpx": readers.read_gpx,
           "qgc-plan": readers.read_qgc_plan, "nav2": readers.read_nav2, "moos": readers.read_moos}


def quarter(*words, status=0):
    done = subprocess.run([asked.quarter, *map(str, words)], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    assert done.returncode == status, (words, done.returncode, done.stderr)
    return done.stdout.decode(), done.stderr.decode()


class Mission:
    """A mission on disk and learnt; and what its table says of itself."""

    def __init__(self, folder, seed, metric=True, geo=True, turned=True, robots=3):
        self.folder, self.random, self.robots = Path(folder), random.Random(seed), robots
        self.columns, self.rows = 14, 11
        self.draw()
        text = self.metric_map(turned) if metric else self.drawn_map()
        if geo:
            self.latitude, self.longitude = self.random.uniform(-80, 80), self.random.uniform(-180, 180)
            self.yaw = self.random.uniform(-3, 3)
            text += f"geo: {{latitude: {self.latitude:.7f}, longitude: {self.longitude:.7f}, yaw: {self.yaw:.6f}}}\n"
        (self.folder / "mission.yaml").write_text(text, encoding="utf-8")
        self.table = self.folder / "m.qtr"
        quarter("learn", self.folder / "mission.yaml", "-o", self.table, "-q", "--skip-unreachable")
        self.look()

    def draw(self):
        """Free cells, walls and slow ground; places and starts in the part that the first start reaches."""
        cells = ["".join(self.random.choices("#.~", (25, 65, 10), k=self.columns)) for _ in range(self.rows)]
        self.cells = [list(row) for row in cells]
        free = [(c, r) for r in range(self.rows) for c in range(self.columns) if self.cells[r][c] != "#"]
        self.chosen = self.random.sample(free, 7)

    def drawn_map(self):
        (self.folder / "map.txt").write_text("\n".join(map("".join, self.cells)) + "\n", encoding="utf-8")
        return "map: map.txt\n" + self.positions()

    def metric_map(self, turned):
        pixels = bytes(0 if cell == "#" else 254 for row in self.cells for cell in row)
        (self.folder / "map.pgm").write_bytes(b"P5 %d %d 255\n" % (self.columns, self.rows) + pixels)
        yaw = self.random.uniform(-3, 3) if turned else 0
        about = (f"image: map.pgm\nresolution: 0.4\norigin: [-3.25, 7.5, {yaw:.6f}]\nnegate: 0\noccupied_thresh: 0.65\n"
                 "free_thresh: 0.196\n")
        (self.folder / "map.yaml").write_text(about, encoding="utf-8")
        return "map: map.yaml\n" + self.positions()

    def positions(self):
        starts = [self.chosen[0]] * self.robots
        rows = [f"  - {{column: {c}, row: {r}}}\n" for c, r in starts]
        return "robots:\n" + "".join(rows) + "places:\n" + "".join(
            f"  - {{column: {c}, row: {r}, weight: {weight}}}\n" for weight, (c, r) in enumerate(self.chosen, 1))

    def look(self):
        self.told = json.loads(quarter("inspect", self.table, "--json")[0])
        numbers = [place.get("number", index) for index, place in enumerate(self.told["place"])]
        self.place = dict(zip(numbers, self.told["place"]))
        self.visits = {route["seeker"]: list(zip(route["places"], route["steps"])) for route in self.told["routes"]}

    def say_step_time(self, microseconds):
        """As the mission's speed would: the header's field, and its sum made right."""
        raw = bytearray(self.table.read_bytes())
        size, = struct.unpack_from("<I", raw, 8)
        struct.pack_into("<I", raw, 100, microseconds)
        struct.pack_into("<I", raw, 12, zlib.crc32(raw[16:size]))
        self.table.write_bytes(raw)

    def metres(self, column, row):
        """The middle of a cell in the map frame."""
        across, up = self.told["cell_size"] * (column + 0.5), self.told["cell_size"] * (self.told["rows"] - row - 0.5)
        turn = self.told.get("yaw", 0.0)
        return (self.told["origin_x"] + math.cos(turn) * across - math.sin(turn) * up,
                self.told["origin_y"] + math.sin(turn) * across + math.cos(turn) * up)

    def on_globe(self, column, row):
        """Metres east and north of the geographic origin."""
        x, y = self.metres(column, row)
        yaw = self.told["geo"]["yaw"] if "geo" in self.told else 0.0
        return math.cos(yaw) * x - math.sin(yaw) * y, math.sin(yaw) * x + math.cos(yaw) * y

    def cost(self, column, row):
        sign = self.told["map"][row][column]
        return 0 if sign == "#" else 1 if sign == "." else int(sign)

    def export(self, form, *words):
        """{robot: points} of what is written, each file read back."""
        if form in ONE_FILE:
            path = self.folder / f"out.{form}"
            quarter("export", self.table, "--format", form, "-q", "-o", path, *words)
            return READERS[form](path.read_text(encoding="utf-8"))
        quarter("export", self.table, "--format", form, "-q", "-o", self.folder / "out-%.file", *words)
        ways = {}
        for robot in self.visits:
            path = self.folder / f"out-{robot}.file"
            more = {"path": path} if form == "qgc-wpl" else {}
            read = readers.read_qgc_wpl if form == "qgc-wpl" else READERS[form]
            ways.update(read(path.read_text(encoding="utf-8"), robot, **more))
        return ways


class Case(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="quarter-export-", dir=".")
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name).resolve()

    def missions(self, count, **settings):
        for seed in range(count):
            folder = self.folder / str(seed)
            folder.mkdir()
            print(f"{self.id()}: seed {seed}")
            yield Mission(folder, seed, **settings)


class TestWays(Case):
    """The CSV file against the table's own account of itself."""

    def check_leg(self, mission, here, there):
        """A straight walk over free cells, which takes what entering them takes."""
        self.assertTrue(here.column == there.column or here.row == there.row)
        columns = (there.column > here.column) - (there.column < here.column)
        rows = (there.row > here.row) - (there.row < here.row)
        column, row, step = here.column, here.row, here.step
        while (column, row) != (there.column, there.row):
            column, row = column + columns, row + rows
            self.assertGreater(mission.cost(column, row), 0, "a waypoint's line crosses what is blocked")
            step += mission.cost(column, row)
        self.assertEqual(step, there.step)

    def check_way(self, mission, robot, points):
        visits = [(point.place, point.step) for point in points if point.place >= 0]
        self.assertEqual(visits, mission.visits[robot])
        start = mission.told["start"][robot]
        self.assertEqual((points[0].column, points[0].row, points[0].step), (start["column"], start["row"], 0))
        for point in points:
            if point.place >= 0:
                at = mission.place[point.place]
                self.assertEqual((point.column, point.row), (at["column"], at["row"]))
        for here, there in zip(points, points[1:]):
            self.check_leg(mission, here, there)

    def test_a_line_between_waypoints_stays_on_free_cells_and_takes_its_time(self):
        for mission in self.missions(25, metric=False, geo=False):
            ways = mission.export("csv")
            self.assertEqual(ways.keys(), mission.visits.keys())
            for robot, points in ways.items():
                self.check_way(mission, robot, points)

    def test_corners_alone_are_kept(self):
        for mission in self.missions(10, metric=False, geo=False):
            for points in mission.export("csv").values():
                for before, here, after in zip(points, points[1:], points[2:]):
                    straight = (before.column == here.column == after.column or before.row == here.row == after.row)
                    self.assertTrue(not straight or here.place >= 0)

    def test_places_alone_leave_the_corners_out(self):
        for mission in self.missions(5, metric=False, geo=False):
            whole, places = mission.export("csv"), mission.export("csv", "--places")
            for robot, points in places.items():
                self.assertEqual(points[1:], [point for point in whole[robot][1:] if point.place >= 0])

    def test_one_robot_alone_can_be_asked_for(self):
        for mission in self.missions(1, metric=False, geo=False):
            self.assertEqual(mission.export("csv", "--robot", 1), {1: mission.export("csv")[1]})


class TestFormats(Case):
    """Each format against the CSV file, which TestWays has checked, and against geodesics."""

    def expected(self, form, points):
        """What of the way a format holds: where the robot goes, and home before it."""
        going = points if points[0].place >= 0 else points[1:]
        return going if form == "nav2" else points[:1] + going if form == "qgc-wpl" else points

    def check_point(self, mission, want, point):
        half = mission.told["cell_size"] / 2
        if not math.isnan(point.x):
            self.assertLess(math.dist((point.x, point.y), mission.metres(want.column, want.row)), half / 100)
        if not math.isnan(point.east):
            self.assertLess(math.dist((point.east, point.north), mission.on_globe(want.column, want.row)), half / 100)
        if not math.isnan(point.latitude):
            east, north = mission.on_globe(want.column, want.row)
            origin = mission.told["geo"]
            there = Geodesic.WGS84.Direct(origin["latitude"], origin["longitude"],
                                          math.degrees(math.atan2(east, north)), math.hypot(east, north))
            apart = Geodesic.WGS84.Inverse(there["lat2"], there["lon2"], point.latitude, point.longitude)["s12"]
            self.assertLess(apart, half / 100)
        if point.step >= 0:
            self.assertEqual(point.step, want.step)

    def check(self, form, mission):
        wanted, ways = mission.export("csv"), mission.export(form)
        self.assertEqual(ways.keys(), wanted.keys())
        for robot, points in ways.items():
            held = self.expected(form, wanted[robot])
            self.assertEqual(len(points), len(held))
            for want, point in zip(held, points):
                self.check_point(mission, want, point)
            steps = [point.step for point in points if point.step >= 0]
            self.assertEqual(steps, sorted(set(steps)), "times ascend")
            places = [point.place for point in points if point.place >= 0]
            if form in ("csv", "geojson", "gpx"):
                self.assertEqual(places, [place for place, _ in mission.visits[robot]])

    def check_form(self, form, **settings):
        if form in DEGREES and asked.no_proj:
            self.skipTest("PROJ was not there when Quarter was built")
        for mission in self.missions(8, **settings):
            self.check(form, mission)

    def test_csv_in_metres(self):
        self.check_form("csv", geo=False)

    def test_nav2(self):
        self.check_form("nav2", geo=False)

    def test_moos_in_the_map_frame(self):
        self.check_form("moos", geo=False)

    def test_moos_east_and_north_where_the_origin_is_known(self):
        self.check_form("moos")

    def test_geojson(self):
        self.check_form("geojson")

    def test_gpx(self):
        self.check_form("gpx")

    def test_qgc_plan(self):
        self.check_form("qgc-plan")

    def test_qgc_wpl(self):
        self.check_form("qgc-wpl")

    def test_nav2_looks_where_it_goes(self):
        for mission in self.missions(3, geo=False):
            for points in mission.export("nav2").values():
                for here, there in zip(points, points[1:]):
                    wanted = math.atan2(there.y - here.y, there.x - here.x)
                    self.assertAlmostEqual(math.remainder(here.heading - wanted, math.tau), 0.0, places=5)


class TestTimesAndDrones(Case):
    def test_seconds_are_told_where_the_table_knows_them(self):
        for mission in self.missions(2):
            mission.say_step_time(250000)
            for form in ("csv",) + (() if asked.no_proj else ("geojson", "gpx")):
                for points in mission.export(form).values():
                    told = [point for point in points if not math.isnan(point.seconds)]
                    self.assertGreaterEqual(len(told), 1)
                    for point in told:
                        self.assertAlmostEqual(point.seconds, 0.25 * point.step, places=6)

    def fly(self, rising, points, places):
        """It takes off by item `rising`, and holds at each place behind that."""
        self.assertEqual([point.more["command"] for point in points], [16] * rising + [22] + [16] * len(points[rising + 1:]))
        self.assertEqual({point.more["altitude"] for point in points}, {12.5})
        self.assertEqual([point.hold for point in points if point.hold != 0.0], [30.0] * places)

    def test_a_drone_takes_off_and_holds_at_places(self):
        if asked.no_proj:
            self.skipTest("PROJ was not there when Quarter was built")
        for mission in self.missions(2):
            places = {robot: len(visits) for robot, visits in mission.visits.items()}
            for rising, form in enumerate(("qgc-plan", "qgc-wpl")):
                for robot, points in mission.export(form, "--altitude", 12.5, "--hold", 30).items():
                    self.fly(rising, points, places[robot])


class Scanning(Mission):
    """Scans take time: by the place, or the robot's class, or the mission. Places are looked at twice."""

    SCANS = {0: 7, 3: 0.5}  # of places
    CLASSES = {"slow": 12.25, "quick": None}
    BY_DEFAULT = 4

    def positions(self):
        start = self.chosen[0]
        rows = [f"  - {{column: {start[0]}, row: {start[1]}, class: {name}}}\n" for name in self.classes_of_robots()]
        places = [f"  - {{column: {c}, row: {r}, weight: {weight}{self.scan_key(weight - 1)}}}\n"
                  for weight, (c, r) in enumerate(self.chosen[:5], 1)]
        return ("classes:\n  slow: {speed: 0.5, scan_seconds: 12.25}\n  quick: {speed: 1.5}\n"
                f"scan_seconds: {self.BY_DEFAULT}\ndetection: 0.8\nlooks: 2\nrobots:\n" + "".join(rows) + "places:\n" + "".join(places))

    @staticmethod
    def classes_of_robots():
        return ["slow", "quick", "quick"]

    def scan_key(self, place):
        return f", scan_seconds: {self.SCANS[place]}" if place in self.SCANS else ""

    def scan(self, robot, place):
        of_class = self.CLASSES[self.classes_of_robots()[robot]]
        return self.SCANS.get(place, self.BY_DEFAULT if of_class is None else of_class)


class TestScans(Case):
    def missions(self, count, **settings):
        for seed in range(count):
            folder = self.folder / str(seed)
            folder.mkdir()
            yield Scanning(folder, seed, **settings)

    def held(self, mission, form, *words):
        """{robot: seconds at each place that it goes to, in order}; the mission's table says the order."""
        ways = mission.export(form, "--places", *words)
        for robot, points in ways.items():
            visits = mission.visits[robot]
            yield robot, [place for place, _ in visits], [point.hold for point in points][len(points) - len(visits):]

    def check(self, form, **settings):
        if form in DEGREES and asked.no_proj:
            self.skipTest("PROJ was not there when Quarter was built")
        places_seen = set()
        for mission in self.missions(6, **settings):
            step = mission.told["seconds_per_step"]
            for robot, places, held in self.held(mission, form):
                for place, seconds in zip(places, held, strict=True):
                    wanted = mission.scan(robot, place)
                    self.assertTrue(wanted - 1e-6 <= seconds < wanted + step, (robot, place, seconds, wanted, step))
                    places_seen.add(place)
            for words, wanted in ((("--hold", 30), 30.0), (("--hold", 0), 0.0)):
                for _, _, held in self.held(mission, form, *words):
                    self.assertEqual(set(held) - {wanted}, set())
        self.assertEqual(len(places_seen), 5)

    def test_csv_tells_each_scan(self):
        self.check("csv", geo=False)

    def test_geojson_tells_each_scan(self):
        self.check("geojson")

    def test_a_qgc_plan_stops_for_each_scan(self):
        self.check("qgc-plan")

    def test_a_qgc_wpl_stops_for_each_scan(self):
        self.check("qgc-wpl")


class TestRefusals(Case):
    def refuse(self, mission, output, *words, expected):
        _, err = quarter("export", mission.table, "-o", self.folder / output, *words, status=2)
        self.assertEqual(err.count("\n"), 1, err)
        for part in expected:
            self.assertIn(part, err)
        self.assertEqual([path.name for path in self.folder.glob("way*")], [])

    def test_degrees_without_an_origin_name_the_key(self):
        for mission in self.missions(1, geo=False):
            for form in DEGREES:
                self.refuse(mission, "way-%", "--format", form, expected=["'geo: {latitude", form])

    def test_metres_on_a_map_without_them_name_the_key(self):
        for mission in self.missions(1, metric=False, geo=False):
            for form in ("nav2", "moos", "gpx"):
                self.refuse(mission, "way-%", "--format", form, expected=["'cell_size'", form])

    def test_several_robots_in_a_file_for_one_name_the_ways_out(self):
        for mission in self.missions(1, geo=False):
            self.refuse(mission, "way.yaml", expected=["nav2", "way-%.yaml", "--robot 0"])

    def test_formats_and_robots_that_are_not_there(self):
        for mission in self.missions(1):
            self.refuse(mission, "way.xyz", expected=["--format"])
            self.refuse(mission, "way.csv", "--format", "gpz", expected=["gpx"])
            self.refuse(mission, "way.csv", "--robot", 3, expected=["robots 0 to 2"])

    def test_of_several_files_none_is_written_where_one_cannot_be(self):
        for mission in self.missions(1, geo=False):
            (self.folder / "out-1.yaml").mkdir()
            quarter("export", mission.table, "-o", self.folder / "out-%.yaml", status=2)
            self.assertEqual([path.name for path in self.folder.glob("out-*")], ["out-1.yaml"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quarter", required=True)
    parser.add_argument("--no-proj", action="store_true")
    _, rest = parser.parse_known_args(namespace=asked)
    asked.quarter = str(Path(asked.quarter).resolve())
    unittest.main(argv=[sys.argv[0], *rest], testRunner=Telling)


if __name__ == "__main__":
    main()
