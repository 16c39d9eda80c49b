"""Whether what a message says can be: the checks of demo/bus/bus.c."""

import math

MOST_ROBOTS, MOST_PLACES = 16, 128
FARTHEST = 1e9  # metres, and metres a second
TURN = 1e6  # radians


def within(number, most):
    return math.isfinite(number) and abs(number) <= most


def is_mark(value):
    return value in (0, 1)


def is_robot(number):
    return 0 <= number < MOST_ROBOTS


def pose(m):
    return {"robot": is_robot(m["robot"]), "x": within(m["x"], FARTHEST), "y": within(m["y"], FARTHEST),
            "heading": within(m["heading"], TURN)}


def scan(m):
    return {"robot": is_robot(m["robot"]), "read": is_mark(m["read"]), "mine": is_mark(m["mine"]),
            "range": all(within(r, FARTHEST) and r >= 0 for r in m["range"])}


def command(m):
    return {"robot": is_robot(m["robot"]), "left": within(m["left"], FARTHEST), "right": within(m["right"], FARTHEST),
            "read": is_mark(m["read"]), "intent": 0 <= m["intent"] <= 3}


def terminate(m):
    return {"sender": is_robot(m["sender"]), "signal": m["signal"] in (1, 2), "territory": is_robot(m["territory"])}


def status(m):
    """Of the robots and places that there are; what stands behind them says nothing."""
    robots, places = m["robots"], m["places"]
    if not (0 <= robots <= MOST_ROBOTS and 0 <= places <= MOST_PLACES):
        return {"robots": 0 <= robots <= MOST_ROBOTS, "places": 0 <= places <= MOST_PLACES}
    return {"mines_found": 0 <= m["mines_found"] <= places, "state": all(0 <= s <= 5 for s in m["state"][:robots]),
            "scanned_by": all(-1 <= robot < robots for robot in m["scanned_by"][:places]),
            "found": all(map(is_mark, m["found"][:places]))}


CHECKS = {"pose": pose, "scan": scan, "command": command, "terminate": terminate, "status": status}


def unsound_field(kind, fields):
    """The first field that cannot be; None: all can."""
    return next((name for name, holds in CHECKS[kind](fields).items() if not holds), None)
