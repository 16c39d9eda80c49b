"""The report's charts, by pygal: SVG text that is the same for the same data, on every day and every machine."""

import math
import os
from xml.etree import ElementTree

os.environ["NO_LXML"] = "1"  # pygal takes lxml where it finds it, which lays attributes out in another way

import pygal  # noqa: E402
from pygal.style import Style  # noqa: E402

SVG = "http://www.w3.org/2000/svg"

STYLE = Style(
    background="#ffffff", plot_background="#ffffff", foreground="#1f2a36", foreground_strong="#1f2a36",
    foreground_subtle="#d3d8dd", guide_stroke_color="#d3d8dd", guide_stroke_dasharray="none",
    major_guide_stroke_color="#d3d8dd", major_guide_stroke_dasharray="none", opacity="1", stroke_opacity="1",
    colors=("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#5d6976"),
    font_family="Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif",
    label_font_size=12, major_label_font_size=12, title_font_size=15, legend_font_size=12)
COLOURS = STYLE.colors
INK = "#1f2a36"


def decades(least, most):
    return list(range(math.floor(math.log10(least)), math.ceil(math.log10(most)) + 1))


def chart(title, y_title, last, colours, first=1, **more):
    # Every option that could differ from run to run, such as the chart's name, is set.
    return pygal.XY(
        style=Style(**{**STYLE.to_dict(), "colors": tuple(colours)}), title=title, x_title="episodes",
        y_title=y_title, x_labels=decades(first, last), x_value_formatter=lambda x: f"{10 ** x:,.0f}", show_dots=False,
        no_prefix=True, js=[], explicit_size=True, width=720, height=420, legend_at_bottom=True,
        legend_at_bottom_columns=2, truncate_legend=-1, margin=14, disable_xml_declaration=True, include_x_axis=False,
        allow_interruptions=True, **more)


def picture(c):
    """The chart alone: without the date and the version, which pygal leaves in comments, and without its script."""
    ElementTree.register_namespace("", SVG)
    root = ElementTree.fromstring(c.render())
    for parent in list(root.iter()):
        for script in parent.findall(f"{{{SVG}}}script"):
            parent.remove(script)
    return ElementTree.tostring(root, encoding="unicode")


def logged(points, column, transform=lambda y: y):
    return [(round(math.log10(point[0]), 6), transform(point[column])) for point in points]


def outline(points, transform=lambda y: y):
    """Around the range: the greatest from left to right, and back along the least."""
    return logged(points, 3, transform) + logged(points, 2, transform)[::-1]


def add(c, label, points, transform=lambda y: y):
    c.add(label, logged(points, 1, transform), stroke_style={"width": 2.5})


def convergence(name, found):
    points = found["paper"]["course"]
    top = found["optimum"]
    c = chart(f"MaxQ on map ({name[-1]}): 20 seeds of the paper setting", "MaxQ", points[-1][0],
              [COLOURS[0], "#8fbfdd", COLOURS[1]])
    add(c, "median", points)
    c.add("least to greatest", outline(points), stroke_style={"width": 1})
    c.add("proven optimum", [(0, top), (math.log10(points[-1][0]), top)], stroke_style={"width": 1.5, "dasharray": "6,4"})
    return picture(c)


def learning(found, column, title, y_title):
    last = next(iter(found["approaches"].values()))[column][-1][0]
    c = chart(title, y_title, last, COLOURS[:4] + (INK,))
    for label, approach in found["approaches"].items():
        add(c, label, approach[column])
    top = found["certified"]["value"]["median"]
    c.add("proven optimum (certified setting)", [(0, top), (math.log10(last), top)],
          stroke_style={"width": 1.5, "dasharray": "6,4"})
    return picture(c)


def growth(name, found):
    approaches = found["approaches"]
    last = approaches["regions"]["entries_course"][-1][0]
    most = max(a["entries"]["most"] for a in approaches.values())
    c = chart(f"Q entries on {name}: median of 20 seeds", "Q entries", last, COLOURS[:4], y_labels=decades(1, most),
              value_formatter=lambda y: f"{10 ** y:,.0f}")
    for label, approach in approaches.items():
        add(c, label, approach["entries_course"], lambda y: round(math.log10(max(1, y)), 6))
    return picture(c)


def oscillation(found):
    c = chart("MaxQ on map (d) in regions, seed 1: from the 100th episode on", "MaxQ of the aggregate", 3000,
              [COLOURS[1], COLOURS[0]], first=100, range=(8.8, 9.7), xrange=(2, 4))
    for times, label in (("true", "times from each cell (the first solution)"),
                         ("representative", "times from the representative (section 5.2.3)")):
        c.add(label, [(round(math.log10(episode), 6), max_q) for episode, max_q in found[times]["seed_1"]
                      if episode >= 100], stroke_style={"width": 1.5})
    return picture(c)


def belief(found):
    c = pygal.XY(
        style=Style(**{**STYLE.to_dict(), "colors": (COLOURS[0], "#8fbfdd", COLOURS[1])}),
        title="A hider unknown at first: 20 hiders", x_title="games played", y_title="expected time over the best, %",
        x_labels=decades(1, found["games"][-1]), x_value_formatter=lambda x: f"{10 ** x:,.0f}", show_dots=False,
        no_prefix=True, js=[], explicit_size=True, width=720, height=420, legend_at_bottom=True, truncate_legend=-1,
        legend_at_bottom_columns=3, margin=14, disable_xml_declaration=True, include_x_axis=True)
    points = [[max(games, 0.7), 100 * e["median"], 100 * e["least"], 100 * e["most"]]
              for games, e in zip(found["games"], found["excess"])]
    add(c, "median", points)
    c.add("least to greatest", outline(points), stroke_style={"width": 1})
    c.add("2 %", [(math.log10(0.7), 2), (math.log10(points[-1][0]), 2)], stroke_style={"width": 1.5, "dasharray": "6,4"})
    return picture(c)


def draw(data):
    """All charts, by name."""
    charts = {f"fig45-{name[-1]}": convergence(name, found) for name, found in data["maps"].items()}
    charts["fig56-maxq"] = learning(data["learning"], "max_q_course", "MaxQ, which on an aggregate is the aggregate's",
                                    "MaxQ")
    charts["fig56-value"] = learning(data["learning"], "value_course",
                                     "What the best policy so far earns on the true map", "discounted value")
    for name, found in data["growth"].items():
        charts[f"fig59-{name}"] = growth(name.upper() if name == "rep" else name.capitalize(), found)
    charts["fig54"] = oscillation(data["oscillation"])
    charts["belief"] = belief(data["belief"])
    return charts
