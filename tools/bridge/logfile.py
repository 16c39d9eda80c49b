"""Reads an LCM log. lcm.EventLog ends at the first damaged byte; this reader finds what is whole behind it too."""

import mmap
import struct

from faults import Fault

SYNC = b"\xed\xa1\xda\x01"
HEADER = struct.Struct(">4sqqii")  # sync word, event number, time of receipt, lengths of channel and data
LONGEST_CHANNEL = 63  # as liblcm has it


class Log:
    """Iterating gives (channel, data) of every whole event. `notes` says afterwards what was not whole."""

    def __init__(self, path):
        self.path = path
        self.notes = []
        self.at = 0
        try:
            with open(path, "rb") as file:
                self.size = file.seek(0, 2)
                self.bytes = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) if self.size > 0 else b""
        except FileNotFoundError:
            raise Fault(f"{path}: no such file; check its name") from None
        except (OSError, ValueError) as error:
            raise Fault(f"{path}: cannot be read ({getattr(error, 'strerror', None) or error}); "
                        "name a log that lcm-logger wrote") from None
        if self.bytes.find(SYNC) < 0:
            raise Fault(f"{path}: not an LCM log; name one that lcm-logger wrote")

    def __iter__(self):
        while self.at < self.size:
            event, after = self.event(self.at)
            if event is not None:
                yield event
            if event is None or (after < self.size and self.bytes[after : after + 4] != SYNC):
                after = self.skip(after)
            self.at = after

    def event(self, at):
        """The event at `at`, or None, and where to go on."""
        if at + HEADER.size > self.size:
            return None, at
        sync, _, _, name_length, length = HEADER.unpack_from(self.bytes, at)
        end = at + HEADER.size + name_length + length
        if sync != SYNC or not 0 < name_length <= LONGEST_CHANNEL or length < 0 or end > self.size:
            return None, at
        if end < self.size and self.bytes[end : end + 4] != SYNC and self.bytes.find(SYNC, at + 4, end) >= 0:
            return None, at  # its end is missing, another event begins in what is left
        name = self.bytes[at + HEADER.size : at + HEADER.size + name_length]
        return (name.decode("utf-8", "backslashreplace"), self.bytes[end - length : end]), end

    def skip(self, at):
        """From bytes that are no event to the next that may be one."""
        found = self.bytes.find(SYNC, at + 1)
        if found < 0:
            self.notes.append(f"{self.path}: ends in the middle of a message, at byte {at} of {self.size}; "
                              "what lies before it is converted")
            return self.size
        self.notes.append(f"{self.path}: damaged from byte {at} to {found}; what lies around it is converted")
        return found
