"""The report's charts, by pygal: SVG text that is the same for the same data, on every day and every machine."""

import math
import os
from xml.etree import ElementTree

os.environ["NO_LXML"] = "1"  # pygal takes lxml where it finds it, which lays attributes out in another way

import pygal  # noqa: E402

SVG = "http://www.w3.org/2000/svg"
INK, RULE, BLUE, PALE, RED, AMBER, GREEN = "#1f2a36", "#d3d8dd", "#0072B2", "#9ccbe8", "#D55E00", "#E69F00", "#009E73"
FRAME = f"""
text{{font-family:Helvetica,Arial,'Liberation Sans','DejaVu Sans',sans-serif;font-size:13px;fill:{INK}}}
.title{{text-anchor:middle}}.plot_title{{font-size:16px;font-weight:bold}}
.axis.x text{{text-anchor:middle}}.axis.y text{{text-anchor:end}}
.axis path{{fill:none;stroke:{RULE}}}.axis path.axis{{stroke:{INK}}}
rect.background{{fill:#fff}}.legends text{{font-size:12px}}.series path{{fill:none;stroke-linejoin:round}}"""
# Curves that run on one another: each is thinner than the one below, so that all are seen.
NESTED = [(PALE, 9), (AMBER, 5), (INK, 1.8), (GREEN, 3)]


def tag(name):
    return f"{{{SVG}}}{name}"


class Chart:
    """Curves over a logarithmic axis of episodes or games, which begins and ends where the data do."""

    def __init__(self, title, y_title, first, last, x_title="episodes", **more):
        ticks = [n for n in range(math.floor(math.log10(first)), math.floor(math.log10(last)) + 1) if 10 ** n >= first]
        self.xrange = (math.log10(first), math.log10(last))
        if self.xrange[1] - ticks[-1] > 0.2:
            ticks.append(self.xrange[1])
        if self.xrange[0] < ticks[0]:
            ticks.insert(0, self.xrange[0])
        self.css = []
        # Every option that could differ from run to run, such as the chart's name, is set.
        self.chart = pygal.XY(
            title=title, x_title=x_title, y_title=y_title, x_labels=ticks, xrange=self.xrange,
            x_value_formatter=lambda x: f"{round(10 ** x):,}" if x >= 0 else "0", show_dots=False, no_prefix=True, js=[], explicit_size=True,
            width=720, height=420, legend_at_bottom=True, truncate_legend=-1, margin=14,
            disable_xml_declaration=True, include_x_axis=False, allow_interruptions=True, **more)

    def add(self, label, points, colour, width, dash=None, fill=None):
        n = len(self.css)
        self.css.append(f".serie-{n} path{{stroke:{colour};stroke-width:{width}" +
                        (f";stroke-dasharray:{dash}" if dash else "") + (f";fill:{fill}" if fill else "") +
                        f"}}.legend rect.color-{n}{{fill:{fill or colour}}}")
        self.chart.add(label, points)

    def level(self, label, y):
        self.add(label, [(x, y) for x in self.xrange], RED, 1.8, "6,4")

    def svg(self):
        """Without what pygal adds: date and version in comments, a script, rules and text for pointing at things."""
        ElementTree.register_namespace("", SVG)
        # As many rows as pygal makes room for: it rounds them down.
        self.chart.legend_at_bottom_columns = 2 if len(self.css) == 4 else len(self.css)
        root = ElementTree.fromstring(self.chart.render())
        root.attrib.pop("id")
        style = root.find(f".//{tag('style')}")
        for parent in list(root.iter()):
            for child in list(parent):
                idle = child.tag == tag("g") and len(child) == 0 or "tooltip" in child.get("class", "")
                if child.tag in (tag("script"), tag("desc")) or idle or child.tag == tag("title") and parent is not root:
                    parent.remove(child)
        style.text = FRAME + "\n" + "\n".join(self.css) + "\n"
        return ElementTree.tostring(root, encoding="unicode")


def same(y):
    return y


def logged(points, column, transform=same):
    return [(round(math.log10(point[0]), 6), transform(point[column])) for point in points]


def outline(points, transform=same):
    """Around the range: the greatest from left to right, and back along the least."""
    around = logged(points, 3, transform) + logged(points, 2, transform)[::-1]
    return around + around[:1]


def decades(least, most):
    return list(range(math.floor(math.log10(least)), math.ceil(math.log10(most)) + 1))


def as_steps(points):
    """A value holds until the next one."""
    stairs = points[:1]
    for before, point in zip(points, points[1:]):
        stairs += [(point[0], before[1]), point]
    return stairs


def convergence(name, found):
    points = found["paper"]["course"]
    c = Chart(f"MaxQ on map ({name[-1]}): 20 seeds of the paper setting", "MaxQ", 1, points[-1][0])
    c.add("least to greatest", outline(points), PALE, 1, fill="#d6e9f5")
    c.add("median", logged(points, 1), BLUE, 2.5)
    c.level("proven optimum", found["optimum"])
    return c.svg()


CLOSED = -6  # what is left of a gap below a millionth is rounding


def gap(name, found):
    top, points = found["optimum"], found["paper"]["course"]
    c = Chart(f"Gap to the optimum on map ({name[-1]})", "(optimum - MaxQ) / optimum", 1, points[-1][0],
              y_labels=list(range(CLOSED, 1)), range=(CLOSED, 0),
              value_formatter=lambda y: "none" if y <= CLOSED else f"{100 * 10 ** y:g} %")

    def left(max_q):
        return round(math.log10(max(1 - max_q / top, 10 ** CLOSED)), 6)

    c.add("least to greatest", outline(points, left), PALE, 1, fill="#d6e9f5")
    c.add("median", logged(points, 1, left), BLUE, 2.5)
    return c.svg()


def learning(found, column, title, y_title):
    last = next(iter(found["approaches"].values()))[column][-1][0]
    c = Chart(title, y_title, 1, last)
    for (colour, width), (label, approach) in zip(NESTED, found["approaches"].items()):
        c.add(label, logged(approach[column], 1), colour, width)
    c.level("proven optimum", found["certified"]["value"]["median"])
    return c.svg()


def growth(name, found):
    approaches = found["approaches"]
    last = approaches["regions"]["entries_course"][-1][0]
    most = max(a["entries"]["most"] for a in approaches.values())
    c = Chart(f"Q entries on {name}: median of 20 seeds", "Q entries", 1, last, y_labels=decades(1, most),
              value_formatter=lambda y: f"{10 ** y:,.0f}")
    for (colour, width), (label, approach) in zip(NESTED, approaches.items()):
        c.add(label, logged(approach["entries_course"], 1, lambda y: round(math.log10(max(1, y)), 6)), colour, width)
    return c.svg()


def oscillation(found, optimum):
    c = Chart("MaxQ on map (d) in regions, seed 1, from the 100th episode on", "MaxQ of the aggregate", 100, 3000,
              range=(9, 9.6))
    for times, label, colour in (("true", "times from each cell", BLUE),
                                 ("representative", "from the representative", GREEN)):
        points = [(round(math.log10(episode), 6), max_q) for episode, max_q in found[times]["seed_1"] if episode >= 100]
        c.add(label, as_steps(points + [(c.xrange[1], points[-1][1])]), colour, 1.8)
    c.level("optimum of the map itself", optimum)
    return c.svg()


def belief(found):
    points = [[max(games, 0.7), 100 * e["median"], 100 * e["least"], 100 * e["most"]]
              for games, e in zip(found["games"], found["excess"])]
    c = Chart("A hider unknown at first: 20 hiders", "expected time over the best, %", 0.7, points[-1][0], "games played")
    c.add("least to greatest", outline(points), PALE, 1, fill="#d6e9f5")
    c.add("median", logged(points, 1), BLUE, 2.5)
    c.level("2 %", 2)
    return c.svg()


def draw(data):
    """All charts, by name."""
    charts = {f"fig45-{name[-1]}": convergence(name, found) for name, found in data["maps"].items()}
    charts |= {f"fig45-{name[-1]}-gap": gap(name, found) for name, found in data["maps"].items()}
    charts["fig56-maxq"] = learning(data["learning"], "max_q_course", "MaxQ, which on an aggregate is the aggregate's",
                                    "MaxQ")
    charts["fig56-value"] = learning(data["learning"], "value_course",
                                     "What the best policy so far earns on the true map", "discounted value")
    for name, found in data["growth"].items():
        charts[f"fig59-{name}"] = growth(name.upper() if name == "rep" else name.capitalize(), found)
    charts["fig54"] = oscillation(data["oscillation"], data["maps"]["fig43d"]["optimum"])
    charts["belief"] = belief(data["belief"])
    return charts
