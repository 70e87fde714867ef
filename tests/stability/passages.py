#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""K of a front that has gone through a surface is that of a model that begins with this front: nothing of what the
crack was before stays behind. A corner crack in a plate, and with SPRICKA_FULL one at a bore.

    tests/stability/passages.py PROGRAM [--full]
"""
import math
import os
import re
import sys

from program import Run, numbers
from random_growth import Case

ALLOWED = 0.01  # of the mean along the front
SCATTER = 0.02  # of single points: two meshes
BESIDE = 0.06  # of the front's length: nearer to a surface K is a number of the mesh


def numbered(number, place, **more):
    """A case of the random ones with what it needs for a passage early on."""
    case = Case(number)
    case.place = place
    for name, value in more.items():
        setattr(case, name, value)
    return case


CASES = {
    "plate": numbered(0, "corner", shape="FREE", t=2.0, W=8.0, H=8.0, x=-8.0, y=0.0, z=0.0, a=1.5, c=1.5, m=3, bend=0,
                      type="TET10"),
    "bore": numbered(3, "bore corner", shape="FREE", t=2.0, W=8.0, H=8.0, R=1.6, x=1.6, y=0.0, a=1.5, c=1.5, m=3,
                     bend=0),
}


def drawn(text, points, x, y):
    """The deck with the crack drawn by the points of a front, solved once."""
    lines = "\n".join(f"  {p[0]:.12g}  {p[1]:.12g}  {p[2]:.12g}" for p in points)
    text = re.sub(r"^\$CRACK.*$", f"$CRACK NAME=C1 NET=PLATE X0={x} Y0={y} Z0=0\n{lines}", text, flags=re.M)
    return re.sub(r"^\$GROW.*\n", "", text, flags=re.M)


def smooth_K(rows):
    """(x, y, z, K1) of the last increment at the largest load."""
    last = max(int(row["increment"]) for row in rows)
    return [tuple(float(row[name]) for name in ("x", "y", "z", "K1_smooth"))
            for row in rows if int(row["increment"]) == last and row["step"] == "FULL"]


def compare(program, case):
    """Differences of K inside the body over its mean: of the mean along the front, and the largest."""
    grown = case.text().replace("TOL=0.1", f"TOL=0.1 AMAX={2.2 * case.a:.4g}")
    run = Run(program, grown)
    if run.code != 0:
        raise ValueError(f"exit {run.code}: {run.messages}")
    if "goes through a surface" not in run.listing():
        raise ValueError("no front has gone through a surface")
    front = smooth_K(numbers(run.out / "k.csv"))
    again = Run(program, drawn(case.text(), [p[:3] for p in front], case.x, case.y))
    if again.code != 0:
        raise ValueError(f"the front drawn anew, exit {again.code}: {again.messages}")
    other = smooth_K(numbers(again.out / "k.csv"))
    mean = sum(p[3] for p in front) / len(front)
    most = total = 0.0
    compared = 0
    length = sum(math.dist(p[:3], q[:3]) for p, q in zip(front, front[1:]))
    for point in front:
        # Linear between the two points of the other front that are nearest.
        near = sorted(other, key=lambda p: math.dist(p[:3], point[:3]))[:2]
        if min(math.dist(p[:3], end[:3]) for p in (point, *near) for end in (front[0], front[-1])) < BESIDE * length:
            continue
        compared += 1
        K = point[3]
        ways = [math.dist(p[:3], point[:3]) for p in near]
        part = ways[0] / (ways[0] + ways[1]) if sum(ways) > 0 else 0.0
        off = (K - (1 - part) * near[0][3] - part * near[1][3]) / mean
        most, total = max(most, abs(off)), total + off
    return abs(total) / compared, most


def main():
    program = sys.argv[1]
    full = "--full" in sys.argv or os.environ.get("SPRICKA_FULL")
    wrong = 0
    for name in ("plate", "bore") if full else ("plate",):
        mean, most = compare(program, CASES[name])
        print(f"{name}: K of the through crack differs by {100 * mean:.2f} % in the mean, {100 * most:.2f} % at most, from "
              "that of a model that begins with it", flush=True)
        wrong += mean > ALLOWED or most > SCATTER
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
