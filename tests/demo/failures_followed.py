"""What a viewer that follows the bus makes of it."""

from failures_served import Served
from lcmlog import POSE, STATUS
from programs import asked, terminate

EVENTS = 2048  # that are kept of a game


class Followed(Served):
    """A game on the bus that is anything but sound."""

    def begin(self):
        net, served, port = self.serve("--follow", "--robots", asked.robots)
        served.await_line("^Following")
        self.publisher = net.publisher()
        return net, served, port

    def status(self, utime, scanned=-1, state=0, robots=None, found=0):
        robots = asked.robots if robots is None else robots
        self.publisher.send("QUARTER_STATUS", STATUS.encode(
            utime=utime, robots=robots, places=asked.places, mines_found=0, state=[state] * 16,
            scanned_by=[scanned] * 128, found=[found] * 128))

    def pose(self, utime, number=0):
        self.publisher.send(f"QUARTER_R{number}_POSE", POSE.encode(utime=utime, robot=number, x=1.0, y=1.0, heading=0.0))

    def events_at(self, stream, begin):
        """All events that are told until a frame of `begin` seconds or later came. Poses are sent until then."""
        events = []

        def collect(name, data):
            if name != "frame":
                return False
            events.extend(data["events"])
            return data["t"] >= begin
        self.until_event(stream, collect)
        return events

    def catch_up(self, stream, second):
        """Until a frame of that second is shown: no more may be on the way at a time than a socket holds."""
        self.pose(round(1e6 * second))
        self.pose(round(1e6 * second) + 500_000)
        self.until_event(stream, lambda name, data: name == "frame" and abs(data["t"] - second) < 0.01)

    def test_robots_that_cannot_be_are_not_told_of(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        utime = 0
        for scanned in (asked.robots, 15, 16, 127, -2, -128):
            for found in (0, 1, 2, -1):
                utime += 10_000
                self.status(utime, scanned=scanned, found=found, robots=16)
        for state in (-1, 6, 99):
            self.status(utime, state=state)
        for number in range(asked.robots, 16):
            for territory in (0, number, -1, 99):
                self.publisher.send("QUARTER_TERMINATE", terminate(utime=utime, sender=number, signal=2,
                                                                  territory=territory))
        self.status(1_000_000, scanned=1)
        for utime in (2_000_000, 3_000_000):
            self.pose(utime)
        events = self.events_at(stream, 2.0)
        self.assertEqual([(event["kind"], event["robot"]) for event in events], [("scanned", 1)] * asked.places)

    def test_the_events_of_a_game_are_bounded_and_the_last_one_says_so(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for utime in range(1_000_000, 1_000_000 + 4 * EVENTS // asked.places + 40):
            self.status(utime, scanned=-1 if utime % 2 else 0)
            if utime % 30 == 0:
                self.catch_up(stream, utime % 1_000_000 / 30 + 3)
        for utime in (60_000_000, 61_000_000):
            self.pose(utime)
        _, late = self.watch(net, port)
        events = self.events_at(late, 60.0)
        self.assertEqual(len(events), EVENTS)
        self.assertEqual(events[-1]["kind"], "more")
        self.assertEqual({event["kind"] for event in events[:-1]}, {"scanned"})

    def test_a_clock_that_goes_back_begins_another_game_without_the_events_of_the_one_before(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for game in range(200):
            for second in (0, 1, 100):
                self.status(1_000_000 * second, scanned=0 if second else -1)
            if game % 10 == 9:
                self.catch_up(stream, 100 + game)
        self.catch_up(stream, 400)
        _, late = self.watch(net, port)
        self.assertEqual(len(self.events_at(late, 400)), asked.places)
        self.assertEqual(served.runs(), True)

    def test_a_message_that_comes_late_begins_no_other_game(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for utime in (5_000_000, 4_500_000, 5_200_000, 4_300_000, 5_400_000):
            self.status(utime, scanned=2)
        for utime in (6_000_000, 7_000_000):
            self.pose(utime)
        self.assertEqual(len(self.events_at(stream, 6.0)), asked.places)

    def test_frames_go_on_when_the_last_robot_is_lost(self):
        net, served, port = self.begin()
        _, stream = self.watch(net, port)
        for utime in range(0, 5_000_000, 50_000):
            self.pose(utime, number=0)
        self.until_event(stream, lambda name, data: name == "frame" and data["t"] >= 4.5)
