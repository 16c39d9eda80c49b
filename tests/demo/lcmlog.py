"""Messages of lcmtypes/ and LCM's log files, read and written by code that shares nothing with LCM's own."""

import contextlib
import re
import struct
from pathlib import Path

TYPES = Path(__file__).resolve().parent.parent.parent / "lcmtypes"
SYNC = 0xEDA1DA01
CODES = {"int8_t": "b", "int32_t": "i", "int64_t": "q", "float": "f", "double": "d"}
FOUND, DONE = 1, 2  # termination signals
ROBOT_CHANNEL = re.compile(r"QUARTER_R(\d+)_(POSE|SCAN|COMMAND)")


class Type:
    """One struct: its mark of 8 bytes, and its fields' layout."""

    def __init__(self, path):
        text = re.sub(r"//.*", "", path.read_text(encoding="utf-8"))
        constants = {name: int(value) for name, value in re.findall(r"const\s+int32_t\s+(\w+)\s*=\s*(\d+)\s*;", text)}
        body = re.sub(r"const[^;]*;", "", text[text.index("{") + 1:text.rindex("}")])
        mark = 0x12345678
        layout = ">Q"
        self.fields = []
        for kind, name, size in re.findall(r"(\w+)\s+(\w+)(?:\[(\w+)\])?\s*;", body):
            count = constants[size] if size in constants else int(size or 1)
            self.fields.append((name, count if size else None))
            layout += f"{count}{CODES[kind]}"
            mark = hash_text(hash_text(mark, name), kind)
            mark = hash_byte(mark, 1 if size else 0)
            if size:
                mark = hash_text(hash_byte(mark, 0), size if size not in constants else str(constants[size]))
        mark &= 2**64 - 1
        self.mark = (mark << 1 | mark >> 63) & (2**64 - 1)
        self.layout = struct.Struct(layout)

    def decode(self, data):
        """The fields as a dict. ValueError: these bytes are no such message."""
        if len(data) != self.layout.size:
            raise ValueError(f"{len(data)} bytes, not {self.layout.size}")
        mark, *values = self.layout.unpack(data)
        if mark != self.mark:
            raise ValueError(f"mark {mark:016x}, not {self.mark:016x}")
        message = {}
        for name, count in self.fields:
            message[name] = values.pop(0) if count is None else [values.pop(0) for _ in range(count)]
        return message

    def encode(self, **message):
        values = []
        for name, count in self.fields:
            values += [message[name]] if count is None else message[name]
        return self.layout.pack(self.mark, *values)


def hash_byte(value, byte):
    """LCM's: on signed 64-bit numbers, with an arithmetic shift to the right."""
    value = (value + 2**63) % 2**64 - 2**63
    return ((value << 8) ^ (value >> 55)) + byte


def hash_text(value, text):
    value = hash_byte(value, len(text))
    for letter in text.encode():
        value = hash_byte(value, letter)
    return value


POSE, SCAN, COMMAND, TERMINATE, STATUS = (Type(TYPES / f"{name}.lcm")
                                          for name in ("pose", "scan", "command", "terminate", "status"))
ON_ROBOT_CHANNEL = {"POSE": POSE, "SCAN": SCAN, "COMMAND": COMMAND}


def type_of(channel):
    """(type, robot's number or None). ValueError: the demo has no such channel."""
    if channel in ("QUARTER_TERMINATE", "QUARTER_STATUS"):
        return (TERMINATE if channel == "QUARTER_TERMINATE" else STATUS), None
    match = ROBOT_CHANNEL.fullmatch(channel)
    if match is None:
        raise ValueError(f"{channel}: no channel of the demo's")
    return ON_ROBOT_CHANNEL[match[2]], int(match[1])


def events_of(path):
    """Each (timestamp, channel, data). ValueError where the log is not whole."""
    data = Path(path).read_bytes()
    at = 0
    number = 0
    while at < len(data):
        if at + 28 > len(data):
            raise ValueError(f"{path}: ends within the head of event {number}")
        sync, said, timestamp, channel_size, data_size = struct.unpack_from(">IqqII", data, at)
        at += 28
        if sync != SYNC or said != number:
            raise ValueError(f"{path}: event {number} has sync word {sync:08x} and number {said}")
        if at + channel_size + data_size > len(data):
            raise ValueError(f"{path}: ends within event {number}")
        channel = data[at:at + channel_size].decode()
        at += channel_size
        yield timestamp, channel, data[at:at + data_size]
        at += data_size
        number += 1


def read(path):
    """[(timestamp, channel, data)]. ValueError: the log is not whole from its first byte to its last."""
    return list(events_of(path))


def read_so_far(path):
    """The same of a log that is being written: what is whole of it."""
    events = []
    with contextlib.suppress(ValueError, FileNotFoundError):
        for event in events_of(path):
            events.append(event)
    return events
