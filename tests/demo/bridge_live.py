"""The live bus."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import network
from bridging import STEP, Bridge, asked, make, pose_at, poses_in, read_mcap

LOOPBACK = "ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo && exec \"$@\""
URL = "udpm://239.255.76.67:7667?ttl=0"


class TestLive(Bridge):
    def in_namespace(self, script, *words, **how):
        network.need_network()
        return subprocess.run([*network.unshare("n"), "sh", "-c", script, "sh", *map(str, words)], capture_output=True,
                              encoding="utf-8", **how)

    def publish(self, ending, *words):
        """A bridge that listens, and a publisher beside it, both in a network of their own."""
        bridge = self.words("--live", *words, *self.outputs())
        program = Path(__file__).with_name("test_bridge.py")
        done = self.in_namespace(LOOPBACK, sys.executable, "-B", program, "--lcm-gen", asked.lcm_gen, "--publish",
                                 ending, *bridge, env={**os.environ, "LCM_DEFAULT_URL": URL})
        self.assertEqual(0, done.returncode, done.stderr)
        return done

    def check_heard(self, done):
        rows = poses_in(read_mcap(self.mcap)[0])
        self.assertGreater(len(rows), 0)
        self.assertEqual([(1000 * m["utime"], pose_at(m["utime"], 0)) for _, m in rows], rows)
        self.assertIn("\nhearing QUARTER_R0_POSE\n", done.stdout)
        self.assertRegex(done.stdout, rf"(?m)^QUARTER_R0_POSE +{len(rows)} .* 0$")
        if not asked.no_rerun:
            self.assertGreater(self.rrd.stat().st_size, 0)

    def test_time_or_an_interrupt_ends_the_listening_and_keeps_the_outputs(self):
        self.check_heard(self.publish("time", "--seconds", "1"))
        self.check_heard(self.publish("interrupt"))

    def test_silence_is_said(self):
        done = self.in_namespace(LOOPBACK, *self.words("--live", "--lcm-url", URL, "--seconds", "0.1", *self.outputs()))
        self.assertEqual(2, done.returncode)
        self.assertRegex(done.stderr, r"\Abridge: .*heard nothing of Quarter's; start the demo.*\n\Z")
        self.assertEqual([], list(self.folder.iterdir()))

    def test_no_multicast_route_is_said(self):
        for script in ('exec "$@"', 'ip link set lo up && exec "$@"'):
            done = self.in_namespace(script, *self.words("--live", "--lcm-url", URL, *self.outputs()))
            self.assertEqual(2, done.returncode)
            self.assertRegex(done.stderr, r"\Abridge: no multicast route; .* dev lo .*\n\Z")


def publish(ending, *bridge):
    """Inside the namespace: publish poses once the bridge listens; interrupt it once it has heard one, or let it end."""
    import lcm
    bus = lcm.LCM(URL)
    process = subprocess.Popen(bridge, stdout=subprocess.PIPE, encoding="utf-8")
    try:
        said = [process.stdout.readline()]  # from here on it listens
        for number in range(50):
            bus.publish("QUARTER_R0_POSE", make("pose", **pose_at(number * STEP, 0)))
        said.append(process.stdout.readline())  # from here on it has heard something
        if ending == "interrupt":
            process.send_signal(signal.SIGINT)
        print(*said, process.communicate()[0], sep="", end="")
        return process.returncode
    finally:
        process.kill()
