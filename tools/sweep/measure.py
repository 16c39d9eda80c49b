"""measure.py RESULT COST WORD...: runs a command, writes what it prints to RESULT and what it took to COST, as JSON. A command that
fails leaves neither."""

import json
import os
import resource
import subprocess
import sys
import time


def write(path, text):
    """Whole or not at all."""
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".part", path)


def main(result, cost, *words):
    begin = time.time()
    done = subprocess.run(words, stdout=subprocess.PIPE, encoding="utf-8")
    # Ended by its time limit it has a plan all the same; 2 and more is bad input, or nothing at all.
    if done.returncode != 0:
        return done.returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    write(result, done.stdout)
    write(cost, json.dumps({"begin": begin, "end": time.time(), "processor_seconds": used.ru_utime + used.ru_stime,
                            "megabytes": used.ru_maxrss / 1024}) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
