"""A network of its own for programs under test: loopback alone, multicast on it, some packets lost if asked for.

A holder process (this file, run inside) keeps the namespace and opens sockets in it, which it hands out; the test
itself stays outside. All processes that were started in it end with it.
"""

import contextlib
import functools
import os
import shutil
import signal
import socket
import struct
import subprocess
import sys
import threading
import time
import unittest
from pathlib import Path

os.environ["PATH"] += ":/usr/sbin:/sbin"  # of ip and nft; not every user looks there

GROUP = "239.255.76.67"
PORT = 7667
URL = f"udpm://{GROUP}:{PORT}?ttl=0"
OTHER_ADDRESS = "10.7.7.7"
SHORT = 0x4C433032  # magic number of a message in one packet
LOOPBACK = f"ip link set lo up && ip addr add {OTHER_ADDRESS}/32 dev lo"
MULTICAST = "ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo"
LOSS = ("nft add table ip t && nft add chain ip t in '{ type filter hook input priority 0; }' && "
        f"nft add rule ip t in udp dport %d numgen random mod 100 \\< %d drop")


def until(holds, seconds, what):
    """Poll until it holds; what it gave then. AssertionError after some seconds without."""
    end = time.monotonic() + seconds
    while True:
        value = holds()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError(f"after {seconds} s: {what() if callable(what) else what}")
        time.sleep(0.01)


@functools.lru_cache
def refusal(namespaces="-rn", tools=("ip",)):
    """Why these namespaces (unshare's words) or tools are not to be had here; "" where they are."""
    missing = [tool for tool in ("unshare", *tools) if shutil.which(tool) is None]
    if missing:
        return f"{' and '.join(missing)} missing: install util-linux, iproute2 and nftables"
    tried = subprocess.run(["unshare", namespaces, "true"], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    return f"user namespaces are forbidden here ({tried.stderr.strip()})" if tried.returncode else ""


class Program:
    """A started program: its process id, and its end within bounded time."""

    def __init__(self, words, **options):
        self.words = [str(word) for word in words]
        self.process = subprocess.Popen(self.words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True, start_new_session=True, **options)
        self.pid = self.process.pid
        self.output, self.lines = [], []  # so far
        self.readers = [threading.Thread(target=self.read, args=pair, daemon=True)
                        for pair in ((self.process.stdout, self.output), (self.process.stderr, self.lines))]
        for reader in self.readers:
            reader.start()

    def read(self, stream, lines):
        with stream:
            for line in stream:
                lines.append(line)

    def runs(self):
        return self.process.poll() is None

    def send(self, number):
        self.process.send_signal(number)

    def children(self):
        """{process id: words}, of those that are there now."""
        found = {}
        try:
            pids = Path(f"/proc/{self.pid}/task/{self.pid}/children").read_text().split()
            for pid in pids:
                found[int(pid)] = Path(f"/proc/{pid}/cmdline").read_text().split("\0")[:-1] or [""]
        except OSError:
            pass  # gone meanwhile
        return found

    def end(self, seconds):
        """(status, standard output, standard error) once it has ended by itself."""
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            self.kill()
            raise AssertionError(f"{' '.join(self.words)}: still runs after {seconds} s; it said: "
                                 + "".join(self.lines)) from None
        for reader in self.readers:  # which would not end if a child of it lived on
            reader.join(5)
        return self.process.returncode, "".join(self.output), "".join(self.lines)

    def kill(self):
        if self.runs():
            self.process.kill()
        self.process.wait(10)


class Network:
    def __init__(self, loss=0, multicast=True):
        if reason := refusal(tools=("ip", "nft") if loss > 0 else ("ip",)):
            raise unittest.SkipTest(reason)
        setup = [LOOPBACK] + [MULTICAST] * multicast + [LOSS % (PORT, loss)] * (loss > 0)
        self.ours, theirs = socket.socketpair()
        self.ours.settimeout(20)
        self.programs = []
        self.sockets = []
        self.listeners = []
        self.lock = threading.Lock()
        self.holder = subprocess.Popen(
            ["unshare", "-rn", "sh", "-c", " && ".join(setup) + ' && exec "$@"', "sh", sys.executable, "-B", __file__,
             str(theirs.fileno())], pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL, start_new_session=True)
        theirs.close()
        if self.ours.recv(1) != b"+":
            raise AssertionError("no network namespace, although they are allowed")
        self.name = os.readlink(f"/proc/{self.holder.pid}/ns/net")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for program in self.programs:
            program.kill()
        left = self.inhabitants()
        for pid in left:
            os.kill(pid, signal.SIGKILL)
        for listener in self.listeners:
            listener.close()
        for one in self.sockets:
            one.close()
        self.ours.close()
        try:
            self.holder.wait(10)
        except subprocess.TimeoutExpired:
            self.holder.kill()
            self.holder.wait(10)

    def start(self, *words, **options):
        enter = "nsenter", "--preserve-credentials", "-U", "-n", "-t", self.holder.pid, "--"  # becomes the program
        program = Program([*enter, *words], **options)
        self.programs.append(program)
        return program

    def run(self, *words, seconds=60, **options):
        return self.start(*words, **options).end(seconds)

    def inhabitants(self):
        """The processes in this network, but for the holder."""
        found = []
        for entry in os.listdir("/proc"):
            if not entry.isdigit() or int(entry) == self.holder.pid:
                continue
            try:
                if os.readlink(f"/proc/{entry}/ns/net") == self.name and not is_zombie(entry):
                    found.append(int(entry))
            except OSError:
                continue
        return found

    def socket(self, kind):
        """udp, tcp, group (joined, bound to LCM's port) or packets (all that passes)."""
        with self.lock:
            self.ours.sendall(kind[0].encode())
            _, handles, _, _ = socket.recv_fds(self.ours, 1, 1)
        one = socket.socket(fileno=handles[0])
        self.sockets.append(one)
        return one

    def listen(self):
        listener = Listener(self.socket("group"))
        self.listeners.append(listener)
        return listener

    def joined(self):
        """How many sockets hear LCM's group."""
        group = struct.unpack("=I", socket.inet_aton(GROUP))[0]
        for line in Path(f"/proc/{self.holder.pid}/net/igmp").read_text().splitlines():
            words = line.split()
            if words[0] == f"{group:08X}":
                return int(words[1])
        return 0

    def publisher(self):
        return Publisher(self.socket("udp"))


def is_zombie(pid):
    return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"


class Publisher:
    """Sends LCM's short messages."""

    def __init__(self, one):
        self.socket = one
        self.number = 0
        self.socket.bind(("0.0.0.0", 0))
        self.port = self.socket.getsockname()[1]

    def send(self, channel, data):
        self.send_raw(struct.pack(">II", SHORT, self.number) + channel.encode() + b"\0" + data)
        self.number += 1

    def send_raw(self, packet):
        self.socket.sendto(packet, (GROUP, PORT))


class Listener:
    """Hears all of LCM's short messages, in a thread: self.heard grows, of (source port, channel, data)."""

    def __init__(self, one):
        self.socket = one
        self.socket.settimeout(0.1)
        self.heard = []
        self.over = False
        self.news = threading.Condition()
        self.thread = threading.Thread(target=self.listen, daemon=True)
        self.thread.start()

    def listen(self):
        while not self.over:
            try:
                packet, source = self.socket.recvfrom(65536)
            except TimeoutError:
                continue
            if len(packet) < 9 or struct.unpack_from(">I", packet)[0] != SHORT or b"\0" not in packet[8:]:
                continue
            channel, _, data = packet[8:].partition(b"\0")
            with self.news:
                self.heard.append((source[1], channel.decode("latin-1"), data))
                self.news.notify_all()

    def await_message(self, fits, seconds, what, begin=0):
        """The first message, from number `begin` on, that fits(source, channel, data), and its number."""
        end = time.monotonic() + seconds
        with self.news:
            while True:
                for number in range(begin, len(self.heard)):
                    if fits(*self.heard[number]):
                        return self.heard[number], number
                begin = len(self.heard)
                left = end - time.monotonic()
                if left <= 0:
                    raise AssertionError(f"after {seconds} s on the bus: {what}")
                self.news.wait(left)

    def close(self):
        self.over = True
        self.thread.join(5)


class Wire:
    """All packets that pass a network, whatever they are, but for the kernel's own IGMP: {(source port, kind)}."""

    def __init__(self, net):
        self.socket = net.socket("packets")
        self.socket.settimeout(0.1)
        self.seen = set()
        self.over = threading.Event()
        self.thread = threading.Thread(target=self.watch, daemon=True)
        self.thread.start()

    def watch(self):
        while not self.over.is_set():
            with contextlib.suppress(TimeoutError):
                self.note(self.socket.recv(65536))

    def note(self, packet):
        if packet[0] >> 4 != 4:
            return self.seen.add((None, f"not IPv4: {packet[:8].hex()}"))
        head = 4 * (packet[0] & 15)
        if packet[9] == 2:
            return None
        if packet[9] != 17:
            return self.seen.add((None, f"IP protocol {packet[9]}"))
        source, port = struct.unpack_from(">HH", packet, head)
        if (packet[16:20], port) != (socket.inet_aton(GROUP), PORT):
            return self.seen.add((source, f"UDP to {packet[16:20].hex()}:{port}"))
        return self.seen.add((source, packet[head + 16:].partition(b"\0")[0].decode("latin-1")))

    def close(self):
        self.over.set()
        self.thread.join(5)


# ---- inside ----

def open_socket(kind):
    if kind == b"t":
        return socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    if kind == b"p":
        return socket.socket(socket.AF_PACKET, socket.SOCK_DGRAM, socket.htons(0x0003))
    one = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    one.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
    if kind == b"g":
        one.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        one.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        one.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
        one.bind((GROUP, PORT))
        membership = socket.inet_aton(GROUP) + socket.inet_aton("0.0.0.0")
        one.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    return one


def hold(handle):
    """Hand out sockets until the other end closes."""
    with socket.socket(fileno=handle) as theirs:
        theirs.sendall(b"+")
        while kind := theirs.recv(1):
            with open_socket(kind) as one:
                socket.send_fds(theirs, [b"."], [one.fileno()])


if __name__ == "__main__":
    hold(int(sys.argv[1]))
