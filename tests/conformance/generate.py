#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the conformance vectors: lines, fills and tilings with the cells that the definitions give.

The definitions are written down here a second time, cell by cell and in exact numbers (Python's integers and
fractions), with no regard for speed and none of the library's code. docs/raster/conformance.md describes the files.

usage: generate.py          writes the files beside this script
       generate.py --check  compares them instead; ends with 1 when one differs
"""
import os
import random
import sys
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
GRAMMAR = """\
# Words are separated by blanks and line ends; # starts a comment to the end of its line. The first two words are
# `irg-conformance 1`. Then come cases:
#   case NAME KIND       KIND is line, fill or tiling
#   ...                  the input: a key and its values, as below
#   expect N             the number of items that follow, several a line
#   end
# A window x0 y0 x1 y1 holds the cells with x0 <= x < x1 and y0 <= y < y1; cells outside of it are not drawn.
"""
LINE_KEYS = """\
# line: from X Y, to X Y, ties start-side|symmetric, ends closed|half-open, window. Items: X Y, in drawing order.
# With n = max(|dx|, |dy|) and m = min(|dx|, |dy|), step i = 0..n goes i along the longer axis (y when they are equal)
# and to the integer nearest to i*m/n along the shorter one. Of two nearest ones start-side takes the one nearer to the
# start; symmetric takes the one nearer to the end with the lesser coordinate on the longer axis. half-open leaves out
# step n, so that a line of length 0 draws nothing.
"""
FILL_KEYS = """\
# fill: ring K X Y ... (K vertices, repeated for more rings), rule, window. Items: Y X_FIRST X_LAST, ordered, as long as
# possible: the cells X_FIRST to X_LAST - 1 of row Y. Coordinates are in 1/256 of a cell.
# Rules even-odd and non-zero sample the centre (x + 1/2, y + 1/2) of each cell, y down: a cell is drawn when the
# winding number of its centre is odd, or not 0. A centre on an edge counts as moved right by an infinitesimal, and down
# by an infinitesimally smaller one: the top-left rule.
# Rules course, closed, rounded and half-open sample the points (x, y) and are for convex rings. The closed polygon
# meets row y in the points L to D. course: ceil(L) to floor(D) if L < D; closed: also if L = D; rounded: floor(L + 1/2)
# to floor(D + 1/2) if L < D; half-open: L <= x < D, and not in the topmost row (that of the greatest y).
"""
TILING_KEYS = """\
# tiling: ring K X Y ... per tile, rule non-zero or half-open, window. Items, ordered: Y X_FIRST X_LAST TILE, the cells
# of row Y that tile TILE, counted from 0, draws when it is filled as above. No two tiles draw the same cell, and the
# region that is tiled has no cell that none draws.
"""


# ---- the definitions

def line_cells(a, b, ties, ends, window):
    """The cells of a line in the window, in order; each cell of the window is judged by itself."""
    (ax, ay), (bx, by) = a, b
    dx, dy = bx - ax, by - ay
    sx, sy = (1 if dx >= 0 else -1), (1 if dy >= 0 else -1)
    steep = abs(dy) >= abs(dx)
    n, m = max(abs(dx), abs(dy)), min(abs(dx), abs(dy))
    lesser_end_is_start = (sy if steep else sx) > 0
    to_start = ties == "start-side" or lesser_end_is_start
    found = []
    for y in range(window[1], window[3]):
        for x in range(window[0], window[2]):
            i, k = (sy * (y - ay), sx * (x - ax)) if steep else (sx * (x - ax), sy * (y - ay))
            if not 0 <= i <= n or not 0 <= k <= m or (i == n and ends == "half-open"):
                continue
            off = Fraction(0) if n == 0 else k - Fraction(i * m, n)  # in the direction from start to end
            if abs(off) < Fraction(1, 2) or off == (Fraction(-1, 2) if to_start else Fraction(1, 2)):
                found.append((i, x, y))
    return [(x, y) for _, x, y in sorted(found)]


def winding_number(rings, x, y):
    """How often the rings run round (x, y), moved right a little and down much less."""
    winding = 0
    for ring in rings:
        for k, (ax, ay) in enumerate(ring):
            bx, by = ring[(k + 1) % len(ring)]
            direction = 1
            if ay > by:
                ax, ay, bx, by, direction = bx, by, ax, ay, -1
            # the level ray to the left meets the edge: at (y - ay) / (by - ay) of its way
            if ay <= y < by and ax * (by - ay) + (y - ay) * (bx - ax) <= x * (by - ay):
                winding += direction
    return winding


def crossed_rows(rings, window):
    heights = [y for ring in rings for _, y in ring]
    return range(max(window[1], min(heights) // 256 - 1), min(window[3], max(heights) // 256 + 2)) if heights else []


def sampled_cells(rings, rule, window):
    cells = set()
    for y in crossed_rows(rings, window):
        for x in range(window[0], window[2]):
            winding = winding_number(rings, 256 * x + 128, 256 * y + 128)
            if winding % 2 != 0 if rule == "even-odd" else winding != 0:
                cells.add((x, y))
    return cells


def row_slice(ring, y):
    """The least and the greatest x of the ring at height y, in cells; None where it has none."""
    xs = []
    for k, (ax, ay) in enumerate(ring):
        bx, by = ring[(k + 1) % len(ring)]
        if ay == 256 * y:
            xs.append(Fraction(ax, 256))
        elif min(ay, by) < 256 * y < max(ay, by):
            xs.append(Fraction(ax, 256) + Fraction((256 * y - ay) * (bx - ax), 256 * (by - ay)))
    return (min(xs), max(xs)) if xs else None


def convex_cells(ring, rule, window):
    cells = set()
    top = max((y for _, y in ring), default=0)
    for y in crossed_rows([ring], window):
        slice_ = row_slice(ring, y)
        if slice_ is None:
            continue
        low, high = slice_
        for x in range(window[0], window[2]):
            if rule == "course":
                inside = low < high and low <= x <= high
            elif rule == "closed":
                inside = low <= x <= high
            elif rule == "rounded":
                inside = low < high and (low + Fraction(1, 2)) // 1 <= x <= (high + Fraction(1, 2)) // 1
            else:
                inside = low <= x < high and 256 * y != top
            if inside:
                cells.add((x, y))
    return cells


def fill_cells(rings, rule, window):
    if rule in ("even-odd", "non-zero"):
        return sampled_cells(rings, rule, window)
    assert len(rings) == 1
    return convex_cells(rings[0], rule, window)


def runs(cells):
    out = []
    for y, x in sorted((y, x) for x, y in cells):
        if out and out[-1][0] == y and out[-1][2] == x:
            out[-1][2] = x + 1
        else:
            out.append([y, x, x + 1])
    return out


# ---- the text

WIDTH = 120


class Vectors:
    def __init__(self, name, about, *keys):
        self.name = name
        self.cases = 0
        self.text = ["# irg conformance vectors: " + about + "\n", "# SPDX-License-Identifier: MIT\n",
                     "# Written by generate.py from the definitions; see docs/raster/conformance.md.\n#\n", GRAMMAR, *keys,
                     "irg-conformance 1\n"]
        self.names = set()

    def put(self, *words):
        self.text.append(" ".join(str(w) for w in words) + "\n")

    def flow(self, between, groups):
        """Groups of words, as many to a line as fit."""
        lines = []
        for group in (" ".join(str(w) for w in words) for words in groups):
            if lines and len(lines[-1]) + len(between) + len(group) <= WIDTH:
                lines[-1] += between + group
            else:
                lines.append(group)
        self.text += [line + "\n" for line in lines]

    def begin(self, name, kind):
        assert name not in self.names, name
        self.names.add(name)
        self.cases += 1
        self.put("\ncase", name, kind)

    def expect(self, items):
        self.put("expect", len(items))
        self.flow("  ", items)
        self.put("end")

    def rings(self, rings, rule, window):
        self.flow("  ", [("ring", len(ring), *(c for p in ring for c in p)) for ring in rings])
        self.put("rule", rule, "window", *window)

    def line(self, name, a, b, window, ties="start-side", ends="closed", known=None):
        """known: minor coordinates of the cells, as published for this line."""
        self.begin(name, "line")
        self.flow(" ", [("from", *a), ("to", *b), ("ties", ties), ("ends", ends), ("window", *window)])
        cells = line_cells(a, b, ties, ends, window)
        assert known is None or [c[abs(b[1] - a[1]) < abs(b[0] - a[0])] for c in cells] == known, (name, cells)
        self.expect(cells)

    def fill(self, name, rings, rule, window, count=None):
        self.begin(name, "fill")
        self.rings(rings, rule, window)
        cells = fill_cells(rings, rule, window)
        assert count is None or len(cells) == count, (name, len(cells))
        self.expect(runs(cells))

    def tiling(self, name, tiles, rule, window, whole=None, parts_of=None):
        """whole: a window all of whose cells the tiles have; parts_of: the polygon that they are cut from."""
        self.begin(name, "tiling")
        self.rings(tiles, rule, window)
        items, seen = [], set()
        for tile, ring in enumerate(tiles):
            cells = fill_cells([ring], rule, window)
            assert not cells & seen, (name, tile)
            seen |= cells
            items += [run + [tile] for run in runs(cells)]
        if whole is not None:
            assert seen >= {(x, y) for x in range(whole[0], whole[2]) for y in range(whole[1], whole[3])}, name
        if parts_of is not None:
            assert seen == fill_cells([parts_of], rule, window), name
        self.expect(sorted(items))


def pixels(points):
    """Vertices in cells as 1/256."""
    return [(int(x * 256), int(y * 256)) for x, y in points]


def moved(ring, dx, dy):
    return [(x + dx, y + dy) for x, y in ring]


# ---- lines

LEAST, MOST = -2**31, 2**31 - 1


def every_direction(v, **options):
    for y in range(-4, 5):
        for x in range(-4, 5):
            v.line(f"to-{x}-{y}", (0, 0), (x, y), (-5, -5, 6, 6), **options)


def lines_default():
    v = Vectors("lines_default", "lines with both ends, ties on the start's side", LINE_KEYS)
    v.line("course", (10, 10), (200, 100), (0, 0, 210, 110))
    for x, y in ((5, 2), (2, 5), (-2, 5), (-5, 2), (-5, -2), (-2, -5), (2, -5), (5, -2)):
        minor = y if abs(x) > abs(y) else x
        v.line(f"octant-{x}-{y}", (0, 0), (x, y), (-8, -8, 9, 9), known=[k * minor // 2 for k in (0, 0, 1, 1, 2, 2)])
    v.line("tie-forth", (0, 0), (4, 2), (-8, -8, 9, 9), known=[0, 0, 1, 1, 2])
    v.line("tie-back", (4, 2), (0, 0), (-8, -8, 9, 9), known=[2, 2, 1, 1, 0])
    v.line("table-3-forth", (0, 0), (8, 4), (0, 0, 9, 9), known=[0, 0, 1, 1, 2, 2, 3, 3, 4])
    v.line("table-3-back", (8, 4), (0, 0), (0, 0, 9, 9), known=[4, 4, 3, 3, 2, 2, 1, 1, 0])
    every_direction(v)
    for name, at in (("inside", (3, 2)), ("outside", (6, 2)), ("on-the-last-column", (4, 2)), ("past-it", (5, 2))):
        v.line("point-" + name, at, at, (0, 0, 5, 4))
    return v


def lines_symmetric():
    v = Vectors("lines_symmetric", "lines that have the same cells in both directions", LINE_KEYS)
    for name, a, b, known in (("table-3", (0, 0), (8, 4), [0, 0, 1, 1, 2, 2, 3, 3, 4]),
                              ("left", (0, 0), (-8, 4), [0, 1, 1, 2, 2, 3, 3, 4, 4]),
                              ("down", (0, 4), (8, 0), [4, 4, 3, 3, 2, 2, 1, 1, 0]),
                              ("steep", (0, 0), (4, 8), [0, 0, 1, 1, 2, 2, 3, 3, 4]),
                              ("diagonal", (3, 1), (-2, 6), [3, 2, 1, 0, -1, -2])):
        v.line(name + "-forth", a, b, (-9, -9, 10, 10), ties="symmetric", known=known)
        v.line(name + "-back", b, a, (-9, -9, 10, 10), ties="symmetric", known=known[::-1])
    every_direction(v, ties="symmetric")
    return v


def lines_half_open():
    v = Vectors("lines_half_open", "lines without their last cell", LINE_KEYS)
    every_direction(v, ends="half-open")
    rim = [(0, 0), (7, 3), (9, 9), (2, 11), (-4, 5)]  # a polyline: each shared vertex once
    for k, a in enumerate(rim):
        v.line(f"polyline-{k}", a, rim[(k + 1) % len(rim)], (-6, -2, 12, 13), ends="half-open")
    for ends in ("closed", "half-open"):
        v.line("end-in-a-corner-" + ends, (-3, -3), (4, 4), (0, 0, 5, 5), ends=ends)
        v.line("end-outside-" + ends, (-3, -3), (5, 5), (0, 0, 5, 5), ends=ends)
        v.line("symmetric-" + ends, (8, 4), (0, 0), (-1, -1, 9, 6), ties="symmetric", ends=ends)
    return v


def random_lines(v, r, count, coordinate):
    for k in range(count):
        a, b = (coordinate(), coordinate()), (coordinate(), coordinate())
        n, m = max(abs(b[0] - a[0]), abs(b[1] - a[1])), min(abs(b[0] - a[0]), abs(b[1] - a[1]))
        i = r.randint(0, n)  # a step of the line, so that the window meets it
        x = a[0] + (b[0] - a[0]) * i // n if n else a[0]
        y = a[1] + (b[1] - a[1]) * i // n if n else a[1]
        x0, y0 = (max(LEAST, min(MOST - 24, c - r.randint(0, 12))) for c in (x, y))
        v.line(f"random-{k}", a, b, (x0, y0, x0 + r.randint(3, 20), y0 + r.randint(3, 20)),
               ties=r.choice(["start-side", "symmetric"]), ends=r.choice(["closed", "closed", "half-open"]))


def lines_clipped():
    v = Vectors("lines_clipped", "lines through small windows: clipping changes no cell", LINE_KEYS)
    v.line("misses-though-the-boxes-overlap", (-3, 2), (2, -3), (0, 0, 4, 4))
    v.line("one-corner-cell", (-3, 3), (3, -3), (0, 0, 4, 4))
    v.line("one-cell-window", (-7, -5), (9, 6), (0, 0, 1, 1))
    for name, window in (("no-width", (2, 0, 2, 4)), ("no-height", (0, 2, 4, 2)), ("inverted", (4, 4, 0, 0))):
        v.line("window-of-" + name, (0, 0), (3, 3), window)
    r = random.Random(11)
    random_lines(v, r, 60, lambda: r.randint(-60, 60))
    return v


def lines_extreme():
    v = Vectors("lines_extreme", "lines over the whole range of 32-bit coordinates", LINE_KEYS)
    view = (0, 0, 64, 64)
    v.line("whole-diagonal", (LEAST, LEAST), (MOST, MOST), view)
    v.line("whole-row", (LEAST, 5), (MOST, 5), view)
    v.line("whole-column", (5, MOST), (5, LEAST), view)
    v.line("far-left", (LEAST, 0), (63, 63), view)
    v.line("far-corner", (MOST, LEAST), (0, 0), view)
    v.line("anti-diagonal", (LEAST, MOST), (MOST, LEAST), (-32, -32, 32, 32))
    for k, (a, b) in enumerate((((262, 23), (-91618510, -54756195)), ((263, 214), (-80120779, 11846827)),
                                ((34, 204), (-46400, 47400)))):
        v.line(f"far-end-{k}", a, b, (a[0] - 40, a[1] - 30, a[0] + 10, a[1] + 30))
        v.line(f"far-end-{k}-back", b, a, (a[0] - 40, a[1] - 30, a[0] + 10, a[1] + 30))
    r = random.Random(12)

    def coordinate():
        bits = r.randint(8, 32)
        return r.randint(-2**(bits - 1), 2**(bits - 1) - 1)

    random_lines(v, r, 80, coordinate)
    return v


# ---- fills

COURSE = [(50, 200), (150, 350), (300, 150), (100, 50)]


def fills_course():
    v = Vectors("fills_course", "convex polygons on integer sample points", FILL_KEYS)
    for rule, count in (("course", 38874), ("closed", 38876), ("rounded", 39074), ("half-open", 38725)):
        v.fill("polygon-" + rule, [pixels(COURSE)], rule, (0, 0, 320, 360), count)
        v.fill("reversed-" + rule, [pixels(COURSE[::-1])], rule, (90, 40, 160, 80))
        square = pixels([(2, 1), (2, 5), (7, 5), (7, 1)])
        v.fill("square-" + rule, [square], rule, (0, 0, 10, 10), 20 if rule == "half-open" else 30)
        v.fill("clipped-square-" + rule, [square], rule, (3, -2, 6, 3))
        v.fill("point-" + rule, [pixels([(3, 4)])], rule, (0, 0, 9, 9))
        v.fill("segment-" + rule, [pixels([(0, 0), (2, 4)])], rule, (-1, -1, 9, 9))
        v.fill("level-segment-" + rule, [pixels([(0, 7), (5, 7), (2, 7)])], rule, (-1, -1, 9, 9))
        v.fill("no-cell-point-" + rule, [[(300, 300), (500, 310), (310, 500)]], rule, (0, 0, 4, 4))
        v.fill("quad-" + rule, [pixels([(44, 27), (7, 37), (7, 19), (38, 19)])], rule, (0, 10, 50, 45))
        r = random.Random(13)
        for k in range(12):
            points = [(r.randint(-2500, 2500), r.randint(-2500, 2500)) for _ in range(r.randint(3, 9))]
            v.fill(f"hull-{k}-{rule}", [hull(points)[::r.choice([1, -1])]], rule, (-11, -11, 12, 12))
    return v


def hull(points):
    points = sorted(set(points))
    out = []
    for side in (points, points[::-1]):
        base = len(out)
        for p in side:
            while len(out) >= base + 2 and cross(out[-2], out[-1], p) <= 0:
                out.pop()
            out.append(p)
        out.pop()
    return out


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def fills_triangles():
    v = Vectors("fills_triangles", "triangles by the top-left rule", FILL_KEYS)
    w = (-2, -2, 14, 14)
    rule = "non-zero"
    for name, ring in (("three-equal", [(700, 700)] * 3), ("two-equal", [(100, 100), (900, 800), (900, 800)]),
                       ("collinear", [(0, 0), (512, 512), (1024, 1024)]),
                       ("level", [(0, 128), (900, 128), (400, 128)]),
                       ("upright", [(128, 0), (128, 900), (128, 400)])):
        v.fill("no-area-" + name, [ring], rule, w, 0)
    base = [(0, 0), (1024, 0), (0, 1024)]  # the hypotenuse runs through centres
    for k in range(4):
        for turn, ring in (("clockwise", base), ("counter-clockwise", base[::-1])):
            rotated = ring
            for _ in range(k):
                rotated = [(1024 - y, x) for x, y in rotated]
            v.fill(f"through-centres-{k}-{turn}", [rotated], rule, w)
    for name, box in (("on-centres", (128, 128, 640, 640)), ("between", (0, 0, 512, 512)), ("one-unit-short", (129, 129, 641, 641)),
                      ("one-unit-wide", (127, 127, 639, 639))):
        x0, y0, x1, y1 = box
        corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        for start in range(4):
            for step in (1, -1):
                ring = [corners[(start + step * k) % 4] for k in range(4)]
                v.fill(f"square-{name}-{start}-{'clockwise' if step > 0 else 'counter-clockwise'}", [ring], rule, w, 4)
    far = 2**21 * 256
    v.fill("far-corner", [[(-far, -far), (far, -far), (-far, far)]], rule, (-8, -8, 8, 8), 120)
    v.fill("far-opposite-corner", [[(far, far), (far, -far), (-far, far)]], rule, (-8, -8, 8, 8), 136)
    far = 2**31 * 256
    v.fill("farther-corner", [[(-far, -far), (far, -far), (-far, far)]], rule, (-8, -8, 8, 8), 120)
    v.fill("farther-shallow", [[(-far, 3), (far, 900), (far, -77 * 256)]], rule, (-8, -8, 8, 8))
    v.fill("farther-sliver", [[(-far, -far), (far, far), (far, far - 256)]], rule, (-8, -8, 8, 8))
    v.fill("sliver", [[(0, 0), (16384 * 256, 64 * 256), (0, 1)]], rule, (0, 0, 16384, 64))
    r = random.Random(14)
    for k in range(60):
        a, b, c = ((r.randint(-300, 3300), r.randint(-300, 3300)) for _ in range(3))
        if k % 3 == 0:  # a sliver
            t = r.randint(0, 256)
            c = (a[0] + (b[0] - a[0]) * t // 256 + r.randint(-3, 3), a[1] + (b[1] - a[1]) * t // 256 + r.randint(-3, 3))
        if k % 3 == 1:  # corners on centres
            a, b, c = ((x // 256 * 256 + 128, y // 256 * 256 + 128) for x, y in (a, b, c))
        v.fill(f"random-{k}", [[a, b, c]], rule, w)
    return v


def pentagram(scale):
    return [(int(x * scale), int(y * scale)) for x, y in ((0, -1000), (588, 809), (-951, -309), (951, -309), (-588, 809))]


def fills_polygons():
    v = Vectors("fills_polygons", "any polygons by the top-left rule, even-odd and non-zero", FILL_KEYS)
    w = (-12, -12, 13, 13)
    shapes = {
        "empty": [],
        "one-vertex": [[(128, 128)]],
        "two-vertices": [[(0, 0), (2000, 1500)]],
        "square": [pixels([(-5, -5), (6, -5), (6, 7), (-5, 7)])],
        "repeated-vertices": [pixels([(-5, -5), (-5, -5), (6, -5), (6, 7), (6, 7), (6, 7), (-5, 7), (-5, -5)])],
        "spike": [pixels([(-5, -5), (6, -5), (6, 1), (11, 1), (6, 1), (6, 7), (-5, 7)])],
        "touching-at-a-vertex": [pixels([(-6, -6), (0, 0), (6, -6), (6, 6), (0, 0), (-6, 6)])],
        "bow-tie": [pixels([(-8, -8), (8, 8), (8, -8), (-8, 8)])],
        "bow-tie-off-centre": [pixels([(-8, -8), (8, 7.5), (8.25, -8), (-8, 8.125)])],
        "pentagram": [pentagram(2.8)],
        "pentagram-on-centres": [moved(pentagram(2.56), 128, 128)],
        "hole": [pixels([(-9, -9), (9, -9), (9, 9), (-9, 9)]), pixels([(-4, -4), (-4, 4), (4, 4), (4, -4)])],
        "hole-same-way": [pixels([(-9, -9), (9, -9), (9, 9), (-9, 9)]), pixels([(-4, -4), (4, -4), (4, 4), (-4, 4)])],
        "hole-sharing-an-edge": [pixels([(-9, -9), (9, -9), (9, 9), (-9, 9)]), pixels([(-9, -4), (-9, 4), (4, 4), (4, -4)])],
        "hole-sharing-a-vertex": [pixels([(-9, -9), (9, -9), (9, 9), (-9, 9)]), pixels([(-9, -9), (-2, 4), (4, -2)])],
        "hole-on-centres": [moved(pixels([(-9, -9), (9, -9), (9, 9), (-9, 9)]), 128, 128),
                            moved(pixels([(-4, -4), (-4, 4), (4, 4), (4, -4)]), 128, 128)],
        "twice-round": [pixels([(-7, -7), (7, -7), (7, 7), (-7, 7)] * 2)],
        "there-and-back": [pixels([(-7, -7), (7, -7), (7, 7), (-7, 7), (7, 7), (7, -7)])],
        "island-in-a-hole": [pixels([(-10, -10), (10, -10), (10, 10), (-10, 10)]), pixels([(-7, -7), (-7, 7), (7, 7), (7, -7)]),
                             pixels([(-3, -3), (3, -3), (3, 3), (-3, 3)])],
        "overlapping": [pixels([(-9, -9), (3, -9), (3, 3), (-9, 3)]), pixels([(-3, -3), (9, -3), (9, 9), (-3, 9)])],
        "comb": [pixels([(-10, 8), (-10, -8)] + [p for k in range(-4, 5) for p in ((2 * k, 5), (2 * k + 1, -8))] + [(10, 8)])],
        "collinear-runs": [pixels([(-10, -10), (-5, -10), (0, -10), (10, -10), (10, 0), (10, 10), (5, 5), (0, 0), (-5, 5), (-10, 10),
                                   (-10, 5), (-10, 0)])],
        "star-with-thin-ears": [[(0, -2600), (1, -300), (2600, -1), (300, 1), (1, 2600), (-1, 300), (-2600, 1), (-300, -1)]],
        "staircase-on-centres": [moved(pixels([(-8, -8), (0, -8), (0, -4), (4, -4), (4, 0), (8, 0), (8, 8), (-8, 8)]), 128, 128)],
        "spiral": [pixels([(-10, -10), (10, -10), (10, 10), (-8, 10), (-8, -6), (6, -6), (6, 6), (-4, 6), (-4, -2), (2, -2), (2, 2),
                           (0, 2), (0, 0), (-2, 0), (-2, 4), (4, 4), (4, -4), (-6, -4), (-6, 8), (8, 8), (8, -8), (-10, -8)])],
        "quad": [moved(pixels([(44, 27), (7, 37), (7, 19), (38, 19)]), -25 * 256, -27 * 256)],
        "far": [[(-2**29, -2**29), (2**29, -2**29 + 77), (2**29 - 5, 2**29), (3, 5), (-2**29, 2**29)]],
        "farther": [[(-2**39, -2**39), (2**39, -2**39 + 77), (2**39 - 5, 2**39), (3, 5), (-2**39, 2**39)]],
        "farther-bow-tie": [[(-2**39, -2**39), (2**39, 2**39), (2**39, -2**39), (-2**39, 2**39)]],
    }
    for name, rings in shapes.items():
        for rule in ("even-odd", "non-zero"):
            v.fill(f"{name}-{rule}", rings, rule, w)
    v.fill("reversed-pentagram", [pentagram(2.8)[::-1]], "non-zero", w)
    v.fill("turned-pentagram", [pentagram(2.8)[2:] + pentagram(2.8)[:2]], "even-odd", w)
    v.fill("moved-pentagram", [moved(pentagram(2.8), 7 * 256, -3 * 256)], "non-zero", (-5, -15, 20, 10))
    v.fill("clipped-pentagram", [pentagram(2.8)], "non-zero", (-3, -5, 4, 1))
    v.fill("clipped-away", [pentagram(2.8)], "non-zero", (40, 40, 50, 50), 0)
    v.fill("through-no-window", [pentagram(2.8)], "non-zero", (4, 4, -4, -4), 0)
    r = random.Random(15)
    for k in range(40):
        grid = r.choice([1, 128, 256])
        rings = [[(r.randint(-3000, 3000) // grid * grid + 128 * (grid > 1), r.randint(-3000, 3000) // grid * grid + 128 * (grid > 1))
                  for _ in range(r.randint(3, 12))] for _ in range(r.choice([1, 1, 2, 3]))]
        v.fill(f"random-{k}", rings, r.choice(["even-odd", "non-zero"]), w)
    return v


# ---- tilings

def jittered_grid(r, unit):
    """Triangles that tile 12 x 12 cells: quads with moved corners, each cut along a diagonal that lies inside of it."""
    n, step = 6, 512
    at = {}
    for j in range(n + 1):
        for i in range(n + 1):
            dx, dy = (0 if i in (0, n) else r.randint(-200, 200)), (0 if j in (0, n) else r.randint(-200, 200))
            at[i, j] = (i * step + dx // unit * unit, j * step + dy // unit * unit)
    tiles = []
    for j in range(n):
        for i in range(n):
            a, b, c, d = at[i, j], at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]
            cuts = [pair for pair in (([a, b, c], [a, c, d]), ([a, b, d], [b, c, d])) if all(cross(*t) > 0 for t in pair)]
            tiles += r.choice(cuts)
    r.shuffle(tiles)
    return [t[::r.choice([1, -1])] for t in tiles]


def tilings():
    v = Vectors("tilings", "polygons side by side: every cell exactly once", FILL_KEYS, TILING_KEYS)
    rule = "non-zero"
    r = random.Random(16)
    rim = [(900, 0), (800, 450), (450, 800), (0, 900), (-450, 800), (-800, 450), (-900, 0), (-800, -450), (-450, -800), (0, -900),
           (450, -800), (800, -450)]
    for spokes in range(3, 13):
        for name, hub in (("centre", (1152, 1152)), ("corner", (1280, 1280)), ("edge", (1152, 1280)), ("any", (1200, 1333))):
            ends = [(hub[0] + rim[k * 12 // spokes][0] + r.randint(-20, 20), hub[1] + rim[k * 12 // spokes][1] + r.randint(-20, 20))
                    for k in range(spokes)]
            fan = [[hub, ends[k], ends[(k + 1) % spokes]][::r.choice([1, -1])] for k in range(spokes)]
            x, y = hub[0] // 256, hub[1] // 256
            v.tiling(f"fan-{spokes}-{name}", fan, rule, (0, 0, 10, 10), whole=(x, y, x + 1, y + 1))
    for k in range(30):  # a quad by either diagonal
        step = r.choice([1, 64, 128])
        while True:
            quad = hull([(r.randint(0, 2560) // step * step, r.randint(0, 2560) // step * step) for _ in range(4)])
            if len(quad) == 4:
                break
        a, b, c, d = quad
        v.tiling(f"quad-{k}-one-diagonal", [[a, b, c], [a, c, d]], rule, (-1, -1, 11, 11), parts_of=quad)
        v.tiling(f"quad-{k}-other-diagonal", [[a, b, d], [b, d, c]], rule, (-1, -1, 11, 11), parts_of=quad)
    for k in range(16):  # a jittered grid of triangles over 12 x 12 cells
        tiles = jittered_grid(r, r.choice([1, 64, 128]))
        v.tiling(f"grid-{k}", tiles, rule if k < 10 else "half-open", (0, 0, 12, 12), whole=(0, 0, 12, 12))
    return v


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit(__doc__)
    differing = 0
    for make in (lines_default, lines_symmetric, lines_half_open, lines_clipped, lines_extreme, fills_course, fills_triangles,
                 fills_polygons, tilings):
        v = make()
        path = os.path.join(HERE, v.name + ".txt")
        text = "".join(v.text)
        if check:
            try:
                with open(path, encoding="ascii") as f:
                    same = f.read() == text
            except OSError:
                same = False
            differing += not same
            print(f"{v.name}.txt: {v.cases} cases, {'as generated' if same else 'DIFFERS'}")
        else:
            with open(path, "w", encoding="ascii") as f:
                f.write(text)
            print(f"{v.name}.txt: {v.cases} cases, {len(text)} bytes")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
