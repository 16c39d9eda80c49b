"""The experiments. Each takes the lab and the dictionary of pictures that it may add to, and returns plain data; the
same seeds give the same data to the last digit."""

import math
import random
import statistics
from pathlib import Path

from lab import SEEDS, course, side_by_side, spread
from plain_regions import divide_plainly

SMALL = ["fig43a", "fig43b", "fig43c", "fig43d", "fig43e", "fig43f"]
LARGE = ["rep", "spiders", "rooms"]
TUNED = LARGE + ["scattered", "fig53"]

# The strategy of the tables, and the others that are compared on map (f): the paper names none.
EPSILON = "epsilon:0.7"
STRATEGIES = {"epsilon-greedy, 0.7": (EPSILON, 30000), "uniform": ("uniform", 100000),
              "softmax, temperature 4": ("softmax:4", 200000), "softmax, temperature 0.1": ("softmax:0.1", 30000)}
EPISODES = 30000
GROWTH = 10000  # episodes on the large maps

# (V, Loc), the paper's own state, is what regions of one cell give.
APPROACHES = {"none, (V, Loc) key": ["--aggregate", "regions", "--region-size", 1, "--region-diameter", 1],
              "none, lossless key": ["--aggregate", "none"],
              "regions": ["--aggregate", "regions"],
              "regions and spots": ["--aggregate", "both"]}


def first(rows, holds):
    return next(int(row["episode"]) for row in rows if holds(row))


def spread_of(runs, key):
    return spread([run[key] for run in runs])


def until(rows, value, share):
    """Episodes after which MaxQ has come within a share of a value for good."""
    last = 0
    for row in rows:
        if row["max_q"] < value * (1 - share):
            last = row["episode"]
    return first(rows, lambda row: row["episode"] > last) if rows[-1]["episode"] > last else None


def converge(lab, name, optimum, strategy, episodes):
    """Twenty seeds of the paper setting on a small map, by Table 1's rule."""
    def one(seed):
        told, rows = lab.explore(name, episodes, seed, "--rule", "paper", "--explore", strategy)
        return {"max_q": told["max_q"], "value": told["value"], "entries": told["q_entries"],
                "episodes": until(rows, optimum, 1e-6), "near": until(rows, optimum, 0.01), "rows": rows}

    runs = side_by_side(one, SEEDS)
    done = [run for run in runs if run["episodes"] is not None]
    near = [run for run in runs if run["near"] is not None]
    return {"seeds": len(runs), "converged": len(done), "limit": episodes,
            "episodes": spread_of(done, "episodes") if done else None,
            "near": spread_of(near, "near") if near else None, "near_seeds": len(near),
            "max_q": spread_of(runs, "max_q"), "value": spread_of(runs, "value"),
            "entries": spread_of(runs, "entries"),
            "course": course([run["rows"] for run in runs], episodes, "max_q")}


def certify(lab, name, *options):
    runs = side_by_side(lambda seed: lab.learn(name, "--seed", seed, *options), SEEDS)
    return {"seeds": len(runs), "certified": sum(run["certified"] for run in runs),
            "episodes": spread_of(runs, "episodes"), "value": spread_of(runs, "value"),
            "bound": spread_of(runs, "objective_bound"),
            "entries": spread_of(runs, "q_entries")}


def maps(lab, pictures):
    """Section 4.3 on maps (a) to (f)."""
    found = {}
    for name in SMALL:
        pictures[f"fig43-{name[-1]}"], _ = lab.picture_of_map(name, "--robots", 2)
        proven = lab.ask("exact", lab.map(name), "--robots", 2, "--rule", "paper")
        found[name] = {"cells": proven["columns"] * proven["rows"], "free": proven["cells"],
                       "places": proven["places"], "optimum": proven["objective_value"],
                       "paper": converge(lab, name, proven["objective_value"], EPSILON, EPISODES),
                       "certified": certify(lab, name, "--rule", "paper")}
        pictures[f"fig44-{name[-1]}"] = lab.picture_of_policy(
            name, "--learner", "paper", "--gap", 0, "--episodes", EPISODES, "--rule", "paper", "--explore", EPSILON)
    return found


def strategies(lab, pictures):
    """The action strategies on map (f)."""
    optimum = lab.ask("exact", lab.map("fig43f"), "--robots", 2, "--rule", "paper")["objective_value"]
    return {label: converge(lab, "fig43f", optimum, plan, episodes) for label, (plan, episodes) in STRATEGIES.items()}


def states(lab, pictures):
    """Entries that the same games meet under the two keys."""
    found = {}
    for name in SMALL + ["fig53"] + LARGE:
        def count(key):
            runs = [lab.explore(name, GROWTH, seed, "--explore", "uniform", *APPROACHES[key])[0] for seed in SEEDS]
            return spread_of(runs, "q_entries")

        loc, lossless = side_by_side(count, ["none, (V, Loc) key", "none, lossless key"])
        told = lab.learn(name, "--episodes", 1)
        found[name] = {"cells": told["columns"] * told["rows"], "places": told["places"], "loc": loc,
                       "lossless": lossless}
    return found


def rules(lab, pictures):
    """What the forced choice of Table 1 costs."""
    found = {}
    for name, robots in [(name, 2) for name in SMALL] + [("split", None)]:
        crew = ["--robots", robots] if robots else []
        found[name] = {rule: lab.ask("exact", lab.map(name), *crew, "--rule", rule)["objective_value"]
                       for rule in ("paper", "free")}
    return found


def groups(lab, pictures):
    """Regions and spots of the map with 657 free cells; the plain pictures of the other large maps."""
    for name in LARGE:
        pictures[f"fig58-{name}"], _ = lab.picture_of_map(name, "--robots", 2)
    pictures["fig53"], regions = lab.picture_of_map("fig53", "--regions", "--region-size", 25, "--region-diameter", 15)
    pictures["fig55"], spots = lab.picture_of_map("fig53", "--spots", "--spot-size", 5, "--spot-diameter", 25)
    count, distance = divide_plainly((lab.root / lab.map("fig53")).read_text(encoding="utf-8"), 25, 15)
    return {"cells": regions["cells"], "regions": regions["regions"], "distance": regions["mean_distance"],
            "plain_regions": count, "plain_distance": distance, "places": spots["places"], "spots": spots["spots"]}


def approaches(lab, name):
    """Twenty seeds of each approach on a larger map."""
    found = {}
    for label, options in APPROACHES.items():
        runs = side_by_side(lambda seed: lab.explore(name, GROWTH, seed, "--explore", EPSILON, *options), SEEDS)
        curves = [rows for told, rows in runs]
        found[label] = {"entries": spread([told["q_entries"] for told, rows in runs]),
                        "value": spread([told["value"] for told, rows in runs]),
                        "regions": runs[0][0]["regions"], "spots": runs[0][0]["spots"],
                        "max_q_course": course(curves, GROWTH, "max_q"), "value_course": course(curves, GROWTH, "value"),
                        "entries_course": course(curves, GROWTH, "q_entries")}
    return found


def learning(lab, pictures):
    """Fig. 5.6 and 5.7: with and without aggregation on the map with 657 free cells."""
    for label, options in (("none", ["--aggregate", "none"]), ("both", ["--aggregate", "both"])):
        pictures[f"fig57-{label}"] = lab.picture_of_policy(
            "fig53", "--learner", "paper", "--gap", 0, "--episodes", 2000, "--explore", EPSILON, *options)
    return {"approaches": approaches(lab, "fig53"), "certified": certify(lab, "fig53")}


def growth(lab, pictures):
    """Fig. 5.9: Q-tables on REP, Spiders and Rooms."""
    return {name: {"approaches": approaches(lab, name), "certified": certify(lab, name)} for name in LARGE}


def options_of(attempt):
    kind = {(False, False): "none", (True, False): "regions", (False, True): "spots", (True, True): "both"}
    options = ["--aggregate", kind[attempt["regions"] > 0, attempt["spots"] > 0]]
    if attempt["regions"]:
        options += ["--region-size", attempt["region_size"], "--region-diameter", attempt["region_diameter"]]
    if attempt["spots"]:
        options += ["--spot-size", attempt["spot_size"], "--spot-diameter", attempt["spot_diameter"], "--spot-order",
                    attempt["spot_order"], "--spot-likelihood", attempt["spot_likelihood"]]
    return options


def tuning(lab, pictures):
    """`quarter tune` on the larger maps and on the control, and twenty seeds of what it recommends for both."""
    def one(name):
        told = lab.ask("tune", lab.map(name), "--robots", 2, "--learner", "paper", "--explore", EPSILON)
        tries = told["tries"]

        def best(holds):
            attempt = next(t for t in tries if holds(t))
            return {"gap": attempt["gap"], "value": attempt["objective_value"], "entries": attempt["q_entries"],
                    "options": " ".join(map(str, options_of(attempt)))}

        kinds = {"none": best(lambda t: not t["regions"] and not t["spots"]),
                 "regions": best(lambda t: t["regions"] and not t["spots"]),
                 "spots": best(lambda t: t["spots"] and not t["regions"]),
                 "both": best(lambda t: t["regions"] and t["spots"]),
                 "both, best order": best(lambda t: t["regions"] and t["spots"] and t["spot_order"] == "best"),
                 "both, nearest first": best(lambda t: t["regions"] and t["spots"] and t["spot_order"] == "nearest"),
                 "both, distance alone": best(lambda t: t["regions"] and t["spots"] and t["spot_likelihood"] == 0),
                 "both, likelihood too": best(lambda t: t["regions"] and t["spots"] and t["spot_likelihood"] > 0)}
        return {"tries": len(tries), "bound": told["objective_bound"], "certified": told["certified_setting"],
                "kinds": kinds}

    found = dict(zip(TUNED, side_by_side(one, TUNED)))
    for name, tuned in found.items():
        for kind, options in (("tuned", tuned["kinds"]["both"]["options"].split()), ("plain", ["--aggregate", "both"]),
                              ("none", ["--aggregate", "none"])):
            runs = side_by_side(lambda seed: lab.explore(name, GROWTH, seed, "--explore", EPSILON, *options)[0], SEEDS)
            tuned[kind] = {"value": spread_of(runs, "value"),
                           "entries": spread_of(runs, "q_entries")}
    return found


def likelihood(lab, pictures):
    """Likelihood in the regions, of the paper's size and of a size at which places do come to share regions."""
    found = {}
    for name in ["fig53"] + LARGE:
        for size, diameter in ((25, 15), (100, 40)):
            for weight in (0, 1, 10):
                options = ["--explore", EPSILON, "--aggregate", "regions", "--region-size", size, "--region-diameter",
                           diameter, "--region-likelihood", weight]
                runs = side_by_side(lambda seed: lab.explore(name, 2000, seed, *options)[0], SEEDS)
                found.setdefault(name, []).append(
                    {"size": size, "diameter": diameter, "weight": weight, "regions": runs[0]["regions"],
                     "value": spread_of(runs, "value"),
                     "entries": spread_of(runs, "q_entries")})
    return found


def count_falls(rows):
    """How often MaxQ falls from an episode to the next."""
    return sum(b["max_q"] < a["max_q"] - 1e-6 for a, b in zip(rows, rows[1:]))


def oscillation(lab, pictures):
    """Section 5.2.3: times from each cell, and from the representative, on map (d) in regions."""
    found = {}
    for times in ("true", "representative"):
        runs = side_by_side(lambda seed: lab.explore("fig43d", EPISODES, seed, "--explore", EPSILON, "--aggregate",
                                                     "regions", "--region-times", times)[1], SEEDS)
        late = [row["max_q"] for rows in runs for row in rows if row["episode"] > EPISODES / 2]
        found[times] = {"falls": spread(list(map(count_falls, runs))), "late_least": min(late), "late_most": max(late),
                        "seed_1": [[int(row["episode"]), row["max_q"]] for row in runs[0] if row["episode"] <= 3000]}
    return found


def anywhere(lab, pictures):
    """One table for any start, and one for any progress."""
    started = lab.learn("fig53", "--starts", "any", "--start-regions", 30)
    cleared = lab.learn("fig43f", "--cleared", "any", "--table-limit", 16)
    mission = lab.learn("fig53")
    return {"starts": started["anywhere"] | {"bytes": started["table_bytes"], "states": started["table_records"]},
            "cleared": cleared["anywhere"] | {"bytes": cleared["table_bytes"], "states": cleared["table_records"]},
            "one_start_bytes": mission["table_bytes"]}


GAMES = [0, 1, 2, 3, 5, 7, 10, 14, 20, 28, 40, 57, 80, 113, 160, 226, 320]


def hide(seed, places):
    """A hider's likelihoods, and the places that it hides in, game by game."""
    dice = random.Random(seed)
    weights = [round(dice.gammavariate(1.0, 1.0), 6) + 0.001 for _ in range(places)]
    return weights, dice.choices(range(places), weights, k=GAMES[-1])


def expected_time(routes, weights):
    """By sums that are right to the last digit: what sum() makes of floats depends on Python's version."""
    time = math.fsum(weights[p] * step for r in routes for p, step in zip(r["places"], r["steps"]))
    return time / math.fsum(weights)


def write_places(path, cells, weights, rows=30):
    """A mission's places as CSV, in metres: cells of one metre, row 0 on top."""
    lines = [f"{column + 0.5},{rows - row - 0.5},{weight}" for (column, row), weight in zip(cells, weights)]
    path.write_text("x,y,weight\n" + "\n".join(lines) + "\n")


def place_cells(drawing):
    rows = [line for line in drawing.splitlines() if not line.startswith(";")]
    return [(c, r) for r, row in enumerate(rows) for c, mark in enumerate(row) if mark.isdigit()]


def seek(lab, seed):
    """Excess of the expected time over that of a hider known, after each number of games."""
    folder = lab.scratch / f"belief-{seed}"
    folder.mkdir()
    drawing = (lab.root / lab.map("fig53")).read_text(encoding="utf-8")
    (folder / "map.txt").write_text(drawing, encoding="utf-8")
    cells = place_cells(drawing)
    (folder / "mission.yaml").write_text("map: map.txt\nplaces_csv: places.csv\n")
    weights, hidden = hide(seed, len(cells))

    def learn(with_weights):
        if with_weights is not None:
            write_places(folder / "places.csv", cells, with_weights)
        told = lab.ask("learn", folder / "mission.yaml", "--robots", 2, "--objective", "time")
        return expected_time(told["routes"], weights)

    known = learn(weights)
    times = []
    for games in GAMES:
        write_places(folder / "places.csv", cells, [1] * len(cells))
        if games > 0:
            (folder / "games.csv").write_text("place\n" + "".join(f"{p}\n" for p in hidden[:games]))
            lab.run("belief", folder / "mission.yaml", "--history", folder / "games.csv", "-o",
                    folder / "estimate.csv", "-q")
            (folder / "estimate.csv").replace(folder / "places.csv")
        times.append(learn(None) / known - 1)
    return {"known": known, "excess": times}


def settle(excess):
    """The number of games from which on the excess stays small; None: it does not."""
    return next((games for i, games in enumerate(GAMES) if max(excess[i:]) <= 0.02), None)


def belief(lab, pictures):
    """The third level: a hider whose habits are unknown at first."""
    runs = side_by_side(lambda seed: seek(lab, seed), SEEDS)
    excess = [spread([run["excess"][i] for run in runs]) for i in range(len(GAMES))]
    enough = settle([e["median"] for e in excess])
    settled = [settle(run["excess"]) for run in runs]
    never = 10**6
    return {"games": GAMES, "excess": excess, "enough": enough,
            "settled": statistics.median(never if games is None else games for games in settled),
            "known": spread_of(runs, "known")}


EXPERIMENTS = [maps, strategies, states, rules, groups, learning, growth, tuning, likelihood, oscillation, anywhere,
               belief]
# Those that every test repeats: they take seconds.
QUICK = [maps, rules, groups, oscillation, anywhere, belief]
