"""Exported plans read back by parsers that share nothing with Quarter, as {robot: [Point]}."""

import csv
import io
import json
import math
import re
from dataclasses import dataclass, field

import geojson
import gpxpy
from pymavlink import mavwp
from ruamel.yaml import YAML

geojson.geometry.DEFAULT_PRECISION = 9  # it would round to a decimetre

@dataclass(eq=False)
class Point:
    x: float = math.nan  # metres in the map frame
    y: float = math.nan
    east: float = math.nan  # metres east and north of the origin
    north: float = math.nan
    latitude: float = math.nan
    longitude: float = math.nan
    column: int = -1
    row: int = -1
    step: int = -1  # -1: the format does not say
    seconds: float = math.nan
    place: int = -1
    heading: float = math.nan
    hold: float = math.nan
    more: dict = field(default_factory=dict)

    # What a format does not tell is no number, which is equal to nothing, not even to itself.
    def __eq__(self, other):
        return repr(self) == repr(other)


def place_of(name):
    found = re.fullmatch(r"place (\d+)", name or "")
    return int(found.group(1)) if found else -1


def number(text):
    return float(text) if text else math.nan


def read_csv(text, robot=None):
    ways = {}
    for row in csv.DictReader(io.StringIO(text)):
        points = ways.setdefault(int(row["robot"]), [])
        assert int(row["waypoint"]) == len(points) and row["robot_name"] == f"robot {row['robot']}"
        assert place_of(row["place_name"]) == (int(row["place"]) if row["place"] else -1)
        points.append(Point(x=number(row["x"]), y=number(row["y"]), column=int(row["column"]), row=int(row["row"]),
                            step=int(row["step"]), seconds=number(row["seconds"]), place=place_of(row["place_name"]),
                            hold=number(row["hold_seconds"])))
    return ways


def read_geojson(text, robot=None):
    collection = geojson.loads(text)
    assert collection.is_valid, collection.errors()
    ways, places = {}, {}
    for feature in collection.features:
        told, where = feature.properties, feature.geometry.coordinates
        if feature.geometry.type == "LineString":
            ways[told["robot"]] = [Point(longitude=at[0], latitude=at[1], step=step)
                                   for at, step in zip(where, told["steps"], strict=True)]
        else:
            places.setdefault(told["robot"], []).append((where, told))
    for robot, stops in places.items():
        points = ways.setdefault(robot, [Point(longitude=stops[0][0][0], latitude=stops[0][0][1], step=0)])
        for where, told in stops:
            at = next(p for p in points if [p.longitude, p.latitude] == where and p.step == told["step"])
            at.place, at.seconds = told.get("place", -1), told.get("seconds", math.nan)
            at.hold = told.get("hold_seconds", math.nan)
            assert told["name"] == ("start" if at.place < 0 else f"place {at.place}")
    return ways


def read_gpx(text, robot=None):
    ways = {}
    for route in gpxpy.parse(text).routes:
        assert route.name == f"robot {route.number}"
        ways[route.number] = [
            Point(latitude=at.latitude, longitude=at.longitude, place=place_of(at.name),
                  step=int(re.fullmatch(r"step (\d+)", at.comment).group(1)),
                  seconds=at.time.timestamp() if at.time else math.nan) for at in route.points]
    return ways


def read_qgc_plan(text, robot):
    plan = json.loads(text)
    assert (plan["fileType"], plan["version"], plan["mission"]["version"]) == ("Plan", 1, 2)
    assert {"cruiseSpeed", "hoverSpeed", "firmwareType", "plannedHomePosition", "vehicleType"} <= plan["mission"].keys()
    points = []
    for index, item in enumerate(plan["mission"]["items"], 1):
        assert item["type"] == "SimpleItem" and item["doJumpId"] == index and item["frame"] == 3
        assert len(item["params"]) == 7 and item["autoContinue"] is True
        points.append(Point(latitude=item["params"][4], longitude=item["params"][5], hold=item["params"][0],
                            more={"command": item["command"], "altitude": item["params"][6]}))
    assert plan["mission"]["plannedHomePosition"][:2] == [points[0].latitude, points[0].longitude]
    return {robot: points}


def read_qgc_wpl(text, robot, path):
    loader = mavwp.MAVWPLoader()
    loader.load(str(path))
    points = []
    for index in range(loader.count()):
        item = loader.wp(index)
        assert item.seq == index and item.frame == 3 and item.current == (index == 0) and item.autocontinue == 1
        points.append(Point(latitude=item.x, longitude=item.y, hold=item.param1,
                            more={"command": item.command, "altitude": item.z}))
    return {robot: points}


def read_nav2(text, robot):
    points = []
    for pose in YAML(typ="safe", pure=True).load(text)["poses"]:
        assert pose["header"] == {"frame_id": "map"}
        turn, at = pose["pose"]["orientation"], pose["pose"]["position"]
        assert turn["x"] == turn["y"] == at["z"] == 0 and abs(turn["z"] ** 2 + turn["w"] ** 2 - 1) < 1e-8
        points.append(Point(x=at["x"], y=at["y"], heading=2 * math.atan2(turn["z"], turn["w"])))
    steps = [int(step) for step in re.findall(r"# step (\d+)", text)]
    for point, step in zip(points, steps, strict=True):
        point.step = step
    return {robot: points}


def read_moos(text, robot):
    """As a behaviour's parameters are read: comments away, name = value, x,y:x,y:..."""
    lines = [line for line in text.splitlines() if line and not line.startswith("//")]
    assert len(lines) == 1
    name, value = (part.strip() for part in lines[0].split("=", 1))
    assert name == "points"
    pairs = [[float(number) for number in pair.split(",")] for pair in value.split(":")]
    return {robot: [Point(east=east, north=north) for east, north in pairs]}
