"""Messages from bytes, by decoders that lcm-gen makes from lcmtypes/ at every start."""

import importlib
import importlib.util
import re
import shutil
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


class Decoder:
    def __init__(self, lcm_gen=None):
        self.types = generate(lcm_gen or find_lcm_gen())

    def decode(self, channel, data):
        """A Message; Unfit if it is none."""
        kind, robot = kind_of(channel)
        if kind is None:
            raise Unfit("not a channel of Quarter's")
        try:
            decoded = self.types[kind].decode(data)
        except (ValueError, struct.error):
            raise Unfit(f"does not decode as {kind}") from None
        fields = {name: getattr(decoded, name) for name in decoded.__slots__}
        if not 0 <= decoded.utime <= LATEST:
            raise Unfit("its time cannot be")
        if robot is not None and decoded.robot != robot:
            raise Unfit("of another robot than its channel")
        unsound = unsound_field(kind, fields)
        if unsound is not None:
            raise Unfit(f"its {unsound} cannot be")
        return Message(channel, kind, decoded.utime, fields)
