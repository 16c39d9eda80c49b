"""A world for one robot's process, that moves it about and looks at what it says."""

import math

from lcmlog import COMMAND, FOUND, POSE, SCAN, STATUS, TERMINATE
from programs import terminate

TICK = 0.05  # seconds between poses
MINE_RANGE = 0.36  # cells


class ScriptedWorld:
    """A world for one robot, in lockstep with it: open ground, no walls, wheels that do what they are told."""

    AXLE = 0.2

    def __init__(self, plan, number, net):
        rows = plan["map"]["rows"]
        x, y = plan["starts"][number]
        self.number, self.net, self.robots = number, net, plan["robots"]
        self.x, self.y, self.heading = x, rows - y, 0.0
        self.places = [(place["x"], rows - place["y"]) for place in plan["places"]]
        self.utime = 0
        self.read = 0
        self.scanned = []
        self.reads = []  # places over which the sensor was read, again and again
        self.said = set()
        self.publisher = net.publisher()
        self.listener = net.listen()
        self.at = 0
        self.program = None

    def channel(self, kind):
        return f"QUARTER_R{self.number}_{kind}"

    def start(self, *words):
        """Start the robot; it hears and answers when this returns. As every world it says the robot's pose until it does."""
        self.program = self.net.start(*words)
        self.at, self.read = len(self.listener.heard), 0
        answered = None
        while answered is None:
            self.publish(False)
            answered = self.listener.await_message(lambda _, channel, __: channel == self.channel("COMMAND"),
                                                   "an answer of the robot's", begin=self.at, seconds=TICK)

    def publish(self, mine):
        number = self.number
        pose = POSE.encode(utime=self.utime, robot=number, x=self.x, y=self.y, heading=self.heading)
        self.publisher.send(self.channel("POSE"), pose)
        seen = {"read": self.read, "mine": int(mine and self.read), "range": [1.5] * 24}
        scan = SCAN.encode(utime=self.utime, robot=number, **seen)
        self.publisher.send(self.channel("SCAN"), scan)

    def tick(self, mine=False):
        """Say where it is, take its command for that, and move. The command."""
        self.utime += 50_000
        if self.read:
            under = [place for place, (x, y) in enumerate(self.places) if math.hypot(x - self.x, y - self.y) < MINE_RANGE]
            self.scanned += [place for place in under if place not in self.scanned]
            self.reads += under
        self.publish(mine)

        def answers(source, channel, data):
            return channel == self.channel("COMMAND") and COMMAND.decode(data)["utime"] == self.utime

        (_, _, data), number = self.listener.await_message(answers, "the robot's command", begin=self.at)
        for source, channel, said in self.listener.heard[self.at:number]:
            if channel == "QUARTER_TERMINATE" and source != self.publisher.port:
                message = TERMINATE.decode(said)
                self.said.add((message["sender"], message["signal"], message["territory"]))
        self.at = number + 1
        command = COMMAND.decode(data)
        self.read = command["read"]
        self.heading += (command["right"] - command["left"]) / self.AXLE * TICK
        forwards = (command["left"] + command["right"]) / 2 * TICK
        self.x += forwards * math.cos(self.heading)
        self.y += forwards * math.sin(self.heading)
        return command

    def stands(self, command):
        return command["left"] == 0.0 and command["right"] == 0.0

    def tell(self, signal, territory=0, sender=None):
        sender = (self.number + 1) % self.robots if sender is None else sender
        word = terminate(utime=self.utime, sender=sender, signal=signal, territory=territory)
        self.publisher.send("QUARTER_TERMINATE", word)

    def distract(self):
        """What this robot has no business to hear: other robots' senses and commands, the world's knowledge."""
        other = (self.number + 1) % self.robots
        seen = {"utime": self.utime + 1, "read": 1, "mine": 1, "range": [0.01] * 24}
        away = {"utime": self.utime + 1, "x": 1.0, "y": 1.0, "heading": 1.0}
        for channel in (other, self.number):  # the latter: a wrong robot's on the right channel
            self.publisher.send(f"QUARTER_R{channel}_SCAN", SCAN.encode(robot=other, **seen))
            self.publisher.send(f"QUARTER_R{channel}_POSE", POSE.encode(robot=other, **away))
        stand = COMMAND.encode(utime=self.utime, robot=other, left=0.0, right=0.0, read=0, intent=0)
        self.publisher.send(f"QUARTER_R{other}_COMMAND", stand)
        self.publisher.send("QUARTER_STATUS", STATUS.encode(
            utime=self.utime, robots=self.robots, places=len(self.places), mines_found=1, state=[1] * 16,
            scanned_by=[other] * 128, found=[1] * 128))
        self.tell(FOUND, sender=self.number)  # its own voice, back from the bus
