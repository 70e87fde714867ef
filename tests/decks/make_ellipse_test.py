# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the readings of decks/ellipse_test.txt, cycles and both half axes of a crack, and prints K there.

An elliptical crack in an infinite body under 100 MPa grows from a = 0.5, c = 1 by da/dN = C dK^3 with
the exact K at the ends of its axes (Irwin 1962), R = 0, as if it stayed an ellipse. Read every 5 cycles,
with a normal scatter of 0.001 mm, to a thousandth.

Usage: make_ellipse_test.py FOLDER
"""

import random
import sys
from math import cos, hypot, pi, sin, sqrt
from pathlib import Path

STRESS, C, M = 100.0, 1e-9, 3.0
SCATTER = 0.001
EVERY, LAST = 5, 225


def exact_k(a, c):
    """K at the ends of the axes a and c, a < c."""
    count = 400
    angles = [(i + 0.5) * pi / (2 * count) for i in range(count)]
    E = 0.5 * pi * sum(hypot(sin(t), a / c * cos(t)) for t in angles) / count
    deepest = STRESS * sqrt(pi * a) / E
    return deepest, deepest * sqrt(a / c)


def rates(sizes):
    return [C * k**M for k in exact_k(*sizes)]


def states():
    """(N, a, c), by Runge and Kutta's rule cycle by cycle."""
    now = [0.5, 1.0]
    for cycles in range(LAST + 1):
        yield cycles, now[0], now[1]
        k1 = rates(now)
        k2 = rates([x + 0.5 * k for x, k in zip(now, k1)])
        k3 = rates([x + 0.5 * k for x, k in zip(now, k2)])
        k4 = rates([x + k for x, k in zip(now, k3)])
        now = [x + (p + 2 * q + 2 * r + s) / 6 for x, p, q, r, s in zip(now, k1, k2, k3, k4)]


def main():
    noise = random.Random(1962)
    lines = [
        "# Made readings of an elliptical crack (tests/decks/make_ellipse_test.py):",
        "# cycles, half axes a and c [mm]",
    ]
    for cycles, a, c in states():
        if cycles % EVERY == 0:
            lines.append(f"{cycles:4d} {a + noise.gauss(0.0, SCATTER):7.3f} {c + noise.gauss(0.0, SCATTER):7.3f}")
        if cycles % 45 == 0:
            print(f"N {cycles}: a {a:.4f} c {c:.4f} K {exact_k(a, c)[0]:.3f} {exact_k(a, c)[1]:.3f}")
    (Path(sys.argv[1]) / "ellipse_test.txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
