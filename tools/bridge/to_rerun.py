"""Writes messages into a Rerun recording: all on the timeline `utime`, the world in metres with z up."""

import math

from events import BEHIND, Changes, Signals
from faults import missing

TIMELINE = "utime"
BATCH = 2000  # rows that are sent at once

# The colours of `quarter draw` (tools/draw_style.c).
PALETTE = [(0x00, 0x72, 0xB2), (0xD5, 0x5E, 0x00), (0x00, 0x9E, 0x73), (0xCC, 0x79, 0xA7), (0xE6, 0x9F, 0x00),
           (0x56, 0xB4, 0xE9), (0xB3, 0xA2, 0x00)]
NOBODY = (0x80, 0x80, 0x80)
WALL, FREE, DEAREST = 70, 250, 150  # grey levels of the map
MINE = (0xD0, 0x00, 0x20)
DISC, PLAN_Z, TRAIL_Z, ROBOT_Z = 0.02, 0.03, 0.04, 0.05  # cells above the map, so that one lies on the other
BODY = 0.4  # cells, a robot's radius in the picture


def colour(robot):
    if robot < 0:
        return NOBODY
    base = PALETTE[robot % len(PALETTE)]
    return [base, tuple(c * 11 // 20 for c in base), tuple(255 - (255 - c) * 11 // 20 for c in base)][
        robot // len(PALETTE) % 3]


def grey(cell):
    return WALL if cell == "#" else FREE if cell == "." else FREE - (FREE - DEAREST) * (int(cell) - 1) // 8


class Columns:
    """Rows of one entity, kept until there are enough to send."""

    def __init__(self, sink, entity, columns_of):
        self.sink, self.entity, self.columns_of = sink, entity, columns_of
        self.times, self.rows = [], []

    def add(self, utime, row):
        self.times.append(utime)
        self.rows.append(row)
        if len(self.rows) >= BATCH:
            self.send()

    def send(self):
        if self.rows:
            times = self.sink.rr.TimeColumn(TIMELINE, duration=self.sink.np.array(self.times, "timedelta64[us]"))
            self.sink.stream_columns(self.entity, times, self.columns_of(self.rows))
            self.times, self.rows = [], []


class RerunSink:
    name = "rerun"

    def __init__(self, path, mission, _types, title):
        try:
            import numpy
            import rerun
            import rerun.blueprint
        except ImportError:
            raise missing("rerun-sdk") from None
        self.rr, self.np, self.path, self.mission = rerun, numpy, path, mission
        rerun.set_strict_mode(True)
        self.stream = rerun.RecordingStream("quarter", send_properties=False)
        self.stream.set_log_time_enabled(False)
        self.stream.set_log_tick_enabled(False)
        self.cell = mission.cell if mission else 0.2
        # In memory to the end, which takes as much as the file: the SDK may wait for ever on a disk that is full.
        self.bytes = self.stream.binary_stream()
        self.stream.send_blueprint(self.blueprint())
        self.stream.send_recording_name(title)
        self.columns, self.poses, self.robots = {}, {}, set()
        self.changes, self.signals = Changes(), Signals()
        self.static("world", rerun.ViewCoordinates.RIGHT_HAND_Z_UP)
        if mission is not None:
            self.draw_map()
            self.draw_places()

    # What stands still

    def static(self, entity, what):
        self.stream.log(entity, what, static=True)

    def stream_columns(self, entity, times, columns):
        self.rr.send_columns(entity, [times], columns, recording=self.stream)

    def blueprint(self):
        rrb = self.rr.blueprint
        trail = rrb.VisibleTimeRanges(timeline=TIMELINE, start=rrb.TimeRangeBoundary.infinite(),
                                      end=rrb.TimeRangeBoundary.cursor_relative())
        world = rrb.Spatial3DView(origin="world", name="search", overrides={"world/trails": trail},
                                  eye_controls=self.eye(), line_grid=False)
        events = rrb.TextLogView(origin="events", contents=["$origin/**", "- $origin/terminate/repeats"], name="events")
        commands = rrb.TimeSeriesView(origin="commands", name="wheels, metres a second")
        return rrb.Blueprint(rrb.Horizontal(world, rrb.Vertical(events, commands), column_shares=[2, 1]),
                             rrb.TimePanel(timeline=TIMELINE), collapse_panels=True)

    def eye(self):
        """Straight above what the plan touches, else left to the viewer."""
        points = [*self.mission.places, *self.mission.starts] if self.mission else []
        if not points:
            return None
        low, high = ([pick(p[axis] for p in points) for axis in (0, 1)] for pick in (min, max))
        x, y = ((a + b) / 2 for a, b in zip(low, high))
        height = 1.6 * max(high[0] - low[0], high[1] - low[1]) + 6 * self.cell
        rrb = self.rr.blueprint
        return rrb.EyeControls3D(kind=rrb.Eye3DKind.Orbital, position=(x, y - height / 50, height),
                                 look_target=(x, y, 0), eye_up=(0, 0, 1))

    def draw_map(self):
        m, rr = self.mission, self.rr
        right, top = m.left + m.columns * m.cell, m.bottom + m.rows * m.cell
        corners = [(m.left, m.bottom), (right, m.bottom), (right, top), (m.left, top), (m.left, m.bottom)]
        self.static("world/border", rr.LineStrips3D([[(x, y, 0) for x, y in corners]], colors=[NOBODY]))
        if m.map is not None:
            shape = rr.components.ImageFormat(width=m.columns, height=m.rows, color_model="L", channel_datatype="U8")
            self.static("world/map", rr.GridMap(data=bytes(grey(cell) for row in m.map for cell in row), format=shape,
                                                cell_size=m.cell, translation=(m.left, m.bottom, 0),
                                                colormap=rr.components.Colormap.Grayscale))

    def draw_places(self):
        """A place is the larger the likelier, and has the colour of the robot whose territory it lies in."""
        m, rr = self.mission, self.rr
        most = max(m.likelihood, default=0) or 1
        radii = [m.cell * (0.25 + 0.5 * math.sqrt(p / most)) for p in m.likelihood]
        self.static("world/places", rr.Ellipsoids3D(
            centers=self.on(range(len(m.places))), half_sizes=[(r, r, DISC * m.cell) for r in radii],
            colors=[colour(m.owner.get(i, -1)) for i in range(len(radii))], fill_mode="solid",
            labels=[f"{i}: {100 * p:.3g} %" for i, p in enumerate(m.likelihood)], show_labels=True))
        for seeker in m.routes:
            points = [(x, y, PLAN_Z * m.cell) for x, y in m.planned(seeker)]
            if len(points) > 1:
                self.static(f"world/plan/{seeker}", rr.LineStrips3D(
                    [points], colors=[(*colour(seeker), 110)], radii=[rr.Radius.ui_points(1.5)]))

    def on(self, places, z=0.0):
        known = [place for place in places if place < len(self.mission.places)]
        return [(*self.mission.places[place], z * self.cell) for place in known]

    # What moves

    def rows(self, entity, columns_of):
        if entity not in self.columns:
            self.columns[entity] = Columns(self, entity, columns_of)
        return self.columns[entity]

    def add(self, message):
        """Whether the message went in."""
        getattr(self, message.kind)(message.utime, message.fields)
        return True

    def meet(self, robot):
        if robot in self.robots:
            return
        self.robots.add(robot)
        entity, rr, cell, own = f"world/robots/{robot}", self.rr, self.cell, [colour(robot)]
        middle = [(0, 0, BODY * cell)]
        self.static(f"{entity}/body", rr.Points3D(middle, radii=[BODY * cell], colors=own, labels=[f"robot {robot}"],
                                                  show_labels=False))
        self.static(f"{entity}/heading", rr.Arrows3D(origins=middle, vectors=[(1.2 * cell, 0, 0)], radii=[0.1 * cell],
                                                     colors=own))
        self.static(f"commands/{robot}", rr.SeriesLines(
            names=[f"robot {robot} left", f"robot {robot} right"],
            colors=[colour(robot), tuple((c + 255) // 2 for c in colour(robot))]))

    def pose(self, utime, pose):
        robot, at = pose["robot"], (pose["x"], pose["y"])
        self.meet(robot)
        self.rows(f"world/robots/{robot}", self.pose_columns).add(utime, (*at, pose["heading"]))
        last_time, last = self.poses.get(robot, (utime, at))
        if utime < last_time and last_time - utime <= BEHIND:
            return
        if utime >= last_time and last != at:
            self.rows("world/trails", self.trail_columns).add(utime, (robot, last, at))
        self.poses[robot] = utime, at

    def pose_columns(self, rows):
        x, y, heading = self.np.array(rows).T
        z, none = self.np.full(len(rows), ROBOT_Z * self.cell), self.np.zeros(len(rows))
        return self.rr.Transform3D.columns(
            translation=self.np.stack([x, y, z], axis=1),
            quaternion=self.np.stack([none, none, self.np.sin(heading / 2), self.np.cos(heading / 2)], axis=1))

    def trail_columns(self, rows):
        z = TRAIL_Z * self.cell
        return self.rr.LineStrips3D.columns(
            strips=[[(*a, z), (*b, z)] for _, a, b in rows], colors=[colour(robot) for robot, _, _ in rows],
            radii=[self.rr.Radius.ui_points(2)] * len(rows))

    def scan(self, utime, scan):
        """In the robot's own frame: its pose of that time says where."""
        self.meet(scan["robot"])
        rays = scan["range"]
        hits = [(r * math.cos(math.tau * i / len(rays)), r * math.sin(math.tau * i / len(rays)), 0.0)
                for i, r in enumerate(rays)]
        pale = (*colour(scan["robot"]), 120)
        self.rows(f"world/robots/{scan['robot']}/scan", lambda rows: self.rr.LineStrips3D.columns(
            strips=rows, colors=[pale] * len(rows))).add(utime, [*hits, hits[0]])

    def command(self, utime, command):
        self.meet(command["robot"])
        self.rows(f"commands/{command['robot']}", lambda rows: self.rr.Scalars.columns(
            scalars=[wheel for row in rows for wheel in row]).partition([2] * len(rows))).add(
                utime, (command["left"], command["right"]))

    def terminate(self, utime, terminate):
        event, repeated = self.signals.hear(utime, terminate)
        self.say("events/terminate/repeats" if repeated else "events/terminate", event)

    def status(self, utime, status):
        happened = self.changes.hear(utime, status)
        for event in happened:
            self.say("events/status", event)
        if self.mission is not None and happened:
            self.mark("world/scanned", utime, self.changes.scanned, (255, 255, 255), 0.2)
            self.mark("world/mines", utime, self.changes.found, MINE, 0.3)

    def say(self, entity, event):
        self.rows(entity, lambda events: self.rr.TextLog.columns(
            text=[e.text for e in events], level=[e.level for e in events],
            color=[colour(e.robot) for e in events])).add(event.utime, event)

    def mark(self, entity, utime, places, of, size):
        self.stream.set_time(TIMELINE, duration=self.np.timedelta64(utime, "us"))
        self.stream.log(entity, self.rr.Points3D(self.on(places, 0.1), colors=[of], radii=[size * self.cell]))
        self.stream.reset_time()

    def close(self):
        for columns in self.columns.values():
            columns.send()
        with open(self.path, "wb") as file:
            file.write(self.bytes.read())

    def drop(self):
        self.bytes.read()  # or the SDK complains about what nobody read
