"""The report's tables, as Markdown."""

from math import comb, prod


def number(x, digits=6):
    if x is None:
        return "-"
    if abs(x - round(x)) < 1e-9 and abs(x) < 1e15:
        return f"{round(x):,}"
    return f"{x:,.{digits}g}" if abs(x) < 1e5 else f"{x:,.0f}"


def with_range(s, digits=6):
    """`8,304 (2,725 to 16,822)`, or one number where all are the same."""
    if s is None:
        return "-"
    middle, least, most = (number(s[key], digits) for key in ("median", "least", "most"))
    return middle if least == most else f"{middle} ({least} to {most})"


def percent(share):
    """Two digits; none where less than a thousandth of a per cent is left."""
    if abs(share) < 1e-5:
        return "0 %"
    return f"{100 * share:.0f} %" if abs(share) >= 0.0995 else f"{100 * share:.2g} %"


def power_of_ten(x):
    mantissa, exponent = f"{x:.2e}".split("e")
    return number(x) if x < 1e5 else f"{mantissa} x 10^{int(exponent)}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def letter(name):
    return f"({name[-1]})" if name.startswith("fig43") else {"rep": "REP", "fig53": "Fig. 5.3"}.get(name, name.capitalize())


PAPER_EPISODES = {"fig43a": "5", "fig43f": "30,000"}
PAPER_NEAR = {"fig43f": "1,500"}


def maps(data):
    rows = []
    for name, found in data["maps"].items():
        paper, certified = found["paper"], found["certified"]
        size = f"{letter(name)}, {found['places']} places"
        rows.append([size, "episodes to converge", PAPER_EPISODES.get(name, "not told"), with_range(paper["episodes"]),
                     with_range(certified["episodes"]), ""])
        rows.append(["", "episodes to within 1 %", PAPER_NEAR.get(name, "not told"), with_range(paper["near"]),
                     with_range(certified["episodes"]), ""])
        rows.append(["", "MaxQ at the end", "optimal", f"{with_range(paper['max_q'])}; optimal in {paper['converged']} of {paper['seeds']}",
                     f"{with_range(certified['bound'])}; certified in {certified['certified']} of {certified['seeds']}",
                     number(found["optimum"])])
        rows.append(["", "Q entries", "not told", with_range(paper["entries"]), with_range(certified["entries"]), ""])
    return table(["map", "measure", "paper", "paper setting here", "certified setting here", "proven optimum"], rows)


def strategies(data):
    rows = [[label, with_range(run["episodes"]), with_range(run["near"]), f"{run['converged']} of {run['seeds']}",
             number(run["limit"]), with_range(run["entries"])] for label, run in data["strategies"].items()]
    return table(["strategy", "episodes to converge", "to within 1 %", "seeds that converged", "within episodes",
                  "Q entries"], rows)


def eq_410(h, cells):
    return 1 + sum(comb(h, i) * i * (i - 1) * (1 + (h - i) * cells) for i in range(1, h + 1))


def eq_411(h, k, cells):
    total = 1
    for i in range(1, h + 1):
        for j in range(1, min(k, i) + 1):
            here = prod(i - l + 1 for l in range(1, j + 1))
            way = prod((i - j - l + 1) * (h - i - l + 1) * cells for l in range(1, k - j + 1))
            total += comb(h, i) * here * way
    return total


def states(data):
    rows = []
    for name, found in data["states"].items():
        h, cells = found["places"], found["cells"]
        loc, lossless = found["loc"], found["lossless"]
        assert eq_410(h, cells) == eq_411(h, 2, cells)
        rows.append([letter(name), h, power_of_ten(eq_410(h, cells)), with_range(loc), with_range(lossless),
                     percent(1 - lossless["median"] / loc["median"])])
    return table(["map", "places", "Eq. 4.10 = Eq. 4.11, k = 2", "entries, (V, Loc) key", "entries, lossless key",
                  "fewer by"], rows)


def rules(data):
    rows = [[letter(name) if name != "split" else "split.txt", number(v["paper"]), number(v["free"]),
             percent(1 - v["paper"] / v["free"])] for name, v in data["rules"].items()]
    return table(["map", "optimum under Table 1", "optimum under the free rule", "the forced choice costs"], rows)


def groups(data):
    g = data["groups"]
    rows = [["free cells", 657, number(g["cells"]), ""],
            ["regions, 25 / 15", 43, number(g["regions"]), number(g["plain_regions"])],
            ["mean distance to the representative, steps", "not told", number(g["distance"], 3), number(g["plain_distance"], 3)],
            ["places", 12, number(g["places"]), ""],
            ["spots, 5 / 25", 8, number(g["spots"]), ""]]
    return table(["measure", "paper", "here", "plain greedy in scan order"], rows)


def approaches(found):
    optimum = found["certified"]["value"]["median"]
    rows = [[label, with_range(a["entries"]), with_range(a["value"]), percent(1 - a["value"]["median"] / optimum)]
            for label, a in found["approaches"].items()]
    certified = found["certified"]
    rows.append([f"certified setting; episodes: {with_range(certified['episodes'])}", with_range(certified["entries"]),
                 with_range(certified["value"]), percent(1 - certified["value"]["median"] / certified["bound"]["median"])])
    return table(["approach", "Q entries", "value on the ground", "below the proven optimum"], rows)


def growth(data):
    rows = []
    for name, found in data["growth"].items():
        entries = {label: a["entries"]["median"] for label, a in found["approaches"].items()}
        tuned = data["tuning"][name]
        optimum = found["certified"]["value"]["median"]
        for label, both, value in (("5 / 25", entries["regions and spots"], found["approaches"]["regions and spots"]["value"]),
                                   ("tuned", tuned["tuned"]["entries"]["median"], tuned["tuned"]["value"])):
            rows.append([letter(name), label, number(entries["none, (V, Loc) key"]), number(entries["none, lossless key"]),
                         number(entries["regions"]), number(both), "about 10 : 1",
                         f"{entries['none, lossless key'] / both:,.0f} : 1", with_range(value),
                         number(optimum), percent(1 - value["least"] / optimum)])
    return table(["map", "spots", "none, (V, Loc)", "none, lossless", "regions", "both", "none : both, paper", "here",
                  "value of both on the ground", "proven optimum", "worst seed below it"], rows)


def tuning(data):
    rows = []
    for name, tuned in data["tuning"].items():
        for kind, best in tuned["kinds"].items():
            rows.append([letter(name) if kind == "none" else "", kind, percent(best["gap"]), number(best["entries"]),
                         f"`{best['options']}`" if kind == "both" else ""])
        rows.append(["", "certified setting, no aggregation",
                     percent(tuned["bound"] / tuned["certified"]["objective_value"] - 1),
                     number(tuned["certified"]["q_entries"]), ""])
    return table(["map", "kind", "gap on the ground", "Q entries", "options"], rows)


def likelihood(data):
    rows = []
    for name, measured in data["likelihood"].items():
        for size in dict.fromkeys((run["size"], run["diameter"]) for run in measured):
            runs = [run for run in measured if (run["size"], run["diameter"]) == size]
            blind = runs[0]["value"]["median"]
            for run in runs:
                gain = run["value"]["median"] / blind - 1
                rows.append([letter(name), f"{run['size']} / {run['diameter']}", run["weight"], run["regions"],
                             number(run["entries"]["median"]), with_range(run["value"]),
                             f"{'+' if gain > 0 else '-'}{percent(gain).lstrip('-')}" if gain else "as before" if run["weight"] else ""])
    return table(["map", "regions of", "W", "regions", "Q entries", "value on the ground", "against W = 0"], rows)


def tuned_loss(data, name):
    """Share of the proven bound that the worst of the tuned seeds is below it."""
    tuned = data["tuning"][name]
    return percent(1 - tuned["tuned"]["value"]["least"] / tuned["bound"])


def oscillation(data):
    rows = []
    for times, label in (("true", "each cell (first solution)"), ("representative", "the representative")):
        o = data["oscillation"][times]
        rows.append([label, with_range(o["falls"]), f"{number(o['late_least'], 4)} to {number(o['late_most'], 4)}"])
    return table(["times taken from", "times that MaxQ fell, in 30,000 episodes", "MaxQ in the second half, all seeds"], rows)


def anywhere(data):
    s, c = data["anywhere"]["starts"], data["anywhere"]["cleared"]
    rows = [["Fig. 5.3, `--starts any`", f"{number(s['games'] - 1)} crews of {number(s['regions'])} regions, and the mission's own", number(s["states"]),
             number(s["bytes"]), percent(s["median_loss"]), percent(s["worst_loss"])],
            ["(f), `--cleared any`", f"{number(c['games'])} sets of places", number(c["states"]), number(c["bytes"]),
             "0 %: each set has its own certified policy", "0 %"]]
    return table(["table", "policies in it", "states", "bytes", "median loss of 100 random starts", "worst"], rows)


def belief(data):
    b = data["belief"]
    rows = [[number(games), percent(e["median"]), percent(e["least"]), percent(e["most"])]
            for games, e in zip(b["games"], b["excess"]) if games in (0, 5, 10, 20, 40, 80, 160, 320)]
    return table(["games", "median over the best", "least", "most"], rows)
