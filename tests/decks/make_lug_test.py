# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the readings of decks/lug_test_double.txt and lug_test_single.txt.

The paper of Ansell and Fredriksson shows its test points in figures that are not in its text, so the
readings are made: a crack grows by da/dN = C dK^3 with K_max of the paper's Table 1 (a polynomial
through the logarithms of its six rows), R of lug_reference (K after PRESS over K), and as the paper
says of its tests, more slowly than that from 3.2 to 4.2 mm: half the rate at 3.2 mm, all of it at
4.2 mm (how much more slowly the text does not tell). Read every 500 cycles, with a normal scatter of
0.02 mm, to a hundredth.

Usage: make_lug_test.py FOLDER
"""

import random
import sys
from math import exp, log
from pathlib import Path

RADIUS = 36.0
ROWS = [0.05, 0.1, 0.2, 0.3, 0.5, 0.8]
TABLE_1 = {
    "double": [351, 477, 615, 705, 838, 1118],
    "single": [351, 474, 599, 668, 747, 907],
}
RATIO = [0.19169, 0.19317, 0.19888, 0.20253, 0.20258, 0.18814]
C, M = 4.7e-12, 3.0
SCATTER = 0.02
EVERY = 500


def through(values, x):
    """The polynomial through the values at the logarithms of ROWS (Lagrange)."""
    knots = [log(r) for r in ROWS]
    total = 0.0
    for i, value in enumerate(values):
        weight = 1.0
        for j, knot in enumerate(knots):
            if j != i:
                weight *= (x - knot) / (knots[i] - knot)
        total += weight * value
    return total


def rate(sides, a):
    x = log(a / RADIUS)
    k_max = exp(through([log(k) for k in TABLE_1[sides]], x))
    slow = 1.0 if a >= 4.2 else 0.5 + 0.5 * max(a - 3.2, 0.0)
    return slow * C * (k_max * (1.0 - through(RATIO, x))) ** M


def readings(sides, last=28.8):
    """(N, a) from 3.2 mm on, by Runge and Kutta's rule in steps of 10 cycles."""
    a, cycles, found = 3.2, 0, []
    while a < last:
        if cycles % EVERY == 0:
            found.append((cycles, a))
        k1 = rate(sides, a)
        k2 = rate(sides, a + 5 * k1)
        k3 = rate(sides, a + 5 * k2)
        k4 = rate(sides, a + 10 * k3)
        a += 10 * (k1 + 2 * k2 + 2 * k3 + k4) / 6
        cycles += 10
    return found


def main():
    for number, sides in enumerate(TABLE_1):
        noise = random.Random(1984 + number)
        lines = [
            f"# Made readings of a {sides}-sided crack in the lug (tests/decks/make_lug_test.py):",
            "# cycles, length from the bore [mm], notch of 3 mm included",
        ]
        for cycles, a in readings(sides):
            lines.append(f"{cycles:6d} {a + noise.gauss(0.0, SCATTER):7.2f}")
        name = Path(sys.argv[1]) / f"lug_test_{sides}.txt"
        name.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
