"""Quality over time as a picture: SVG text that is the same for the same data. Both axes are logarithmic; what is no gap at all lies on
the lowest line."""

import math

COLOURS = ["#0072B2", "#56B4E9", "#009E73", "#D55E00", "#CC79A7", "#E69F00", "#7f8c99"]
INK, RULE = "#1f2a36", "#d3d8dd"
LEFT, TOP, WIDTH, HEIGHT, LEGEND = 70, 40, 480, 300, 140
LEAST, MOST = 1e-5, 10.0  # gaps, as shares


def number(value):
    return f"{value:.1f}".rstrip("0").rstrip(".")


class Frame:
    def __init__(self, first, last):
        self.first, self.last = first, last

    def x(self, seconds):
        return LEFT + WIDTH * math.log(seconds / self.first) / math.log(self.last / self.first)

    def y(self, gap):
        share = math.log(min(max(gap, LEAST), MOST) / LEAST) / math.log(MOST / LEAST)
        return TOP + HEIGHT * (1 - share)


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{number(x)}" y="{number(y)}" text-anchor="{anchor}"{more}>{words}</text>'


def line(x1, y1, x2, y2):
    return f'<line x1="{number(x1)}" y1="{number(y1)}" x2="{number(x2)}" y2="{number(y2)}" stroke="{RULE}"/>'


def axes(frame, ticks):
    parts = []
    gap = LEAST
    while gap <= MOST * 1.01:
        label = "0" if gap == LEAST else f"{100 * gap:g} %"
        parts += [line(LEFT, frame.y(gap), LEFT + WIDTH, frame.y(gap)), text(LEFT - 8, frame.y(gap) + 4, label, "end")]
        gap *= 10
    for seconds in ticks:
        parts += [line(frame.x(seconds), TOP, frame.x(seconds), TOP + HEIGHT),
                  text(frame.x(seconds), TOP + HEIGHT + 18, f"{seconds:g}")]
    return parts + [text(LEFT + WIDTH / 2, TOP + HEIGHT + 38, "seconds of the processor")]


def curve(frame, points, colour, index, name):
    """A solver's: steps, for a plan stays until there is a better one."""
    parts, path = [], ""
    for i, (seconds, gap) in enumerate(points):
        x, y = number(frame.x(seconds)), number(frame.y(gap))
        path += f"M{x} {y}" if i == 0 else f"H{x}V{y}"
    if path:
        parts.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="2.5"/>')
    y = TOP + 12 + 22 * index
    x = LEFT + WIDTH + 16
    return parts + [f'<rect x="{x}" y="{y - 9}" width="12" height="12" fill="{colour}"/>', text(x + 18, y + 2, name, "start")]


def draw(title, curves, first, last):
    """`curves`: of each solver, (seconds, median gap)s in the order of time."""
    frame = Frame(first, last)
    ticks = [s for s in (0.001, 0.01, 0.1, 1, 10, 100) if first <= s <= last]
    width, height = LEFT + WIDTH + LEGEND, TOP + HEIGHT + 50
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
             f'font-family="Helvetica,Arial,sans-serif" font-size="13" fill="{INK}">',
             f'<rect width="{width}" height="{height}" fill="#fff"/>',
             text(LEFT + WIDTH / 2, 24, title, more=' font-size="16" font-weight="bold"'), *axes(frame, ticks)]
    for index, (name, points) in enumerate(curves.items()):
        parts += curve(frame, points, COLOURS[index % len(COLOURS)], index, name)
    return "\n".join(parts) + "\n</svg>\n"
