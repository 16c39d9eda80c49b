"""silence.py SECONDS COMMAND...: the command, its output stamped with the seconds since its start. Fails where it fails, and
where it was silent for longer than SECONDS."""

import selectors
import subprocess
import sys
import time


def stamped(stream, limit):
    """Copy the stream; the silences above the limit, as (seconds, the line before)."""
    start = last = time.monotonic()
    before, over = b"", []
    with selectors.DefaultSelector() as selector:
        selector.register(stream, selectors.EVENT_READ)
        while True:
            selector.select()
            chunk = stream.read1(1 << 16)
            now = time.monotonic()
            if now - last > limit:
                over.append((now - last, before.decode("utf-8", "replace")))
            if not chunk:
                return over
            last = now
            for line in chunk.splitlines():
                before = line
                sys.stdout.write(f"{now - start:7.1f}  {line.decode('utf-8', 'replace')}\n")
            sys.stdout.flush()


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    limit = float(sys.argv[1])
    process = subprocess.Popen(sys.argv[2:], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    over = stamped(process.stdout, limit)
    for seconds, line in over:
        print(f"silent for {seconds:.1f} s after: {line}")
    status = process.wait()
    print(f"status {status}, silent for longer than {limit:g} s: {len(over)} times")
    sys.exit(status or len(over) > 0)


main()
