"""The schemes of Fig. 4.1, 5.1 and 5.2, drawn anew from what the paper's text says of them."""

from xml.sax.saxutils import escape

INK, MUTED, PLAIN, LEARNT, WRAP = "#1f2a36", "#5d6976", "#ffffff", "#d6e9f5", "#fbe6c8"


class Scheme:
    def __init__(self, title, width, height):
        self.width, self.height, self.title = width, height, title
        self.parts = []

    def box(self, x, y, width, height, lines, fill=PLAIN, dash=False):
        """Text in the middle, the first line bold."""
        self.parts.append(f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="6" fill="{fill}" stroke="{INK}" '
                          f'stroke-width="1.4"{" stroke-dasharray=" + chr(34) + "5 4" + chr(34) if dash else ""}/>')
        for n, line in enumerate(lines):
            self.text(x + width / 2, y + height / 2 + 4.5 + 17 * (n - (len(lines) - 1) / 2), line, bold=n == 0)

    def text(self, x, y, line, anchor="middle", bold=False, colour=INK):
        self.parts.append(f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}" fill="{colour}"'
                          f'{" font-weight=" + chr(34) + "bold" + chr(34) if bold else ""}>{escape(line)}</text>')

    def arrow(self, *points):
        """From point to point, with a head at the last one."""
        way = "L".join(f"{x:g} {y:g}" for x, y in points)
        self.parts.append(f'<path d="M{way}" fill="none" stroke="{INK}" stroke-width="1.5" marker-end="url(#head)"/>')

    def svg(self):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{self.width}" height="{self.height}" '
                f'viewBox="0 0 {self.width} {self.height}" font-family="Helvetica, Arial, \'Liberation Sans\', '
                f'\'DejaVu Sans\', sans-serif" font-size="13">\n<title>{escape(self.title)}</title>\n'
                '<defs><marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7" '
                f'orient="auto"><path d="M0 0L10 5L0 10z" fill="{INK}"/></marker></defs>\n'
                f'<rect width="100%" height="100%" fill="#fbfaf7"/>\n<text x="20" y="30" font-size="16" '
                f'font-weight="bold" fill="{INK}">{escape(self.title)}</text>\n' + "\n".join(self.parts) + "\n</svg>\n")


def elemental(s, y, what):
    """The row of blocks, each of which knows the way to one target, and the arrows into and out of them."""
    for x, number in ((60, "1"), (250, "2"), (500, "h")):
        s.box(x, y, 150, 58, ["Elemental task", f"way to {what} {number}"], LEARNT)
        s.arrow((x + 75, y - 52), (x + 75, y))
        s.arrow((x + 75, y + 58), (x + 75, y + 96))
    s.text(450, y + 34, ". . .", bold=True)
    s.box(60, y + 98, 590, 34, ["ground actions N, E, S, W"])


def hierarchy():
    s = Scheme("Fig. 4.1: a sequence of elemental tasks for h hiding places", 710, 400)
    s.box(150, 52, 410, 58, ["Composite task (Q-learning)", "state (V, Loc): which place next, for each seeker"], LEARNT)
    s.arrow((355, 110), (355, 150))
    s.text(370, 134, "the place chosen switches its block on", "start", colour=MUTED)
    s.box(60, 152, 590, 26, ["current location of the seeker"])
    elemental(s, 230, "place")
    s.text(355, 384, "Here the blocks are shortest-path searches, as section 4.1 allows.", colour=MUTED)
    return s.svg()


def aggregated_hierarchy():
    s = Scheme("Fig. 5.2: the same with state aggregation", 710, 510)
    s.box(150, 52, 410, 58, ["Composite task (Q-learning)", "state (spots visited, regions): which spot next"], LEARNT)
    s.arrow((355, 110), (355, 146))
    s.box(150, 148, 410, 44, ["Hiding aggregation", "a spot becomes its places, one after another"], WRAP)
    s.arrow((355, 192), (355, 226))
    s.text(370, 213, "the place to go to now", "start", colour=MUTED)
    s.box(60, 228, 590, 60, ["Topological aggregation", "a location becomes its region, whose representative stands for it"], WRAP)
    elemental(s, 340, "place")
    s.text(355, 494, "Higher layer: spots for places. Lower layer: regions for locations.", colour=MUTED)
    return s.svg()


def unit():
    s = Scheme("Fig. 5.1: Q-learning with a state aggregation unit", 780, 420)
    s.box(30, 60, 220, 250, [""], dash=True)
    s.text(140, 82, "Agent", bold=True)
    s.box(50, 100, 180, 70, ["Action strategy", "explores or exploits"], LEARNT)
    s.box(50, 210, 180, 70, ["Q-learning unit", "table and update rule"], LEARNT)
    s.arrow((140, 210), (140, 170))
    s.text(150, 194, "Q values", "start", colour=MUTED)
    s.box(340, 60, 160, 250, ["State", "aggregation", "unit"], WRAP)
    s.box(590, 60, 160, 250, ["Environment", "the game"])
    for y, left, right, outwards in ((105, "2", "1", False), (150, "3", "4", True), (245, "6", "5", False)):
        s.arrow(*((230, y), (340, y)) if outwards else ((340, y), (230, y)))
        s.arrow(*((500, y), (590, y)) if outwards else ((590, y), (500, y)))
        s.text(285, y - 7, left)
        s.text(545, y - 7, right)
    for n, line in enumerate(("1: state of the game; 2: its aggregate; 3: the aggregate action chosen",
                              "4: the actions a1 a2 ... an that realise it; 5: state and reward after them",
                              "6: their aggregates, from which Q is updated")):
        s.text(30, 340 + 20 * n, line, "start")
    s.text(30, 404, "The text names steps 3 and 4; the other numbers are ours.", "start", colour=MUTED)
    return s.svg()


def draw():
    """All schemes, by name."""
    return {"fig41": hierarchy(), "fig51": unit(), "fig52": aggregated_hierarchy()}
