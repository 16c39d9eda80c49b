"""Turns a log of Quarter's demo, or what its bus carries now, into a Rerun recording and an MCAP file."""

import argparse
import os
import signal
import sys
import time
from pathlib import Path

from bus import DEFAULT_URL, Bus
from decoding import Decoder, Unfit, read_key
from events import BEHIND
from faults import Fault
from logfile import Log
from mission import inspect
from outfile import Outfile
from to_mcap import McapSink
from to_rerun import RerunSink

PROGRAM = "python3 tools/bridge"
EXAMPLES = f"""\
{PROGRAM} run.lcm --table mission.qtr --rerun run.rrd --mcap run.mcap
{PROGRAM} run.lcm --mcap run.mcap                      # no map, no places
{PROGRAM} --live --seconds 30 --table mission.qtr --rerun run.rrd
{PROGRAM} --live --lcm-url '{DEFAULT_URL}' --mcap run.mcap    # until Ctrl-C
rerun run.rrd                                                        # see it

{__doc__}
What it needs: python3 -m pip install --require-hashes -r tools/bridge/requirements.txt
(requirements-mcap.txt suffices for --mcap alone).
"""
EXIT = "exit status: 0 all is written; 2 nothing is, and why stands on the error output"
PROGRESS = 0.2  # seconds between two words to a terminal


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Fault(f"{message}; {PROGRAM} --help shows how")

    def format_help(self):
        return EXAMPLES + "\n" + super().format_help()


def parse(words):
    parser = Parser(prog=PROGRAM, usage=argparse.SUPPRESS, epilog=EXIT, allow_abbrev=False)
    parser.add_argument("log", nargs="?", metavar="LOG", help="a log that lcm-logger wrote")
    parser.add_argument("--live", action="store_true", help="listen to the bus instead")
    parser.add_argument("--lcm-url", metavar="URL", help=f"the bus; default: $LCM_DEFAULT_URL, else {DEFAULT_URL}")
    parser.add_argument("--seconds", type=float, metavar="N", help="listen for so long; default: until Ctrl-C")
    parser.add_argument("--table", metavar="TABLE", help="the mission's policy table: map, places, territories, routes")
    parser.add_argument("--quarter", metavar="PATH", default="quarter", help="the host tool; default: quarter on PATH")
    parser.add_argument("--rerun", metavar="OUT.rrd", help="write a Rerun recording")
    parser.add_argument("--mcap", metavar="OUT.mcap", help="write an MCAP file")
    parser.add_argument("--key", metavar="FILE", help="leave out termination signals without this key's seal")
    parser.add_argument("--lcm-gen", metavar="PATH", help="default: the one of the Python package lcm")
    asked = parser.parse_args(words)
    check(parser, asked)
    return asked


def check(parser, asked):
    if asked.live == (asked.log is not None):
        parser.error("name a log, or --live" if not asked.live else "a log, or --live, not both")
    if not asked.live and (asked.seconds is not None or asked.lcm_url is not None):
        parser.error("--seconds and --lcm-url belong to --live")
    if asked.seconds is not None and not 0 < asked.seconds < 1e9:
        parser.error("--seconds takes a number above 0")
    check_files(parser, asked)


def check_files(parser, asked):
    outputs = [path for path in (asked.rerun, asked.mcap) if path is not None]
    if not outputs:
        parser.error("nothing to write: name --rerun OUT.rrd, --mcap OUT.mcap or both")
    named = [os.path.realpath(path) for path in [asked.log, asked.table, asked.key, *outputs] if path is not None]
    if len(set(named)) < len(named):
        parser.error("two of the files named are the same")


def print_table(rows):
    """In columns as wide as they need, the first one to the left."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        print(row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(row[1:], widths[1:])), sep="  ")


class Tally:
    """Who said how much, and where it went."""

    def __init__(self):
        self.heard, self.skipped, self.went = {}, {}, {}

    def count(self, table, *key):
        table[key] = table.get(key, 0) + 1

    def sum(self, table):
        return sum(table.values())

    def report(self, sinks):
        names = [sink.name for sink in sinks]
        rows = [["channel", "messages", *(f"to {name}" for name in names), "skipped"]]
        for (channel,) in sorted(self.heard):
            skipped = sum(n for (of, _), n in self.skipped.items() if of == channel)
            went = [self.went.get((channel, name), 0) for name in names]
            rows.append([channel, *map(str, [self.heard[(channel,)], *went, skipped])])
        print_table(rows)


class Restarts:
    """How often the world's clock began again."""

    def __init__(self):
        self.last, self.times = 0, 0

    def hear(self, message):
        if message.kind in ("pose", "status"):
            if message.utime < self.last - BEHIND:
                self.times += 1
                self.last = message.utime
            self.last = max(self.last, message.utime)


class Progress:
    """To a terminal alone."""

    def __init__(self, source):
        self.source, self.next, self.begun = source, 0.0, time.monotonic()
        self.shown = sys.stderr.isatty()

    def tell(self, messages):
        if self.shown and time.monotonic() >= self.next:
            self.next = time.monotonic() + PROGRESS
            part = (f"{100 * self.source.at // self.source.size} %" if isinstance(self.source, Log)
                    else f"{self.next - self.begun:.0f} s")
            print(f"\r\033[K{part}, {messages} messages", end="", file=sys.stderr, flush=True)

    def end(self):
        if self.shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def convert(source, decoder, sinks, tally, notes):
    restarts, progress, messages = Restarts(), Progress(source), 0
    try:
        for channel, data in source:
            messages += 1
            progress.tell(messages)
            tally.count(tally.heard, channel)
            try:
                message = decoder.decode(channel, data)
            except Unfit as why:
                tally.count(tally.skipped, channel, str(why))
                continue
            restarts.hear(message)
            for sink in sinks:
                if sink.add(message):
                    tally.count(tally.went, channel, sink.name)
    finally:
        progress.end()
    if restarts.times > 0:
        notes.append(f"{source.path}: the world's clock begins again, {restarts.times} times; the runs lie one over "
                     "the other")


def check_anything(source, tally):
    heard, skipped = tally.sum(tally.heard), tally.sum(tally.skipped)
    if heard > skipped:
        return
    if heard == 0 and isinstance(source, Bus):
        raise Fault(f"{source.path}: heard nothing of Quarter's; start the demo on the same --lcm-url, then listen")
    if heard == 0:
        raise Fault(f"{source.path}: no whole message in it; record it anew")
    reasons = sorted({why for _, why in tally.skipped})
    raise Fault(f"{source.path}: none of {heard} messages fits ({', '.join(reasons)}); "
                "take the demo and the bridge from one checkout")


def write(asked, source, decoder, mission):
    """Makes all outputs or none."""
    title = Path(asked.log).stem if asked.log else "live"
    files, sinks, tally, notes = [], [], Tally(), []
    try:
        for make, path in ((RerunSink, asked.rerun), (McapSink, asked.mcap)):
            if path is not None:
                files.append(Outfile(path))
                sinks.append(make(files[-1].partial, mission, decoder.types, title))
        convert(source, decoder, sinks, tally, notes)
        check_anything(source, tally)
        for sink in sinks:
            sink.close()
        for file in files:
            file.keep()
    except OSError as error:
        raise Fault(f"the outputs cannot be written ({error.strerror or error}); free some space or name another folder"
                    ) from None
    finally:
        for made in [*sinks, *files]:
            made.drop()
    tell(source, tally, sinks, files, notes)


def tell(source, tally, sinks, files, notes):
    tally.report(sinks)
    for file in files:
        print(f"wrote {file.path}: {file.path.stat().st_size} bytes")
    for (channel, why), times in sorted(tally.skipped.items()):
        notes.append(f"{channel}: {times} skipped: {why}")
    for note in [*source.notes, *notes]:
        print(f"bridge: note: {note}", file=sys.stderr)
    sys.stdout.flush()


def end(number, _):
    raise SystemExit(128 + number)


def unsaid(error):
    """The outputs are written, but standard output takes no report. What is left of it is dropped, or Python would try again."""
    print(f"bridge: standard output cannot be written ({error.strerror}); the outputs are whole", file=sys.stderr)
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 2


def main(words):
    signal.signal(signal.SIGTERM, end)
    try:
        asked = parse(words)
        source = Bus(asked.lcm_url, asked.seconds) if asked.live else Log(asked.log)
        mission = inspect(asked.quarter, asked.table) if asked.table is not None else None
        write(asked, source, Decoder(asked.lcm_gen, read_key(asked.key) if asked.key is not None else None), mission)
    except Fault as fault:
        print(f"bridge: {fault}", file=sys.stderr)
        return 2
    except OSError as error:
        return unsaid(error)
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
