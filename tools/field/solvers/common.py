"""What every solver of the comparison shares: the problem read, the processor's time, and how it says what it has found.

A solver prints JSON, a line each time that it knows more: {"seconds": s, "routes": [[look, ...] of each robot]}, {"seconds": s,
"bound": b} in the objective's own unit, {"seconds": s, "proved": true}, {"note": "why there is nothing"}. When its time of the
processor is over it is ended, by a timer that no solver can hold up; what it has printed counts.
"""

import json
import os
import resource
import signal
import sys
import time

MEMORY = 6 << 30  # bytes that a solver may take


class Problem:
    """A problem's plain numbers, as ./run bench --task write prints them."""

    def __init__(self, data):
        self.looks, self.robots, self.starts = data["looks"], data["robots"], data["starts"]
        self.place_of, self.class_of, self.start_of = data["place_of"], data["class_of"], data["start_of"]
        self.steps = data["steps"]  # [class][node][look]; None: no way
        self.by_time, self.gamma = data["objective"] == "time", data["gamma"]
        self.classes = len(self.steps)
        self.share = self.shares(data["weight"], data["detection"])
        self.findable = sum(self.share)

    def shares(self, weight, detection):
        """What each look finds, if a place's are made in their order: of all the likelihood that there is."""
        left, shares = [w / sum(weight) for w in weight], []
        for place in self.place_of:
            shares.append(left[place] * detection[place])
            left[place] *= 1 - detection[place]
        return shares

    def units(self):
        """Whole numbers that are to one another as the shares are, and the share that 1 stands for."""
        least = min(self.share)
        fine = 1 if all(abs(share / least - round(share / least)) < 1e-9 for share in self.share) else 1000
        return [round(fine * share / least) for share in self.share], least / fine

    def start_node(self, robot):
        return self.looks + self.start_of[robot]

    def way(self, robot, node, look):
        return self.steps[self.class_of[robot]][node][look]

    def value_of(self, look, when):
        return 10 * self.share[look] * self.gamma ** max(when - 1, 0)

    def horizon(self):
        """Steps within which somebody visits all that there is, going to what is nearest."""
        routes = nearest_first(self)
        return max(self.arrivals(robot, route)[-1] for robot, route in enumerate(routes) if route)

    def arrivals(self, robot, route):
        node, now, all_of_them = self.start_node(robot), 0, []
        for look in route:
            now += self.way(robot, node, look)
            all_of_them.append(now)
            node = look
        return all_of_them


def nearest_first(problem):
    """Each look in turn by whoever can make it soonest: a plan to begin with."""
    routes, now = [[] for _ in range(problem.robots)], [0] * problem.robots
    node = [problem.start_node(robot) for robot in range(problem.robots)]
    left = set(range(problem.looks))
    while left:
        when, robot, look = min((now[r] + problem.way(r, node[r], look), r, look)
                                for r in range(problem.robots) for look in left
                                if problem.way(r, node[r], look) is not None)
        routes[robot].append(look)
        node[robot], now[robot] = look, when
        left.remove(look)
    return routes


class Clock:
    """The processor's time from now on; the process ends when it is over."""

    def __init__(self, limit):
        self.begin, self.limit = time.process_time(), limit
        signal.signal(signal.SIGPROF, signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_PROF, limit)

    def seconds(self):
        return time.process_time() - self.begin

    def left(self):
        return self.limit - self.seconds()


class Teller:
    """Says what is known, when it is."""

    def __init__(self, clock):
        self.clock = clock

    def tell(self, **what):
        # Whole lines in one call: the process may be ended at any moment.
        os.write(sys.stdout.fileno(), (json.dumps({"seconds": self.clock.seconds(), **what}) + "\n").encode())

    def routes(self, routes):
        self.tell(routes=routes)

    def bound(self, bound):
        self.tell(bound=bound)

    def proved(self):
        self.tell(proved=True)

    def note(self, text):
        self.tell(note=text)


def solve(solver):
    """Run `solver(problem, clock, teller)` on the problem in the file argv[1], for argv[2] seconds."""
    with open(sys.argv[1], encoding="utf-8") as file:
        problem = Problem(json.load(file))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    clock = Clock(float(sys.argv[2]))
    teller = Teller(clock)
    try:
        solver(problem, clock, teller)
    except MemoryError:
        teller.note("out of memory")
