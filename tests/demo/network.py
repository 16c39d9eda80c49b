"""A network of its own for programs under test: loopback alone, multicast on it, some packets lost if asked for.

A holder process (this file, run inside) keeps the namespace and opens sockets in it, which it hands out; the test
itself stays outside. All processes that were started in it end with it.

Whoever waits here waits for what happens: a line, a message, a file that was written, a process that has ended.
"""

import ctypes
import functools
import os
import re
import select
import shutil
import signal
import socket
import struct
import subprocess
import sys
import threading
import unittest
from pathlib import Path

GROUP = "239.255.76.67"
PORT = 7667
URL = f"udpm://{GROUP}:{PORT}?ttl=0"
OTHER_ADDRESS = "10.7.7.7"
SHORT = 0x4C433032  # magic number of a message in one packet
SELF_TEST = "LCM_SELF_TEST"  # what LCM says to itself when it has joined
LOOPBACK = f"ip link set lo up && ip addr add {OTHER_ADDRESS}/32 dev lo"
MULTICAST = "ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo"
LOSS = ("nft add table ip t && nft add chain ip t in '{ type filter hook input priority 0; }' && "
        f"nft add rule ip t in udp dport %d numgen random mod 100 \\< %d drop")


HANG = 900  # seconds: no measure of anything, only what ends a test that hangs

os.environ["PATH"] += ":/usr/sbin:/sbin"  # where ip and nft are, though not on every user's path


@functools.cache
def unshare(kind):
    """The words before a program that give it a namespace of its own, n of networks or m of mounts; none if that is not
    allowed here."""
    for words in ("unshare", f"-r{kind}"), ("unshare", f"-{kind}"):  # the latter: as root, where user namespaces are forbidden
        if shutil.which(words[0]) and subprocess.run([*words, "true"], capture_output=True).returncode == 0:
            return words
    return ()


def need(kind, *tools):
    """Skip what cannot be tested here, and say why."""
    missing = [tool for tool in ("unshare", *tools) if shutil.which(tool) is None]
    if missing:
        raise unittest.SkipTest(f"{' and '.join(missing)} missing: install util-linux, iproute2 and nftables")
    if not unshare(kind):
        raise unittest.SkipTest("user namespaces are forbidden here, and this is not root")


def need_network(loss=False):
    need("n", "ip", *["nft"] * loss)


class Program:
    """A started program: what it says, and its end."""

    def __init__(self, words, **options):
        self.words = [str(word) for word in words]
        self.process = subprocess.Popen(self.words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, encoding="utf-8", errors="replace",
                                        start_new_session=True, **options)
        self.pid = self.process.pid
        self.output, self.lines = [], []  # so far
        self.news = threading.Condition()
        self.silent = False  # its standard error is closed
        self.readers = [threading.Thread(target=self.read, args=pair, daemon=True)
                        for pair in ((self.process.stdout, self.output), (self.process.stderr, self.lines))]
        for reader in self.readers:
            reader.start()

    def read(self, stream, lines):
        with stream:
            for line in stream:
                with self.news:
                    lines.append(line)
                    self.news.notify_all()
        with self.news:
            self.silent = self.silent or lines is self.lines
            self.news.notify_all()

    def await_line(self, pattern):
        """The match of the first line on its standard error that has one."""
        with self.news:
            while True:
                for line in self.lines:
                    if match := re.search(pattern, line):
                        return match
                if self.silent or not self.news.wait(HANG):
                    raise AssertionError(f"{' '.join(self.words)}: no {pattern} in {self.lines}")

    def await_that(self, holds):
        """Until holds(), looked at with every line that it says."""
        with self.news:
            if not self.news.wait_for(lambda: holds() or self.silent, HANG) or not holds():
                raise AssertionError(f"{' '.join(self.words)}: it said only {self.lines}")

    def runs(self):
        return self.process.poll() is None

    def send(self, number):
        self.process.send_signal(number)

    def children(self):
        """{process id: words}, of those that are there now."""
        found = {}
        try:
            pids = Path(f"/proc/{self.pid}/task/{self.pid}/children").read_text(encoding="ascii").split()
            for pid in pids:
                found[int(pid)] = os.fsdecode(Path(f"/proc/{pid}/cmdline").read_bytes()).split("\0")[:-1] or [""]
        except OSError:
            pass  # gone meanwhile
        return found

    def end(self):
        """(status, standard output, standard error) once it has ended by itself."""
        watchdog = threading.Timer(HANG, self.process.kill)
        watchdog.start()
        self.process.wait()
        watchdog.cancel()
        for reader in self.readers:  # which would not end if a child of it lived on
            reader.join(HANG)
        return self.process.returncode, "".join(self.output), "".join(self.lines)

    def kill(self):
        self.process.kill()  # nothing if it has ended
        self.process.wait()


def await_file(path, holds, nudge=None):
    """Until holds(), looked at whenever something is written in the folder of `path`. Where nothing is, nudge() is to make
    a program write what it keeps."""
    libc = ctypes.CDLL(None, use_errno=True)
    handle = libc.inotify_init1(os.O_CLOEXEC)
    try:
        libc.inotify_add_watch(handle, os.fsencode(path.parent), 0x102)  # IN_MODIFY, IN_CREATE
        while not holds():
            if select.select([handle], [], [], 0.1 if nudge else HANG)[0]:
                os.read(handle, 65536)
            elif nudge:
                nudge()
            else:
                raise AssertionError(f"{path}: nothing was written")
    finally:
        os.close(handle)


class Network:
    def __init__(self, loss=0, multicast=True):
        need_network(loss > 0)
        setup = [LOOPBACK] + [MULTICAST] * multicast + [LOSS % (PORT, loss)] * (loss > 0)
        self.ours, theirs = socket.socketpair()
        self.programs = []
        self.sockets = []
        self.listeners = []
        self.lock = threading.Lock()
        self.holder = subprocess.Popen(
            [*unshare("n"), "sh", "-c", " && ".join(setup) + ' && exec "$@"', "sh", sys.executable, "-B", __file__,
             str(theirs.fileno())], pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL, start_new_session=True)
        theirs.close()
        if self.ours.recv(1) != b"+":
            raise AssertionError(f"a network could not be set up: status {self.holder.wait()}")
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
        self.holder.wait()

    def start(self, *words, **options):
        user = ["--preserve-credentials", "-U"] if "-rn" in unshare("n") else []
        enter = "nsenter", *user, "-n", "-t", self.holder.pid, "--"  # becomes the program
        program = Program([*enter, *words], **options)
        self.programs.append(program)
        return program

    def run(self, *words, **options):
        return self.start(*words, **options).end()

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

    def publisher(self):
        return Publisher(self.socket("udp"))


def is_zombie(pid):
    return Path(f"/proc/{pid}/stat").read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[0] == "Z"


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


class Ear:
    """Takes all that comes to a socket, in a thread, until it is closed: what has come by then is taken."""

    def __init__(self, one):
        self.socket = one
        self.over, self.ender = socket.socketpair()
        self.thread = threading.Thread(target=self.listen, daemon=True)
        self.thread.start()

    def listen(self):
        while True:
            ready = select.select([self.socket, self.over], [], [])[0]
            if self.socket not in ready:
                break
            self.take(*self.socket.recvfrom(65536))

    def close(self):
        self.ender.close()
        self.thread.join()
        self.over.close()


class Listener(Ear):
    """Hears all of LCM's short messages: self.heard grows, of (source port, channel, data)."""

    def __init__(self, one):
        self.heard = []
        self.news = threading.Condition()
        super().__init__(one)

    def take(self, packet, source):
        if len(packet) < 9 or struct.unpack_from(">I", packet)[0] != SHORT or b"\0" not in packet[8:]:
            return
        channel, _, data = packet[8:].partition(b"\0")
        with self.news:
            self.heard.append((source[1], channel.decode("latin-1"), data))
            self.news.notify_all()

    def await_that(self, holds, what, seconds=HANG):
        """What holds() gives, as soon as that is true; None if it never is in these seconds."""
        with self.news:
            value = self.news.wait_for(holds, seconds)
        if not value and seconds == HANG:
            raise AssertionError(f"never came on the bus: {what}")
        return value or None

    def await_message(self, fits, what, begin=0, seconds=HANG):
        """The first message, from number `begin` on, that fits(source, channel, data), and its number."""
        at = begin

        def look():
            nonlocal at
            while at < len(self.heard):
                if fits(*self.heard[at]):
                    return self.heard[at], at
                at += 1
            return None
        return self.await_that(look, what, seconds)

    def await_members(self, members):
        """Until so many programs are on the bus: each says so when it has joined."""
        self.await_that(lambda: members <= len({source for source, channel, _ in self.heard if channel == SELF_TEST}),
                        f"{members} programs that join")


class Wire(Ear):
    """All packets that pass a network, whatever they are, but for the kernel's own IGMP: {(source port, kind)}."""

    def __init__(self, net):
        self.seen = set()
        super().__init__(net.socket("packets"))

    def take(self, packet, _):
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
