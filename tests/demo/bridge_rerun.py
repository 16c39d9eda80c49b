"""Logs to Rerun."""

import json
import math
import re
import subprocess

from bridging import HAPPENED, MISSION, Bridge, asked, story, without_rerun


class TestRerun(Bridge):
    def chunks(self):
        """[(entity, is static, its table)]"""
        import rerun
        return [(c.entity_path, c.is_static, c.to_record_batch()) for c in
                rerun.chunk.RrdReader(str(self.rrd)).stream().to_chunks()]

    def column(self, table, ending):
        return next(table.column(i).to_pylist() for i, name in enumerate(table.schema.names) if name.endswith(ending))

    def times(self, table):
        import pyarrow
        return table.column(table.schema.get_field_index("utime")).cast(pyarrow.int64()).to_pylist()

    def moving(self, entity, ending):
        """[(nanoseconds, value)], flat"""
        return [(at, value[0]) for path, static, table in self.chunks() if path == entity and not static
                for at, value in zip(self.times(table), self.column(table, ending))]

    @without_rerun
    def test_the_recording_has_all_poses(self):
        self.convert(self.log(), "--table", self.table(), "--rerun", self.rrd)
        for robot in (0, 1):
            poses = [p for p in story()[1] if p["robot"] == robot]
            found = self.moving(f"/world/robots/{robot}", "translation")
            self.assertEqual([1000 * p["utime"] for p in poses], [at for at, _ in found])
            turned = self.moving(f"/world/robots/{robot}", "quaternion")
            for pose, (_, at), (_, turn) in zip(poses, found, turned):
                self.assertAlmostEqual(pose["x"], at[0], delta=1e-7)
                self.assertAlmostEqual(pose["y"], at[1], delta=1e-7)
                self.assertAlmostEqual(pose["heading"], 2 * math.atan2(turn[2], turn[3]), delta=1e-6)

    @without_rerun
    def test_the_recording_tells_what_happened_and_when(self):
        self.convert(self.log(), "--rerun", self.rrd)
        found = [(at // 1000, level, text) for entity in ("/events/status", "/events/terminate")
                 for (at, level), (_, text) in zip(self.moving(entity, "level"), self.moving(entity, "text"))]
        self.assertEqual(HAPPENED, sorted(found))
        self.assertEqual(9, len(self.moving("/events/terminate/repeats", "text")))

    @without_rerun
    def test_all_that_moves_is_on_the_timeline_of_the_world(self):
        self.convert(self.log(), "--table", self.table(), "--rerun", self.rrd)
        chunks = self.chunks()
        for entity, static, table in chunks:
            if not static:
                self.assertIn("utime", table.schema.names, entity)
                self.assertNotIn("log_time", table.schema.names, entity)
        self.assertLessEqual({f"/world/{e}" for e in ("border", "places", "plan/0", "plan/2", "robots/1/heading")},
                             {entity for entity, static, _ in chunks if static})
        self.assertLessEqual({"/world/trails", "/world/robots/0/scan", "/commands/1", "/world/mines", "/world/scanned"},
                             {entity for entity, static, _ in chunks if not static})

    @without_rerun
    def test_places_stand_where_the_mission_has_them(self):
        self.convert(self.log(), "--table", self.table(), "--rerun", self.rrd)
        (places,) = [table for entity, _, table in self.chunks() if entity == "/world/places"]
        stated = re.findall(r"(?m)^  - \{x: (\S+), y: (\S+), weight", MISSION.read_text(encoding="utf-8"))
        found = self.column(places, "centers")[0]
        self.assertEqual(14, len(stated))
        for (x, y), at in zip(stated, found):
            self.assertAlmostEqual(float(x), at[0], delta=0.1001)  # half a cell
            self.assertAlmostEqual(float(y), at[1], delta=0.1001)

    @without_rerun
    def test_without_metres_a_cell_is_one(self):
        drawing = self.folder / "map.txt"
        drawing.write_text("S..#\n....\n.#.5\n", encoding="utf-8")
        self.convert(self.log(), "--table", self.table(drawing), "--rerun", self.rrd)
        (places,) = [table for entity, _, table in self.chunks() if entity == "/world/places"]
        self.assertEqual([3.5, 0.5], self.column(places, "centers")[0][0][:2])
        (plan,) = [table for entity, _, table in self.chunks() if entity == "/world/plan/0"]
        self.assertEqual([[0.5, 2.5], [3.5, 0.5]], [p[:2] for p in self.column(plan, "strips")[0][0]])

    @without_rerun
    def test_the_map_is_drawn_as_inspect_tells_it(self):
        drawing = self.folder / "map.txt"
        drawing.write_text("S.#\n.3.\n", encoding="utf-8")
        table = self.table(drawing)
        told = json.loads(subprocess.check_output([asked.quarter, "inspect", str(table), "--json"]))
        told["map"] = [".2#", ".9."]
        tool = self.folder / "tool"
        tool.write_text(f"#!/bin/sh\ncat <<'END'\n{json.dumps(told)}\nEND\n", encoding="utf-8")
        tool.chmod(0o755)
        self.convert(self.log(), "--table", table, "--rerun", self.rrd, quarter=tool)
        (drawn,) = [table for entity, _, table in self.chunks() if entity == "/world/map"]
        self.assertEqual([250, 238, 70, 250, 150, 250], list(self.column(drawn, ":data")[0][0]))
