#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The life of decks/corner_hole_life.deck by a table of K, as life programs take one (Fawaz and Andersson 2004 made such
tables): K1 of quarter ellipses of six depths and six lengths, ten degrees inside both ends, each solved for itself,
cubic splines of the logarithms between them, and both axes integrated. Beside it the growth of the program, held to an
ellipse and free.

    tests/bench/corner_hole_table.py [--spricka PROGRAM] [--out FOLDER]

Prints cycles to depths of 2.5 and 4 mm. Needs numpy and scipy; some minutes on one thread.
"""
import argparse
import csv
import math
import subprocess
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import RectBivariateSpline

TOP = Path(__file__).resolve().parents[2]
BORE = 3.175
AXES = np.array((1.2, 1.5, 1.9, 2.4, 3.2, 4.2))
DEPTHS = (2.5, 4.0)
FIRST, C, M = 1.27, 1e-12, 3
INSIDE = math.radians(10)


def rows_of(file):
    with open(file, encoding="utf-8") as rows:
        return list(csv.DictReader(line for line in rows if not line.startswith("#")))


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        folder.mkdir(parents=True, exist_ok=True)
        deck = (TOP / "decks" / "corner_hole_life.deck").read_text(encoding="utf-8")
        self.text = deck[:deck.index("$CHECK")] + "$END\n"
        geometry = "strip_bore_solid.geo"
        (folder / geometry).write_text((TOP / "decks" / geometry).read_text(encoding="utf-8"), encoding="utf-8")

    def run(self, name, text):
        deck, out = self.folder / f"{name}.deck", self.folder / f"{name}.run"
        deck.write_text(text, encoding="utf-8")
        subprocess.run([self.program, "run", deck, "--threads", "1", "--quiet", "--out", out], check=True)
        return out

    def K_of(self, a, c):
        """Smooth K1 ten degrees inside the ends of A (on the bore) and C (on the face)."""
        text = self.text.replace("A=1.27", f"A={a} C={c}")
        growth = text.index("$GROW")
        text = text[:growth] + text[text.index("\n", growth) + 1:]
        points = [row for row in rows_of(self.run(f"table_{a}_{c}", text) / "k.csv") if row["step"] == "FULL"]
        found = sorted((math.atan2(float(row["y"]) / a, (float(row["x"]) - BORE) / c), float(row["K1_smooth"]))
                       for row in points)
        return tuple(np.interp(phi, *zip(*found)) for phi in (0.5 * math.pi - INSIDE, INSIDE))

    def grown(self, shape):
        """Cycles to the depths by the program."""
        text = self.text.replace("AMAX=8", f"AMAX=4.3 SHAPE={shape}")
        text = text.replace("$END", "$CHECK\n" + "".join(f"  N({d}) = 1 ABS 1e9\n" for d in DEPTHS) + "$END")
        listing = (self.run(shape, text) / "listing.txt").read_text(encoding="utf-8")
        return [float(next(line for line in listing.splitlines() if line.startswith(f"  N({d:g})")).split()[1])
                for d in DEPTHS]


def by_table(table):
    """Cycles to the depths, and the lengths there."""
    logs = np.log(AXES)
    splines = [RectBivariateSpline(logs, logs, np.log(table[:, :, end])) for end in (0, 1)]

    def rate(_, axes):
        """Both axes so that the ellipse moves at both places as K there says."""
        a, c = axes
        moves = []
        for phi in (0.5 * math.pi - INSIDE, INSIDE):
            normal = np.array((math.sin(phi) / a, math.cos(phi) / c))
            moves.append(np.array((math.sin(phi), math.cos(phi))) * normal / np.linalg.norm(normal))
        K = [math.exp(spline(math.log(a), math.log(c))[0, 0]) for spline in splines]
        return np.linalg.solve(moves, [C * k ** M for k in K])

    found = []
    for depth in DEPTHS:
        reached = lambda _, axes, depth=depth: axes[0] - depth  # noqa: E731
        reached.terminal = True
        end = solve_ivp(rate, (0, 1e7), (FIRST, FIRST), events=reached, rtol=1e-8)
        found.append((end.t[-1], end.y[1, -1]))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spricka", type=Path, default=TOP / "build/release/bin/spricka")
    parser.add_argument("--out", type=Path, default=Path("corner_hole_table.run"))
    arguments = parser.parse_args()
    bench = Bench(arguments.spricka, arguments.out.resolve())
    table = np.array([[bench.K_of(a, c) for c in AXES] for a in AXES])
    np.savetxt(bench.folder / "K_depth.txt", table[:, :, 0], fmt="%.2f")
    np.savetxt(bench.folder / "K_length.txt", table[:, :, 1], fmt="%.2f")
    found = by_table(table)
    for depth, (cycles, length) in zip(DEPTHS, found):
        print(f"table: N({depth:g}) = {cycles:.0f}, c = {length:.3f}", flush=True)
    for shape in ("ELLIPSE", "FREE"):
        for depth, cycles, (own, _) in zip(DEPTHS, bench.grown(shape), found):
            print(f"{shape}: N({depth:g}) = {cycles:.0f}, {100 * (cycles / own - 1):+.2f} % of the table", flush=True)


if __name__ == "__main__":
    main()
