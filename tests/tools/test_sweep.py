"""The sweep of tools/sweep: its jobs, its sums, its estimate; and, where there is Snakemake, a dry run and a small sweep, stopped and
taken up again."""

import argparse
import csv
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SWEEP = ROOT / "tools/sweep"
sys.path.insert(0, str(SWEEP))

import estimate  # noqa: E402
import jobs  # noqa: E402
import summary  # noqa: E402

DRAWING = "S..#1\n.~...\n2...3\n"


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found!r}, and not {wanted!r}")


def lay_missions(folder):
    for name in ("one", "two"):
        (folder / name).mkdir()
        (folder / name / "map.txt").write_text(DRAWING, encoding="utf-8")
    (folder / "lone.txt").write_text(DRAWING, encoding="utf-8")


def refused(config):
    try:
        jobs.of_config(config)
    except jobs.ConfigFault as fault:
        return str(fault)
    return sys.exit(f"{config} was taken")


def check_jobs(folder):
    config = {"missions": [f"{folder}/*/map.txt", f"{folder}/lone.txt", f"{folder}/one/*"],
              "settings": {"plain": "learn --robots 2", "two words": "tune"}, "seeds": [1, 7]}
    made = jobs.of_config(config)
    expect("jobs", len(made), 3 * 2 * 2)
    expect("a lone mission's name", "lone-plain-7" in made, True)
    expect("missions of one name", sum(name.endswith("one_map-two_words-1") for name in made), 1)
    expect("a job's words", made["lone-plain-7"]["words"],
           ["quarter", "learn", f"{folder}/lone.txt", "--robots", "2", "--seed", "7", "--quiet", "--json"])
    fits_nothing = f"{folder}/none*"
    expect("a pattern", refused({**config, "missions": [fits_nothing]}), f"missions: nothing fits '{fits_nothing}'")
    expect("no settings", refused({**config, "settings": {}}), "settings: there are none")
    expect("another key", refused({**config, "seed": 1}),
           "seed: is no key of a sweep; there are tool, missions, settings and seeds")
    expect("two of a name", refused({**config, "settings": {"a b": "learn", "a_b": "learn"}, "seeds": [1],
                                     "missions": [f"{folder}/lone.txt"]}), "two jobs have the name lone-a_b-1")


# Two cores for 10 s: a job takes 5 s of a core, of which 4 are its own.
def check_estimate():
    costs = [{"begin": begin, "end": begin + 4.5, "processor_seconds": 4.0, "megabytes": 10.0 + begin} for begin in (0.0, 0.5, 5.0, 5.5)]
    told = estimate.estimate(costs, 10000, 4)
    expect("cores in use", told["measured_cores"], 2)
    expect("core seconds a job", told["core_seconds_a_job"], 5.0)
    expect("hours", round(told["hours"], 9), round(10000 * 5 / 4 / 3600, 9))
    expect("processor's hours", round(told["processor_hours"], 9), round(10000 * 4 / 3600, 9))
    expect("memory", told["most_megabytes"], 15.5)


def check_measure(folder):
    """A command that fails leaves nothing; one that does not leaves both files."""
    done = subprocess.run([sys.executable, "-B", str(SWEEP / "measure.py"), "r.json", "c.json", "false"], cwd=folder)
    expect("the status of what failed", done.returncode, 1)
    expect("what it left", (folder / "r.json").exists() or (folder / "c.json").exists(), False)
    subprocess.run([sys.executable, "-B", str(SWEEP / "measure.py"), "r.json", "c.json", "echo", '{"gap": 0.5, "routes": [1, 2]}'],
                   cwd=folder, check=True)
    job = {"mission": "m", "setting": "s", "seed": 3}
    summary.write(folder / "s.csv", {"m-s-3": job}, [folder / "r.json"], [folder / "c.json"])
    with open(folder / "s.csv", newline="", encoding="utf-8") as file:
        row = next(csv.DictReader(file))
    expect("a row", (row["job"], row["gap"], row["routes"], row["seed"]), ("m-s-3", "0.5", "2", "3"))


# ---- with Snakemake ----

def sweep(snakemake, folder, *words):
    done = subprocess.run([snakemake, "-s", str(SWEEP / "Snakefile"), "--directory", str(folder), "--configfile",
                           str(folder / "config.json"), "--cores", "2", "--quiet", "all", *words],
                          capture_output=True, encoding="utf-8", cwd=folder)
    if done.returncode != 0:
        sys.exit(f"snakemake {' '.join(words)}:\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def check_sweep(snakemake, tool, folder):
    config = {"tool": str(Path(tool).resolve()), "missions": ["*/map.txt", "lone.txt"], "settings": {"plain": "learn --robots 2"},
              "seeds": [1, 2]}
    (folder / "config.json").write_text(json.dumps(config), encoding="utf-8")
    sweep(snakemake, folder, "--dry-run")
    expect("what a dry run leaves", (folder / "results").exists(), False)
    sweep(snakemake, folder)
    results = sorted(path.name for path in (folder / "results").iterdir())
    expect("results", len(results), 6)
    with open(folder / "summary.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    expect("rows, all certified", [row["certified"] for row in rows], ["True"] * 6)
    # As after a stop: one job's files are missing, and so is what comes last; that job alone is run again.
    (folder / "summary.csv").unlink()
    kept = {name: (folder / "results" / name).stat().st_mtime_ns for name in results}
    (folder / "results" / results[0]).unlink()
    sweep(snakemake, folder)
    again = [name for name in results if (folder / "results" / name).stat().st_mtime_ns != kept[name]]
    expect("what is run again", again, results[:1])
    expect("jobs that an estimate goes by", estimate.estimate(estimate.costs_in(folder), 1, 1)["measured_jobs"], 6)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quarter", required=True)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        lay_missions(Path(folder))
        check_jobs(folder)
        check_estimate()
        check_measure(Path(folder))
        snakemake = shutil.which("snakemake")
        if snakemake is None:
            print("SKIPPED: there is no snakemake (tools/sweep/requirements.txt); jobs, sums and estimate are as they should be")
            sys.exit(77)
        check_sweep(snakemake, asked.quarter, Path(folder))
    print("a sweep of 6 jobs, dry, whole, and taken up again")


if __name__ == "__main__":
    main()
