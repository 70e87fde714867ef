# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks with node by node meshes of strips and plates, moved at random, turned and stretched."""
import math
import random


class Grid:
    """QUAMC8 on a grid of `nx` by `ny` over x0..x1, y0..y1; mid nodes half way between their corners."""

    def __init__(self, box, nx, ny):
        self.x0, self.x1, self.y0, self.y1 = box
        self.nx, self.ny = nx, ny
        self.corner = {(i, j): [self.x0 + (self.x1 - self.x0) * i / nx, self.y0 + (self.y1 - self.y0) * j / ny]
                       for i in range(nx + 1) for j in range(ny + 1)}

    def shake(self, d, seed, fold=False):
        """Moves inner corners by up to `d` of their elements' sides, anew where an element would fold over."""
        dice = random.Random(seed)
        hx, hy = (self.x1 - self.x0) / self.nx, (self.y1 - self.y0) / self.ny
        for (i, j), x in self.corner.items():
            home = tuple(x)
            while 0 < i < self.nx and 0 < j < self.ny:
                x[:] = (home[0] + d * hx * dice.uniform(-1.0, 1.0), home[1] + d * hy * dice.uniform(-1.0, 1.0))
                if fold or all(self.convex(k, m) for k in (i - 1, i) for m in (j - 1, j)):
                    break
        return self

    def convex(self, i, j):
        """Whether all corners of an element turn the same way, by a tenth of its area at least."""
        p = [self.corner[q] for q in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
        least = 0.1 * (self.x1 - self.x0) * (self.y1 - self.y0) / self.nx / self.ny
        return all((p[k][0] - p[k - 1][0]) * (p[(k + 1) % 4][1] - p[k][1])
                   - (p[k][1] - p[k - 1][1]) * (p[(k + 1) % 4][0] - p[k][0]) > least for k in range(4))

    def cards(self, angle=0.0):
        """$COOR, $ELEMENT and the node sets of its four sides and two lower corners."""
        c, s = math.cos(angle), math.sin(angle)
        label, lines, sides = {}, [], {"WEST": [], "EAST": [], "SOUTH": [], "NORTH": []}

        def node(key, x):
            if key not in label:
                label[key] = len(label) + 1
                lines.append(f"  {label[key]}  {c * x[0] - s * x[1]:.17g}  {s * x[0] + c * x[1]:.17g}")
                i, j = key[0] / 2, key[1] / 2
                for side, on in (("WEST", i == 0), ("EAST", i == self.nx), ("SOUTH", j == 0), ("NORTH", j == self.ny)):
                    if on:
                        sides[side].append(label[key])
            return label[key]

        def at(i, j):
            return node((2 * i, 2 * j), self.corner[i, j])

        def mid(i, j, k, m):
            a, b = self.corner[i, j], self.corner[k, m]
            return node((i + k, j + m), [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])])

        elements = []
        for j in range(self.ny):
            for i in range(self.nx):
                p = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                nodes = [at(*q) for q in p] + [mid(*p[k], *p[(k + 1) % 4]) for k in range(4)]
                elements.append(f"  {len(elements) + 1}  " + " ".join(map(str, nodes)))
        text = "$COOR DIM=2\n" + "\n".join(lines) + "\n$ELEMENT TYPE=QUAMC8 ESET=BODY\n" + "\n".join(elements)
        for name, members in sides.items():
            text += f"\n$NSET NAME={name}\n" + "\n".join(f"  {n}" for n in members)
            text += f"\n$FSET NAME={name}F\n  {name}"
        low, high = label[0, 0], label[2 * self.nx, 0]
        return text + f"\n$NSET NAME=PIN\n  {low}\n$NSET NAME=SLIDE\n  {high}"


def deck(grid, points, angle=0.0, tipnet=""):
    """A body under tension along its own y axis, with a free crack through `points` of its own axes."""
    c, s = math.cos(angle), math.sin(angle)
    crack = "\n".join(f"  {c * x - s * y:.17g}  {s * x + c * y:.17g}" for x, y in points)
    # the corner that only keeps the body from turning is held across the line between the two
    return f"""$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Body of any mesh'
{grid.cards(angle)}
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=XY
  PIN
$FREEDOM CLASS=SUPPRESSED DOF={'Y' if abs(c) > 0.5 else 'X'}
  SLIDE
$LOAD CASE=T TYPE=TRACTION
  NORTHF  {-s:.17g}  {c:.17g}
  SOUTHF  {s:.17g}  {-c:.17g}
$CRACK NAME=C
{crack}
{tipnet}
$STEP NAME=PULL
  LOAD T 1
$END
"""
