"""What a sweep of many missions would cost, by one that was run: python3 tools/sweep/estimate.py FOLDER --jobs 10000 --cores 2"""

import argparse
import json
import statistics
import sys
from pathlib import Path


def costs_in(folder):
    return [json.loads(path.read_text(encoding="utf-8")) for path in sorted(Path(folder, "costs").glob("*.json"))]


def most_at_once(costs):
    """Jobs that ran side by side: the cores that were in use."""
    events = sorted([(cost["begin"], 1) for cost in costs] + [(cost["end"], -1) for cost in costs])
    running = most = 0
    for _, change in events:
        running += change
        most = max(most, running)
    return most


def estimate(costs, jobs, cores):
    """Hours and what they are made of. A job takes a core for its own time, and for what the workflow does beside it."""
    span = max(cost["end"] for cost in costs) - min(cost["begin"] for cost in costs)
    used = most_at_once(costs)
    processor = [cost["processor_seconds"] for cost in costs]
    a_job = span * used / len(costs)
    return {"measured_jobs": len(costs), "measured_cores": used, "measured_seconds": span,
            "median_processor_seconds": statistics.median(processor), "mean_processor_seconds": statistics.fmean(processor),
            "most_megabytes": max(cost["megabytes"] for cost in costs), "core_seconds_a_job": a_job,
            "jobs": jobs, "cores": cores, "processor_hours": jobs * statistics.fmean(processor) / 3600,
            "hours": jobs * a_job / cores / 3600}


def tell(told):
    return (f"{told['measured_jobs']} jobs on {told['measured_cores']} cores took {told['measured_seconds']:.1f} s: a job "
            f"{told['mean_processor_seconds']:.3g} s of the processor (median {told['median_processor_seconds']:.3g}), "
            f"{told['core_seconds_a_job']:.3g} s of a core with the workflow around it; {told['most_megabytes']:.0f} MB at most\n"
            f"{told['jobs']} jobs on {told['cores']} cores: {told['hours']:.3g} hours, {told['processor_hours']:.3g} of the "
            "processor in the tool")


def main(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", help="of a sweep that was run")
    parser.add_argument("--jobs", type=int, default=10000, help="that are to be run (default 10000)")
    parser.add_argument("--cores", type=int, default=2, help="that there will be (default 2)")
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args(words)
    costs = costs_in(asked.folder)
    if not costs:
        parser.error(f"{asked.folder}: no job has been run there")
    told = estimate(costs, asked.jobs, asked.cores)
    print(json.dumps(told) if asked.json else tell(told))


if __name__ == "__main__":
    main(sys.argv[1:])
