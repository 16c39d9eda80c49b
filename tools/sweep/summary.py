"""summary.csv: a row a job, of what the tool's JSON says in figures and words, and of what the job took."""

import csv
import json
from pathlib import Path

FIRST = ["job", "mission", "setting", "seed", "processor_seconds", "megabytes"]


def flat(report):
    """What stands in the report itself, and of lists how long they are."""
    return {key: len(value) if isinstance(value, list) else value for key, value in report.items()
            if not isinstance(value, dict)}


def read(path):
    return json.loads(Path(path).read_text(encoding="utf-8"))


def row_of(name, job, result, cost):
    row = {**flat(read(result)), **{key: job[key] for key in ("mission", "setting", "seed")}, "job": name}
    told = read(cost)
    return {**row, "processor_seconds": round(told["processor_seconds"], 3), "megabytes": round(told["megabytes"], 1)}


def write(path, jobs, results, costs):
    rows = [row_of(name, job, result, cost) for (name, job), result, cost in zip(jobs.items(), results, costs)]
    more = sorted({key for row in rows for key in row} - set(FIRST))
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, FIRST + more)
        writer.writeheader()
        writer.writerows(rows)
