"""The simplest reading of section 5.2.2, to compare with: scan the cells in order, grow a region from each one not taken
yet, breadth first, as long as the limits hold. Shares nothing with Quarter's own."""

from collections import deque


def free_cells(drawing):
    rows = [line for line in drawing.splitlines() if line and not line.startswith(";")]
    return {(r, c) for r, row in enumerate(rows) for c, mark in enumerate(row) if mark != "#"}


def neighbours(cell, free):
    row, column = cell
    return [n for n in ((row - 1, column), (row, column + 1), (row + 1, column), (row, column - 1)) if n in free]


def distances(source, free):
    far = {source: 0}
    queue = deque([source])
    while queue:
        cell = queue.popleft()
        for n in neighbours(cell, free):
            if n not in far:
                far[n] = far[cell] + 1
                queue.append(n)
    return far


def grow(seed, free, taken, far, size, diameter):
    region, queue = [seed], deque([seed])
    taken.add(seed)
    while queue and len(region) < size:
        for n in neighbours(queue.popleft(), free):
            if len(region) < size and n not in taken and all(far[n][m] <= diameter for m in region):
                taken.add(n)
                region.append(n)
                queue.append(n)
    return region


def divide_plainly(drawing, size, diameter):
    """Number of regions, and mean distance of a cell from its region's geometric median."""
    free = free_cells(drawing)
    far = {cell: distances(cell, free) for cell in free}
    taken, regions = set(), []
    for cell in sorted(free):
        if cell not in taken:
            regions.append(grow(cell, free, taken, far, size, diameter))
    summed = sum(min(sum(far[m][n] for n in region) for m in region) for region in regions)
    return len(regions), summed / len(free)
