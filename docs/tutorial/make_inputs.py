"""make_inputs.py [DIR]: the maps and lists of docs/tutorial.md, made up. They are the same, byte for byte, wherever they are made.

likelihood.pgm  a field of 120 m x 80 m, a pixel a metre: bright where mines are likely
school.png      a school's ground floor after an earthquake, a pixel a decimetre, as an architect's drawing: ink on white
warehouse.pgm, warehouse.yaml  a warehouse as a mapping robot saves it, a pixel a decimetre
"""

import math
import pathlib
import struct
import sys
import zlib

WHITE, INK, UNKNOWN, FREE = 255, 0, 205, 254


class Sheet:
    """Grey pixels, rows from the top; lengths in metres from the lower left corner."""

    def __init__(self, width, height, pixel, grey):
        self.width, self.height, self.pixel = round(width / pixel), round(height / pixel), pixel
        self.rows = [bytearray([grey]) * self.width for _ in range(self.height)]

    def fill(self, x, y, width, height, grey=INK):
        left, right = round(x / self.pixel), round((x + width) / self.pixel)
        top, bottom = self.height - round((y + height) / self.pixel), self.height - round(y / self.pixel)
        for row in self.rows[max(top, 0) : bottom]:
            row[left:right] = bytes([grey]) * (right - left)

    def pgm(self):
        return b"P5\n%d %d\n255\n" % (self.width, self.height) + b"".join(self.rows)

    def png(self):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 0, 0, 0, 0)
        pixels = zlib.compress(b"".join(b"\0" + bytes(row) for row in self.rows), 9)
        return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


def minefield():
    """Two rows that were laid along an old front, a track that was mined, and a patch where animals were lost."""
    sheet = Sheet(120, 80, 1, 0)
    rows = [((10, 62), (105, 70)), ((20, 48), (112, 57))]
    for row in range(sheet.height):
        for column in range(sheet.width):
            x, y = column + 0.5, sheet.height - row - 0.5
            near = max(math.exp(-((distance(x, y, *ends) / 1.6) ** 2)) for ends in rows)
            track = math.exp(-((distance(x, y, (60, 4), (74, 44)) / 1.4) ** 2)) * 0.6
            patch = math.exp(-(math.hypot(x - 27, y - 19) / 5) ** 2)
            # What was found already thins the rows out towards the west.
            level = max(near * (0.35 + 0.65 * x / 120), track, 0.8 * patch)
            sheet.rows[row][column] = round(255 * level)
    return sheet.pgm()


def distance(x, y, first, last):
    """Of a point from a line between two."""
    across, up = last[0] - first[0], last[1] - first[1]
    along = ((x - first[0]) * across + (y - first[1]) * up) / (across * across + up * up)
    along = min(max(along, 0), 1)
    return math.hypot(x - first[0] - along * across, y - first[1] - along * up)


def school():
    """40 m x 24 m: a corridor from west to east, four classrooms above, a hall and three rooms below, rubble in places."""
    sheet = Sheet(40, 24, 0.1, WHITE)
    for wall in [(0, 0, 40, 0.3), (0, 23.7, 40, 0.3), (0, 0, 0.3, 24), (39.7, 0, 0.3, 24)]:
        sheet.fill(*wall)
    for wall in [(0, 13.5, 40, 0.2), (0, 10.3, 40, 0.2)]:  # the corridor's
        sheet.fill(*wall)
    for x in (10, 20, 30):
        sheet.fill(x, 13.5, 0.2, 10.5)
    for x in (16, 24, 32):
        sheet.fill(x, 0, 0.2, 10.4)
    for x in (4, 14, 24, 34):
        sheet.fill(x, 13.5, 1.2, 0.2, WHITE)
    for x in (6, 19, 27, 35):
        sheet.fill(x, 10.3, 1.2, 0.2, WHITE)
    sheet.fill(0, 11, 0.3, 1.8, WHITE)  # the entrance
    sheet.fill(10, 18, 0.2, 1.4, WHITE)  # a wall that fell
    for rubble in [(2, 19, 3, 2.5), (21, 11, 1.4, 1.5), (33, 20, 4, 2), (26, 2, 2.5, 3), (9, 4, 2, 2.2), (17, 15, 2, 3)]:
        sheet.fill(*rubble)
    return sheet.png()


def warehouse():
    """30 m x 20 m: six racks, an office, a loading bay; around it nothing known."""
    sheet = Sheet(32, 22, 0.1, UNKNOWN)
    sheet.fill(1, 1, 30, 20, INK)
    sheet.fill(1.2, 1.2, 29.6, 19.6, FREE)
    for x in range(6, 24, 3):
        sheet.fill(x, 5, 1.2, 11)
    sheet.fill(25, 14, 6, 0.2)  # the office
    sheet.fill(25, 14, 0.2, 7)
    sheet.fill(25, 16.5, 0.2, 1.2, FREE)
    for pallet in [(27, 4, 1.2, 0.8), (28.5, 8, 1.2, 0.8), (2.5, 18, 0.8, 1.2)]:
        sheet.fill(*pallet)
    return sheet.pgm()


MAP = """image: warehouse.pgm
resolution: 0.1
origin: [-1.0, -1.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    (folder / "likelihood.pgm").write_bytes(minefield())
    (folder / "school.png").write_bytes(school())
    (folder / "warehouse.pgm").write_bytes(warehouse())
    (folder / "warehouse.yaml").write_text(MAP, encoding="ascii")


main()
