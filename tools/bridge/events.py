"""What happens, from messages that say what is: changes from status messages, first words from repeated signals."""

from dataclasses import dataclass

ALIVE = 0
STATES = {ALIVE: "alive again", 1: "stopped", 2: "lost", 3: "stuck", 4: "without power", 5: "low on battery: it goes home"}
BAD = (2, 3, 4)
BEHIND = 1_000_000  # microseconds; an older message came late, one older than that is of a world started anew


@dataclass(frozen=True)
class Event:
    utime: int
    level: str
    robot: int  # whose colour it has; -1: nobody's
    text: str


class Changes:
    """From status messages to events; also the places scanned and with a mine by now."""

    def __init__(self):
        self.forget()

    def forget(self):
        self.utime = 0
        self.state, self.scanned, self.found = {}, {}, {}

    def hear(self, utime, status):
        if utime < self.utime:
            if self.utime - utime <= BEHIND:
                return []
            self.forget()
        self.utime = utime
        robots = max(0, min(status["robots"], len(status["state"])))
        places = max(0, min(status["places"], len(status["found"])))
        return [*self.places(utime, places, status), *self.robots(utime, robots, status)]

    def places(self, utime, places, status):
        for place in range(places):
            robot = status["scanned_by"][place]
            if robot >= 0 and place not in self.scanned:
                self.scanned[place] = robot
                yield Event(utime, "INFO", robot, f"place {place}: scanned, robot {robot} was there first")
            if status["found"][place] and place not in self.found:
                self.found[place] = True
                yield Event(utime, "INFO", robot, f"place {place}: mine found")

    def robots(self, utime, robots, status):
        for robot in range(robots):
            state = status["state"][robot]
            if state != self.state.get(robot, ALIVE):
                level = "WARN" if state in BAD else "INFO"
                yield Event(utime, level, robot, f"robot {robot}: {STATES.get(state, f'state {state}')}")
            self.state[robot] = state


class Signals:
    """From terminate messages to events, and whether each is a repetition."""

    def __init__(self):
        self.said = {}

    def hear(self, utime, terminate):
        """(event, repeated)"""
        sender, signal, territory = terminate["sender"], terminate["signal"], terminate["territory"]
        text = {1: "target found", 2: f"territory {territory} done"}.get(signal, f"signal {signal}")
        word = (sender, signal, territory if signal != 1 else None)
        last = self.said.get(word)
        self.said[word] = utime
        repeated = last is not None and utime >= last - BEHIND
        return Event(utime, "TRACE" if repeated else "INFO", sender, f"robot {sender} says: {text}"), repeated
