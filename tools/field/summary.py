"""What comes of a run: gaps to the best known of all solvers, proofs, and what contradicts itself."""

import statistics

CLOSED = 1e-5  # as Quarter's own certificate has it
SHARES = (0.03, 0.1, 0.3, 1.0)  # of the time that each solver has


def is_better(objective, other, by_time):
    return objective < other if by_time else objective > other


def best_known(results, by_time):
    known = [result["objective"] for result in results.values() if result["objective"] is not None]
    return (min if by_time else max)(known, default=None)


def gap(objective, best):
    return None if objective is None else abs(objective - best) / abs(best)


def contradictions(instance):
    """Plans better than a bound, and plans that are none: somebody is wrong."""
    by_time, found = instance["objective"] == "time", []
    best = best_known(instance["results"], by_time)
    for name, result in instance["results"].items():
        found += [f"{name}: {fault}" for fault in result["faults"]]
        bound = result["bound"]
        if best is None or bound is None or not is_better(best, bound, by_time):
            continue
        if abs(best - bound) > CLOSED * abs(best):
            found.append(f"{name}: its bound {bound:.9g} is beaten by a plan of {best:.9g}")
    return found


def median(values):
    return statistics.median(values) if values else None


def of_solver(instances, name):
    """Over the instances of a cell: median and worst gap, the share proved, the median time of proof, and notes."""
    gaps, proofs, notes = [], [], set()
    for instance in instances:
        result = instance["results"].get(name)
        if result is None:
            continue
        best = best_known(instance["results"], instance["objective"] == "time")
        # One without a plan is as far away as can be told.
        gaps.append(float("inf") if result["objective"] is None else gap(result["objective"], best))
        proofs.append(result["proved_after"])
        if result["note"]:
            notes.add(result["note"])
    proved = [seconds for seconds in proofs if seconds is not None]
    return {"instances": len(gaps), "gap": median(gaps), "worst": max(gaps, default=None),
            "proved": len(proved), "proof_seconds": median(proved), "notes": sorted(notes)}


def by_cell(instances):
    """Instances by (cell, objective), in the order in which they were run."""
    cells = {}
    for instance in instances:
        cells.setdefault((instance["cell"], instance["objective"]), []).append(instance)
    return cells


def objective_at(curve, seconds):
    return next((objective for when, objective in reversed(curve) if when <= seconds), None)


def over_time(instances, name, seconds):
    """The median gap after so many seconds; infinite where most have no plan by then."""
    gaps = []
    for instance in instances:
        result = instance["results"].get(name)
        best = best_known(instance["results"], instance["objective"] == "time")
        if result is None or best is None:
            continue
        at = objective_at(result["curve"], seconds)
        gaps.append(float("inf") if at is None else gap(at, best))
    return median(gaps)


def course(instances, name, first, last):
    """(seconds, median gap) at moments a tenth apart, from the first at which most have a plan; each change once."""
    points, at = [], first
    while at <= last * 1.000001:
        gap_then = over_time(instances, name, at)
        if gap_then is not None and gap_then != float("inf") and (not points or gap_then != points[-1][1]):
            points.append((at, gap_then))
        at *= 1.1
    return points + [(last, points[-1][1])] if points else []


def keep(data, earlier):
    """The results of an earlier run's other solvers, on the same problems and in the same time, into this run's data."""
    if earlier["seconds"] != data["seconds"]:
        raise SystemExit(f"--keep: there the solvers had {earlier['seconds']:g} s each, and here {data['seconds']:g} s")
    known = {(each["cell"], each["objective"], each["seed"]): each["results"] for each in earlier["instances"]}
    for each in data["instances"]:
        each["results"] = {**known.get((each["cell"], each["objective"], each["seed"]), {}), **each["results"]}
    data["kept"] = [name for name in earlier["solvers"] if name not in data["solvers"]]
    data["solvers"] = list(dict.fromkeys([*earlier["solvers"], *data["solvers"]]))
    data["processor_seconds"] += earlier["processor_seconds"]


def behind(instances, name):
    """Where a plan of another's is better than this one's, and by how much."""
    found = []
    for instance in instances:
        best = best_known(instance["results"], instance["objective"] == "time")
        result = instance["results"].get(name)
        if result is None or best is None:
            continue
        off = float("inf") if result["objective"] is None else gap(result["objective"], best)
        if off > 1e-9:
            found.append((instance["cell"], instance["objective"], instance["seed"], off))
    return found
