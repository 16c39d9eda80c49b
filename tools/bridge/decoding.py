"""Messages from bytes, by decoders that lcm-gen makes from lcmtypes/ at every start."""

import hashlib
import hmac
import importlib
import importlib.util
import os
import re
import shutil
import stat
import struct
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from faults import Fault, missing
from soundness import unsound_field

LCMTYPES = Path(__file__).resolve().parent.parent.parent / "lcmtypes"
CHANNEL = re.compile(r"QUARTER_(?:R(\d{1,4})_(POSE|SCAN|COMMAND)|(TERMINATE|STATUS))")  # as demo/bus/channels.h
KINDS = ("pose", "scan", "command", "terminate", "status")
KEY, KEY_FILE_MOST = 32, 4096  # bytes: as demo/bus/seal.h
TAG_AT, TAG = 36, 16  # in a terminate message, of which it is the end
LATEST = (2**63 - 1) // 1000  # microseconds, of which the nanoseconds still fit


class Unfit(Exception):
    """A message that cannot be converted."""


@dataclass(frozen=True)
class Message:
    channel: str
    kind: str
    utime: int
    fields: dict


def kind_of(channel):
    """(kind, robot) of a channel; no kind if it is none of Quarter's, no robot if it is no robot's own."""
    match = CHANNEL.fullmatch(channel)
    if match is None:
        return None, None
    return (match[2] or match[3]).lower(), int(match[1]) if match[1] else None


def find_lcm_gen():
    """The one in the wheel, else one on PATH."""
    found = importlib.util.find_spec("lcm")
    for folder in found.submodule_search_locations or [] if found else []:
        program = Path(folder).parent / "bin" / "lcm-gen"
        if program.is_file():
            return str(program)
    program = shutil.which("lcm-gen")
    if program is None:
        raise missing("lcm")
    return program


def generate(lcm_gen):
    """The types, by name."""
    sources = sorted(str(path) for path in LCMTYPES.glob("*.lcm"))
    if not sources:
        raise Fault(f"{LCMTYPES}: no message types; run the bridge from a whole checkout")
    with tempfile.TemporaryDirectory(prefix="quarter-bridge-") as folder:
        command = [lcm_gen, "--python", "--ppath", folder, *sources]
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace")
        except OSError as error:
            raise Fault(f"{lcm_gen}: does not start ({error.strerror}); name one that does: --lcm-gen PATH") from None
        if done.returncode != 0:
            said = (done.stderr.strip() or done.stdout.strip() or f"status {done.returncode}").splitlines()[-1]
            raise Fault(f"{lcm_gen}: failed ({said}); try it by hand, it needs the system's package "
                        "libglib2.0-0")
        sys.path.insert(0, folder)
        importlib.invalidate_caches()
        try:
            return {kind: getattr(importlib.import_module(f"quarter.{kind}"), kind) for kind in KINDS}
        except (ImportError, AttributeError) as error:
            raise Fault(f"{LCMTYPES}: {error}; run the bridge from a whole checkout") from None
        finally:
            sys.path.remove(folder)


def open_at_once(path, flags):
    """A pipe that nobody writes to would keep it waiting."""
    return os.open(path, flags | os.O_NONBLOCK)


def read_key(path):
    """The key of a team's seal, as demo/bus/seal.c reads it."""
    try:
        with open(path, "rb", opener=open_at_once) as file:
            mode = os.fstat(file.fileno()).st_mode
            text = file.read(KEY_FILE_MOST + 1) if stat.S_ISREG(mode) else b""
    except OSError as error:
        raise Fault(f"{path}: cannot be read ({error.strerror}); name the key that the robots have") from None
    if not stat.S_ISREG(mode):
        raise Fault(f"{path}: is a device or pipe; save the key in a file and name that")
    if mode & 0o077:
        raise Fault(f"{path}: others than its owner can get at this key; make a new one that they cannot: chmod 600 {path}")
    if not KEY <= len(text) <= KEY_FILE_MOST:
        raise Fault(f"{path}: a key has {KEY} to {KEY_FILE_MOST} bytes; make one: head -c {KEY} /dev/urandom >{path}")
    return hashlib.blake2b(text, digest_size=KEY).digest()


def is_sealed(data, key):
    own = hashlib.blake2b(data[:TAG_AT], key=key, digest_size=TAG).digest()
    return hmac.compare_digest(own, data[TAG_AT : TAG_AT + TAG])


class Decoder:
    def __init__(self, lcm_gen=None, key=None):
        self.types = generate(lcm_gen or find_lcm_gen())
        self.key = key

    def check_seal(self, kind, data):
        if kind == "terminate" and self.key is not None and not is_sealed(data, self.key):
            raise Unfit("without the key's seal")

    def decode(self, channel, data):
        """A Message; Unfit if it is none."""
        kind, robot = kind_of(channel)
        if kind is None:
            raise Unfit("not a channel of Quarter's")
        try:
            decoded = self.types[kind].decode(data)
        except (ValueError, struct.error):
            raise Unfit(f"does not decode as {kind}") from None
        self.check_seal(kind, data)
        fields = {name: getattr(decoded, name) for name in decoded.__slots__}
        if not 0 <= decoded.utime <= LATEST:
            raise Unfit("its time cannot be")
        if robot is not None and decoded.robot != robot:
            raise Unfit("of another robot than its channel")
        unsound = unsound_field(kind, fields)
        if unsound is not None:
            raise Unfit(f"its {unsound} cannot be")
        return Message(channel, kind, decoded.utime, fields)
