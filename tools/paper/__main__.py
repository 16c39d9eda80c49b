"""Regenerates docs/paper.md, its data and its pictures; or checks that they are what the tool gives now."""

import argparse
import json
import re
import sys
import tempfile
import time
from datetime import date
from pathlib import Path
from string import Template

import charts
import schemes
import tables
from experiments import EXPERIMENTS, QUICK
from lab import Lab

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
EXAMPLES = """examples:
  ./run paper                        run all, write docs/paper.md and docs/paper/
  ./run paper --check                run all, and say what is not as written there
  ./run paper --check --quick        the same with the experiments that take seconds
  ./run paper --only maps,belief     run these, take the rest from docs/paper/data.json
"""


def parse(words):
    parser = argparse.ArgumentParser(prog="./run paper", description=__doc__, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tool", help=argparse.SUPPRESS)
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if anything would change")
    parser.add_argument("--quick", action="store_true", help="run " + ", ".join(e.__name__ for e in QUICK) + " alone")
    parser.add_argument("--only", metavar="NAMES", help="run these alone: " + ", ".join(e.__name__ for e in EXPERIMENTS))
    asked = parser.parse_args(words)
    chosen = QUICK if asked.quick else EXPERIMENTS
    if asked.only is not None:
        known = {e.__name__: e for e in EXPERIMENTS}
        unknown = [name for name in asked.only.split(",") if name not in known]
        if unknown:
            parser.error(f"--only: there is no experiment '{unknown[0]}'; there are {', '.join(known)}")
        chosen = [known[name] for name in asked.only.split(",")]
    return asked, chosen


def as_text(data):
    """Innermost lists on one line: small changes make small diffs."""
    text = json.dumps(data, indent=1)
    return re.sub(r"\[([^\[\]{}]*)\]", lambda inner: "[" + " ".join(inner[1].split()) + "]", text) + "\n"


def run(lab, chosen):
    data, pictures = {}, {}
    for i, experiment in enumerate(chosen):
        begin = time.monotonic()
        if sys.stderr.isatty():
            print(f"\r\033[K{i + 1} of {len(chosen)}: {experiment.__name__} ...", end="", file=sys.stderr, flush=True)
        data[experiment.__name__] = json.loads(json.dumps(experiment(lab, pictures)))
        if sys.stderr.isatty():
            print(f"\r\033[K{experiment.__name__}: {time.monotonic() - begin:.0f} s", file=sys.stderr)
    return data, pictures


def make_report(data):
    facts = {name: getattr(tables, name)(data) for name in
             ("maps", "strategies", "states", "rules", "groups", "growth", "tuning", "likelihood", "oscillation", "anywhere", "belief")}
    facts["learning"] = tables.approaches(data["learning"])
    facts["enough"] = data["belief"]["enough"]
    facts["enough_single"] = tables.number(data["belief"]["settled"])
    facts["uniform_excess"] = tables.percent(data["belief"]["excess"][0]["median"])
    tuned = data["tuning"]["fig53"]
    facts["fig53_tuned"] = tables.tuned_loss(data, "fig53")
    facts["fig53_plain"] = tables.percent(1 - tuned["plain"]["value"]["median"] / tuned["bound"])
    facts["fig53_options"] = tuned["kinds"]["both"]["options"]
    facts["fig53_entries"] = tables.number(tuned["tuned"]["entries"]["median"])
    facts["least_spotless"] = tables.percent(min(t["kinds"][kind]["gap"] for t in data["tuning"].values()
                                                 for kind in ("none", "regions")))
    facts["scattered_tuned"] = tables.tuned_loss(data, "scattered")
    return Template((HERE / "report.md").read_text(encoding="utf-8")).substitute(facts)


def compare(path, text, passing, faults):
    name = path.relative_to(ROOT)
    if not path.exists():
        faults.append(f"{name}: missing")
    elif path.read_text(encoding="utf-8") != text:
        faults.append(f"{name}: not what is made now")
    faults += [f"{name}: holds '{word}', which is another on another day or machine" for word in passing if word in text]


def compare_all(files, forbidden):
    faults = []
    for path, text in files.items():
        compare(path, text, forbidden, faults)
    for fault in faults:
        print(fault)
    return faults


def main(words):
    asked, chosen = parse(words)
    folder = ROOT / "docs" / "paper"
    known = folder / "data.json"
    written = json.loads(known.read_text(encoding="utf-8")) if known.exists() else {}
    with tempfile.TemporaryDirectory() as scratch:
        found, pictures = run(Lab(asked.tool, ROOT, scratch), chosen)
    data = {e.__name__: found.get(e.__name__, written.get(e.__name__)) for e in EXPERIMENTS}
    missing = [name for name, result in data.items() if result is None]
    if missing:
        sys.exit(f"./run paper: {known.relative_to(ROOT)} lacks {missing[0]}: run ./run paper without --quick or --only")
    pictures.update(charts.draw(data) | schemes.draw())
    files = {known: as_text(data), ROOT / "docs" / "paper.md": make_report(data)}
    files.update({folder / f"{name}.svg": text for name, text in pictures.items()})
    if asked.check:
        faults = compare_all(files, [date.today().isoformat(), charts.pygal.__version__, str(ROOT), scratch])
        print(f"{len(files)} files, {len(faults)} faults; experiments run: {len(chosen)}")
        return 1 if faults else 0
    folder.mkdir(exist_ok=True)
    for path, text in files.items():
        path.write_text(text, encoding="utf-8")
    print(f"wrote docs/paper.md and {len(files) - 1} files in docs/paper/")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
