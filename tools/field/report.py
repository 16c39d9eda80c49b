"""docs/benchmarks.md, from the data of a run."""

import json
from pathlib import Path
from string import Template

import charts
import summary
from suite import GROUPS

TEMPLATE = Path(__file__).resolve().parent / "report.md"


def percent(share):
    if share is None:
        return ""
    if share == float("inf"):
        return "-"
    return "0" if share < 5e-8 else f"{100 * share:.2g}" if share < 0.0995 else f"{100 * share:.0f}"


def seconds(value):
    return "" if value is None else f"{value:.2g}" if value < 99.5 else f"{value:.0f}"


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def of_cells(data, cell):
    """A row a cell and objective, a column a solver."""
    rows = []
    for (name, objective), instances in summary.by_cell(data["instances"]).items():
        told = [summary.of_solver(instances, solver) for solver in data["solvers"]]
        rows.append([f"{name}, {objective}", *(cell(one) if one["instances"] else "" for one in told)])
    return table(["problems", *data["solvers"]], rows)


def gap_cell(one):
    return "-" if one["gap"] == float("inf") else f"{percent(one['gap'])} / {percent(one['worst'])}"


def proof_cell(one):
    return f"{one['proved']} of {one['instances']}" + (f", {seconds(one['proof_seconds'])}" if one["proved"] else "")


def of_group(data, group):
    names = {cell.name() for cell in GROUPS[group]}
    return [instance for instance in data["instances"] if instance["cell"] in names]


def pictures(data):
    """Quality over time: a picture a group, by the file's name; none where no solver has a plan of most in that time."""
    drawn, first = {}, data["seconds"] / 1000
    for group in GROUPS:
        instances = of_group(data, group)
        courses = {solver: summary.course(instances, solver, first, data["seconds"]) for solver in data["solvers"]}
        if any(courses.values()):
            drawn[f"{group}.svg"] = charts.draw(f"{group} problems: median gap to the best plan", courses, first,
                                                data["seconds"])
    return drawn


def curves(data):
    rows = []
    for group in GROUPS:
        instances = of_group(data, group)
        for share in summary.SHARES if instances else ():
            at = share * data["seconds"]
            rows.append([group, f"{at:.2g}", *(percent(summary.over_time(instances, solver, at)) for solver in data["solvers"])])
    shown = [f"![Quality over time, {name}](benchmarks/{name})" for name in pictures(data)]
    return "\n\n".join([table(["size", "s", *data["solvers"]], rows), *shown])


def costs(data):
    parts = []
    for measure, points in data["costs"].items():
        cells = [f"{'' if point['certified'] * 2 > point['of'] else '>'}{seconds(point['seconds'])}" for point in points]
        parts.append(table([measure, *(str(point["at"]) for point in points)], [["s", *cells]]))
    return "\n\n".join(parts)


def of_contradictions(data):
    lines = [f"- **{instance['cell']}, {instance['objective']}, seed {instance['seed']}**: {fault}"
             for instance in data["instances"] for fault in summary.contradictions(instance)]
    return lines or ["- No plan is better than anybody's bound, and no plan was refused by the referee."]


def of_defeats(data):
    off = summary.behind(data["instances"], "Quarter")
    head = f"- Quarter's plan is behind another's on {len(off)} of {len(data['instances'])} problems"
    return [head + (":" if off else "."),
            *(f"  - {cell}, {objective}, seed {seed}: {percent(share)} %" for cell, objective, seed, share in off)]


def of_notes(data, name):
    results = [instance["results"].get(name) for instance in data["instances"]]
    notes = {result["note"] for result in results if result is not None and result["note"] is not None}
    return [f"- {name}, where it has no plan: {note}." for note in sorted(notes)]


def remarks(data):
    lines = of_contradictions(data) + of_defeats(data)
    for name in data["solvers"]:
        lines += of_notes(data, name)
    if data.get("kept"):
        lines.append(f"- The results of {', '.join(data['kept'])} are of an earlier run on this machine, on the same problems.")
    return "\n".join(lines + [f"- Left out: {what}." for what in data["left"]])


def write(data):
    facts = {key: data[key] for key in ("machine", "commit", "ortools", "didppy")}
    facts.update(seconds=f"{data['seconds']:g}", seeds=data["seeds"], minutes=f"{data['processor_seconds'] / 60:.0f}",
                 cost_seeds=data["cost_seeds"], cost_seconds=f"{data['cost_seconds']:g}",
                 gaps=of_cells(data, gap_cell), proofs=of_cells(data, proof_cell), curves=curves(data), costs=costs(data),
                 remarks=remarks(data))
    return Template(TEMPLATE.read_text(encoding="utf-8")).substitute(facts)


def as_text(data):
    """A line a problem."""
    instances = ",\n".join("  " + json.dumps(instance) for instance in data["instances"])
    rest = json.dumps({key: value for key, value in data.items() if key != "instances"}, indent=1)
    return rest.removesuffix("\n}") + ',\n "instances": [\n' + instances + "\n ]\n}\n"


def write_documents(docs, data, text):
    folder = docs / "benchmarks"
    folder.mkdir(exist_ok=True)
    (folder / "data.json").write_text(as_text(data), encoding="utf-8")
    for stale in folder.glob("*.svg"):
        stale.unlink()
    for name, picture in pictures(data).items():
        (folder / name).write_text(picture, encoding="utf-8")
    (docs / "benchmarks.md").write_text(text, encoding="utf-8")
