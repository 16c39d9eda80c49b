"""The comparison of ./run bench --field: its solvers find plans on small problems, what they prove is the exact optimum, and its
sums, gaps and contradictions are worked out by hand."""

import argparse
import importlib.util
import json
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/field"))

import report  # noqa: E402
import summary  # noqa: E402
from contest import OWN, Contest, improving  # noqa: E402
from suite import GROUPS, OBJECTIVES, SERIES, Cell  # noqa: E402

PROVERS = {"CP-SAT": "ortools", "DIDP": "didppy"}
PACKAGES = {**PROVERS, "routing": "ortools"}
SECONDS = 60.0  # ends what hangs: all of these prove their plans long before, or are given less


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found!r}, and not {wanted!r}")


def near(a, b, within=1e-5):
    return abs(a - b) <= within * abs(b)


# ---- solvers ----

def options_of(objective, looks=1, classes=1):
    cell = Cell("rooms", 6 if looks == 1 else 3, 2, 20, ("--looks", looks, "--classes", classes))
    return cell.options(objective, 7)


def there_are(packages, name):
    sys.path.insert(0, packages)
    return importlib.util.find_spec(PACKAGES[name]) is not None if name in PACKAGES else True


def optimum_of(contest, options):
    problem, results = contest.run(options, ["quarter exact"])
    result = results["quarter exact"]
    if result["note"] is not None or result["faults"]:
        sys.exit(f"quarter exact: {result}")
    return problem, result["objective"]


def expect_plan(name, result, optimum, by_time):
    expect(f"{name}: its faults", result["faults"], [])
    if result["objective"] is None:
        sys.exit(f"{name}: no plan: {result['note']}")
    if summary.is_better(result["objective"], optimum, by_time) and not near(result["objective"], optimum, 1e-9):
        sys.exit(f"{name}: {result['objective']} is better than the optimum, {optimum}")


def check_prover(contest, name, options):
    problem, optimum = optimum_of(contest, options)
    _, results = contest.run(options, [name])
    expect_plan(name, results[name], optimum, problem["objective"] == "time")
    if results[name]["proved_after"] is None or not near(results[name]["objective"], optimum):
        sys.exit(f"{name} has not proved {optimum} of {options}: {results[name]}")
    if not near(results[name]["bound"], optimum, 1e-4):
        sys.exit(f"{name}: its bound {results[name]['bound']} is not {optimum}")


def check_provers(contest, names):
    for options in (options_of("time"), options_of("discounted"), options_of("time", classes=2), options_of("discounted", looks=2)):
        for name in names:
            check_prover(contest, name, options)


def check_searchers(contest, names):
    """For as long as they need for any plan."""
    for objective in OBJECTIVES:
        problem, optimum = optimum_of(contest, options_of(objective))
        for name in names:
            _, results = contest.run(options_of(objective), [name])
            expect_plan(name, results[name], optimum, problem["objective"] == "time")


def check_solvers(bench, packages, scratch):
    found = [name for name in PACKAGES if there_are(packages, name)]
    check_provers(Contest(bench, packages, scratch, SECONDS), ["Quarter", *(name for name in found if name in PROVERS)])
    check_searchers(Contest(bench, packages, scratch, 0.4),
                    ["paper setting", "dense Q", *(name for name in found if name not in PROVERS)])
    return found


# ---- sums ----

def result(objective, bound=None, proved_after=None, curve=(), faults=(), note=None):
    return {"objective": objective, "bound": bound, "proved_after": proved_after, "curve": list(curve), "faults": list(faults),
            "note": note}


def instance(results, objective="time", seed=1):
    return {"cell": "rooms 12/2", "objective": objective, "seed": seed, "results": results}


def check_sums():
    one = instance({"Quarter": result(10.0, 10.0, 0.5, [(0.1, 12.0), (0.4, 10.0)]), "routing": result(11.0, curve=[(0.2, 11.0)])})
    two = instance({"Quarter": result(20.0, 19.0, None, [(0.1, 20.0)]), "routing": result(None, note="no plan")}, seed=2)
    told = summary.of_solver([one, two], "routing")
    expect("the gap of one without a plan", told["worst"], float("inf"))
    expect("notes", told["notes"], ["no plan"])
    told = summary.of_solver([one, two], "Quarter")
    expect("gap, proofs", (told["gap"], told["worst"], told["proved"], told["proof_seconds"]), (0.0, 0.0, 1, 0.5))
    expect("the gap before any plan", summary.over_time([one], "Quarter", 0.05), float("inf"))
    expect("the gap of the first plan", round(summary.over_time([one], "Quarter", 0.2), 9), 0.2)
    expect("the gap of the last plan", summary.over_time([one], "Quarter", 9.0), 0.0)
    expect("nobody is behind itself", summary.behind([one, two], "Quarter"), [])
    expect("who is behind", summary.behind([one], "routing"), [("rooms 12/2", "time", 1, 0.1)])
    expect("plans that are no better", improving([(2, 5.0), (1, 6.0), (3, 5.0), (4, 7.0)], min), [(1, 6.0), (2, 5.0)])


def check_contradictions():
    sound = instance({"Quarter": result(10.0, 9.0), "CP-SAT": result(11.0, 9.5)})
    expect("bounds below all plans", summary.contradictions(sound), [])
    beaten = instance({"Quarter": result(10.0, 9.0), "CP-SAT": result(11.0, 10.5)})
    expect("a bound that a plan beats", summary.contradictions(beaten), ["CP-SAT: its bound 10.5 is beaten by a plan of 10"])
    most = instance({"Quarter": result(10.0, 9.0), "CP-SAT": result(9.5, 11.0)}, "discounted")
    expect("a bound on what is to be most", summary.contradictions(most), ["Quarter: its bound 9 is beaten by a plan of 10"])
    unfit = instance({"DIDP": result(10.0, faults=["looks are left out"])})
    expect("a plan that is none", summary.contradictions(unfit), ["DIDP: looks are left out"])


def check_keeping():
    then = {"seconds": 1.0, "solvers": ["Quarter", "DIDP"], "processor_seconds": 5.0,
            "instances": [instance({"Quarter": result(12.0), "DIDP": result(13.0)})]}
    now = {"seconds": 1.0, "solvers": ["Quarter"], "processor_seconds": 1.0,
           "instances": [instance({"Quarter": result(10.0)}), instance({"Quarter": result(11.0)}, seed=2)]}
    summary.keep(now, then)
    expect("solvers kept", now["solvers"], ["Quarter", "DIDP"])
    expect("results, new before kept", [[each["objective"] for each in one["results"].values()] for one in now["instances"]],
           [[10.0, 13.0], [11.0]])


def check_report():
    data = {"machine": "a machine", "commit": "abc", "ortools": "1", "didppy": "2", "seconds": 1.0, "seeds": 1,
            "solvers": ["Quarter", "routing"], "processor_seconds": 120.0, "cost_seeds": 1, "cost_seconds": 1.0,
            "instances": [instance({"Quarter": result(10.0, 10.0, 0.5, [(0.1, 10.0)]), "routing": result(11.0)})],
            "costs": {"places": [{"at": 8, "seconds": 0.01, "certified": 1, "of": 1}, {"at": 9, "seconds": 1, "certified": 0, "of": 1}]},
            "left": ["scatter 1000/16: more than this build holds"]}
    text = report.write(data)
    for line in ("| rooms 12/2, time | 0 / 0 | 10 / 10 |", "| rooms 12/2, time | 1 of 1, 0.5 | 0 of 1 |", "| small | 0.1 |",
                 "| s | 0.01 | >1 |", "behind another's on 0 of 1 problems.", "- Left out: scatter 1000/16: more than this build"):
        if line not in text:
            sys.exit(f"the report lacks '{line}':\n{text}")
    picture = report.pictures(data)["small.svg"]
    expect("a picture's titles", [picture.count(word) for word in ("small problems", ">Quarter<", ">routing<", "<path")], [1, 1, 1, 1])
    ElementTree.fromstring(picture)
    expect("data written and read", json.loads(report.as_text(data)), json.loads(json.dumps(data)))
    data["instances"] = []
    report.write(data)


def check_documents():
    """docs/benchmarks.md and its pictures are made of its data."""
    docs = ROOT / "docs"
    data = json.loads((docs / "benchmarks/data.json").read_text(encoding="utf-8"))
    made = {"benchmarks.md": report.write(data)}
    made.update((f"benchmarks/{name}", picture) for name, picture in report.pictures(data).items())
    for name, text in made.items():
        if (docs / name).read_text(encoding="utf-8") != text:
            sys.exit(f"docs/{name} is not what ./run bench --field --write makes of docs/benchmarks/data.json")
    expect("contradictions", [fault for each in data["instances"] for fault in summary.contradictions(each)], [])


def check_suite():
    cells = [cell for group in GROUPS.values() for cell in group]
    expect("names of cells, each once", len({cell.name() for cell in cells}), len(cells))
    expect("what is measured along", list(SERIES), ["places", "robots", "cells", "steps a cell"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bench", required=True)
    parser.add_argument("--packages", required=True)
    asked = parser.parse_args()
    check_sums()
    check_contradictions()
    check_keeping()
    check_report()
    check_suite()
    check_documents()
    with tempfile.TemporaryDirectory() as scratch:
        found = check_solvers(asked.bench, asked.packages, scratch)
    told = ", ".join([*OWN, "dense Q", *found])
    print(f"{told}: plans on small problems, and proofs that agree with the exact optimum")
    missing = [name for name in PACKAGES if name not in found]
    if missing:
        print(f"without {', '.join(missing)}: ./run bench --field fetches them")


if __name__ == "__main__":
    main()
