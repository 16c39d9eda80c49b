"""Solvers run on a problem, one after another, each for the same time of the processor; the referee judges what they found."""

import json
import os
import resource
import signal
import subprocess
import sys
from pathlib import Path

SOLVERS = Path(__file__).resolve().parent / "solvers"
OWN = {"Quarter": "certified", "paper setting": "paper", "quarter exact": "exact"}
OTHERS = {"routing": "routing.py", "CP-SAT": "cpsat.py", "DIDP": "didp.py", "dense Q": "dense_q.py"}
NAMES = [*OWN, *OTHERS]
JUDGED = 60  # plans of a solver that the referee is asked about
SAME = 1e-9


class Left(Exception):
    """A problem that the build does not hold."""


class Contest:
    """`bench` is the program quarter_bench, `packages` the folder in which the others' packages lie, `scratch` one for files."""

    def __init__(self, bench, packages, scratch, seconds):
        self.bench, self.packages, self.scratch, self.seconds = str(bench), packages, Path(scratch), seconds

    def ask(self, options, task, text=None, **limits):
        done = subprocess.run([self.bench, *map(str, options), "--task", task, "--time-limit", str(self.seconds)], input=text,
                              capture_output=True, encoding="utf-8", **limits)
        if "more than this build holds" in done.stderr:
            raise Left(done.stderr.strip())
        return done

    def write(self, options):
        """The problem's file, and what it says."""
        done = self.ask(options, "write")
        if done.returncode != 0:
            raise SystemExit(done.stderr.strip())
        path = self.scratch / "problem.json"
        path.write_text(done.stdout, encoding="utf-8")
        return path, json.loads(done.stdout)

    # ---- one solver ----

    def own(self, options, task):
        """The learner keeps its time itself; the exact solver, which has nothing before its end, is ended by a timer."""
        limits = {"preexec_fn": lambda: signal.setitimer(signal.ITIMER_PROF, self.seconds)} if task == "exact" else {}
        done = self.ask(options, task, **limits)
        if done.returncode < 0:
            return [{"seconds": self.seconds, "note": "it was not done in time"}]
        if done.returncode != 0:
            too_large = "too many" in done.stderr
            return [{"seconds": 0.0, "note": "the problem is too large for it" if too_large else done.stderr.strip()}]
        told = json.loads(done.stdout)
        said = [{"seconds": point["seconds"], "objective": point["objective"], "bound": point["bound"]}
                for point in told.get("points", [])]
        end = {key: told[key] for key in ("seconds", "routes", "bound", "proved")}
        return said + [end]

    def other(self, path, script):
        environment = {**os.environ, "PYTHONPATH": str(self.packages), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        done = subprocess.run([sys.executable, "-B", str(SOLVERS / script), str(path), str(self.seconds)], env=environment,
                              capture_output=True, encoding="utf-8")
        said = [json.loads(line) for line in done.stdout.splitlines() if line.endswith("}")]
        if done.returncode not in (0, -signal.SIGPROF):
            said.append({"seconds": 0.0, "note": (done.stderr.strip().splitlines() or ["it failed"])[-1][:200]})
        return said

    # ---- the referee ----

    def judge(self, options, plans):
        if not plans:
            return []
        text = "".join(" ".join(map(str, route)) + "\n" for plan in plans for route in plan)
        done = self.ask(options, "judge", text)
        if done.returncode != 0:
            raise SystemExit(done.stderr.strip())
        return json.loads(done.stdout)

    def judged(self, options, said, key):
        """(seconds, objective) of each plan, and what is wrong with those that are none."""
        plans = thinned([line for line in said if "routes" in line])
        verdicts = self.judge(options, [line["routes"] for line in plans])
        curve = [(line["seconds"], verdict[key]) for line, verdict in zip(plans, verdicts) if is_plan(verdict)]
        return curve, [verdict.get("fault", "looks are left out") for verdict in verdicts if not is_plan(verdict)]

    def result(self, options, problem, said):
        """Of what a solver said: objective by time as judged, its last bound, when it had proved it, notes."""
        by_time = problem["objective"] == "time"
        best, worst = (min, max) if by_time else (max, min)
        judged, faults = self.judged(options, said, "expected_time" if by_time else "value")
        claimed = [(line["seconds"], line["objective"]) for line in said if "objective" in line]
        return {"objective": best((objective for _, objective in judged), default=None),
                "curve": improving(judged + claimed, best), "bound": worst(each(said, "bound"), default=None),
                "proved_after": next((line["seconds"] for line in said if line.get("proved")), None),
                "faults": faults, "note": next(iter(each(said, "note")), None)}

    def run(self, options, names):
        """All solvers on one problem."""
        path, problem = self.write(options)
        results = {}
        for name in names:
            said = self.own(options, OWN[name]) if name in OWN else self.other(path, OTHERS[name])
            results[name] = self.result(options, problem, said)
        return problem, results


def is_plan(verdict):
    return verdict["legal"] and verdict["complete"]


def each(said, key):
    return [line[key] for line in said if line.get(key) is not None]


def thinned(plans):
    """The referee is not asked about each of thousands; the last one is the best."""
    return plans[:: max(1, len(plans) // JUDGED)][:-1] + plans[-1:]


def improving(curve, best):
    """Those of (seconds, objective) that are better than all before."""
    kept = []
    for seconds, objective in sorted(curve):
        if not kept or (best(objective, kept[-1][1]) == objective and abs(objective - kept[-1][1]) > SAME * abs(objective)):
            kept.append((seconds, objective))
    return kept


def processor_seconds():
    """That this process and those it ended have taken."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(u.ru_utime + u.ru_stime for u in used)
