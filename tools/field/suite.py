"""What is compared: families of problems by size, and the series that tell what Quarter's certificate costs."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Cell:
    """Problems of one family and size, by their seeds; `more` are further options of ./run bench --family."""
    family: str
    places: int
    robots: int
    side: int = 30
    more: tuple = field(default=())

    def name(self):
        told = {"--looks": "{} looks", "--classes": "{} classes", "--stretch": "ways x {}"}
        more = "".join(", " + told[word].format(value) for word, value in zip(self.more[::2], self.more[1::2]))
        return f"{self.family} {self.places}/{self.robots}{more}"

    def options(self, objective, seed):
        return ["--family", self.family, "--places", self.places, "--robots", self.robots, "--side", self.side, "--seed", seed,
                "--objective", objective, "--gamma", "0.99" if self.places <= 60 else "0.998", *self.more]


OBJECTIVES = ("time", "discounted")
SMALL = [Cell("scatter", 8, 1), Cell("rooms", 12, 2), Cell("corridors", 16, 3), Cell("scatter", 20, 2), Cell("floor", 20, 4),
         Cell("rooms", 10, 2, more=("--looks", 2)), Cell("scatter", 16, 3, more=("--classes", 2))]
MIDDLE = [Cell("scatter", 26, 2), Cell("rooms", 26, 3), Cell("corridors", 40, 4, 40), Cell("scatter", 60, 8, 40),
          Cell("floor", 60, 5)]
LARGE = [Cell("scatter", 128, 8, 60), Cell("rooms", 200, 8, 80), Cell("scatter", 1000, 16, 160), Cell("rooms", 1000, 32, 160)]
GROUPS = {"small": SMALL, "middle": MIDDLE, "large": LARGE}

# What the certificate costs, along one measure at a time.
SERIES = {
    "places": [Cell("scatter", places, 2) for places in (8, 12, 16, 20, 24, 28, 32)],
    "robots": [Cell("scatter", 24, robots) for robots in (1, 2, 3, 4, 6, 8)],
    "cells": [Cell("scatter", 16, 2, side) for side in (15, 30, 60, 120, 240)],
    "steps a cell": [Cell("scatter", 16, 2, more=("--stretch", stretch)) for stretch in (1, 3, 10, 30)],
}
