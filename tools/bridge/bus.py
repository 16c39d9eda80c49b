"""Listens to the live bus."""

import contextlib
import os
import select
import signal
import sys
import tempfile
import time

from faults import Fault, missing

DEFAULT_URL = "udpm://239.255.76.67:7667?ttl=0"
QUEUE = 10000  # messages that may wait while the outputs are written


@contextlib.contextmanager
def caught_stderr():
    """liblcm explains itself on the error output; gives a function that tells what it said."""
    sys.stderr.flush()
    saved = os.dup(2)
    with tempfile.TemporaryFile() as file:
        os.dup2(file.fileno(), 2)

        def said():
            file.seek(0)
            return [line.strip() for line in file.read().decode("utf-8", "replace").splitlines() if line.strip()]

        try:
            yield said
        finally:
            os.dup2(saved, 2)
            os.close(saved)


class Bus:
    """Iterating gives (channel, data) as they come, for `seconds` (None: until Ctrl-C or a termination signal)."""

    def __init__(self, url, seconds):
        try:
            import lcm
        except ImportError:
            raise missing("lcm") from None
        self.path = url or os.environ.get("LCM_DEFAULT_URL") or DEFAULT_URL
        self.seconds = seconds
        self.notes = []
        self.heard = []
        self.live = False  # something was heard
        self.stopped = False
        with caught_stderr() as said:
            try:
                self.lcm = lcm.LCM(self.path)
                self.lcm.subscribe("QUARTER_.*", lambda *event: self.heard.append(event)).set_queue_capacity(QUEUE)
            except Exception as error:
                raise self.refusal(said() or [str(error)]) from None

    def refusal(self, said):
        if any("oute" in line or "unreachable" in line for line in said):
            return Fault("no multicast route; as root, ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo "
                         "makes one on this machine")
        return Fault(f"{self.path}: LCM cannot open it ({said[-1]}); the default is {DEFAULT_URL}")

    def stop(self, *_):
        self.stopped = True

    def handle(self):
        try:
            self.lcm.handle()
        except OSError as error:
            raise Fault(f"{self.path}: the bus broke ({error}); start the bridge again") from None

    @contextlib.contextmanager
    def signals(self):
        """While this is open signals stop the listening; gives a handle that a signal makes readable."""
        awake, wake = os.pipe()
        os.set_blocking(wake, False)
        earlier = signal.set_wakeup_fd(wake)
        before = {number: signal.signal(number, self.stop) for number in (signal.SIGINT, signal.SIGTERM)}
        try:
            yield awake
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)
            signal.set_wakeup_fd(earlier)
            os.close(awake)
            os.close(wake)

    def wait(self, awake, end):
        """Until a message is there (True), a signal came or the time is over."""
        # Python's select outlives a signal, liblcm's own waiting does not.
        left = None if end is None else max(0, end - time.monotonic())
        return self.lcm.fileno() in select.select([self.lcm.fileno(), awake], [], [], left)[0]

    def take(self):
        self.handle()
        if self.heard and not self.live:
            self.live = True
            print(f"hearing {self.heard[0][0]}", flush=True)
        yield from self.heard
        self.heard.clear()

    def __iter__(self):
        with self.signals() as awake:
            end = None if self.seconds is None else time.monotonic() + self.seconds
            print(f"listening to {self.path} {'until Ctrl-C' if end is None else f'for {self.seconds:g} s'}", flush=True)
            while not self.stopped and (end is None or time.monotonic() < end):
                if self.wait(awake, end):
                    yield from self.take()
            # What came in time counts, though nobody got to it.
            for _ in range(QUEUE):
                if not select.select([self.lcm.fileno()], [], [], 0)[0]:
                    break
                yield from self.take()
