#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lives of cracks by chance in plates of the plane: they are right to the TOL of $GROW. Edge cracks and
cracks with two tips off the middle, alone and two on one line, under constant load and spectra, by laws whose
threshold lies inside the growth of one tip or another. What is right is the same growth with a tolerance a
hundred times smaller, of whose stations none is a station of the first.

    tests/stability/random_lives.py PROGRAM [--full] [NUMBER ..]

--full (or SPRICKA_FULL in the environment) runs a hundred, of which 95 are to be right; else three.
"""
import os
import random
import sys

from program import Run, numbers

ALL = range(100)
FEW = (0, 1, 2)
WANTED = 0.95
SEED = 20263
TOL = 1e-3

DECK = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Life by chance {number}'
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=40 LY=80 X0=0 Y0=-40 NX=16 NY=32
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=1
$NSET NAME=FOOT WHERE=(abs(y + 40) < 1e-9 and abs(x - 20) < 1e-9)
$NSET NAME=HEAD WHERE=(abs(y - 40) < 1e-9 and abs(x - 20) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  FOOT
$FREEDOM CLASS=SUPPRESSED DOF=X
  HEAD
{cracks}$LOAD CASE=PULL TYPE=TRACTION
  YMAX  0  ({stress}*(1 + ({slope})*(x - 20)/20))
  YMIN  0  (-{stress}*(1 + ({slope})*(x - 20)/20))
$STEP NAME=ZERO
  LOAD PULL 0
$STEP NAME=FULL
  LOAD PULL 1
$STEP NAME=LOW
  LOAD PULL {ratio}
$LOADPATH NAME=UP FROM=ZERO TO=FULL
{spectrum}$GROW {law} {loads} TOL={tol} KUNIT='MPa*m^0.5' AUNIT='mm' AMAX={last}
$END
"""
SPECTRUM = """$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS
  {low} 1.0 3
  {low} 0.7 100
"""


class Case:
    """One plate; of the same number always the same."""

    def __init__(self, number):
        dice = random.Random(SEED + number)
        self.number = number
        self.place = ("edge", "off the middle", "two")[number % 3]
        self.spectrum = dice.random() < 0.4
        slope = dice.uniform(-0.6, 0.6)
        ratio = dice.choice((0.0, 0.1, 0.3, 0.5))
        stress = dice.uniform(40, 90)
        if self.place == "edge":
            first = dice.uniform(2, 6)
            cracks = f"$CRACK NAME=C\n  0 0\n  {first:.4g} 0\n"
            last = dice.uniform(2.0, 3.5) * first
        elif self.place == "off the middle":
            half = dice.uniform(1.5, 3)
            middle = dice.uniform(10, 16)
            cracks = f"$CRACK NAME=C\n  {middle - half:.4g} 0\n  {middle + half:.4g} 0\n"
            last = dice.uniform(1.8, 2.5) * half
        else:
            one, other = dice.uniform(1.5, 2.5), dice.uniform(1, 2)
            gap = dice.uniform(4, 7)
            begin = dice.uniform(7, 12)
            cracks = (f"$CRACK NAME=C\n  {begin:.4g} 0\n  {begin + 2 * one:.4g} 0\n"
                      f"$CRACK NAME=D\n  {begin + 2 * one + gap:.4g} 0\n  {begin + 2 * (one + other) + gap:.4g} 0\n")
            last = one + 0.3 * gap
        # About what the first crack has at its ends: it, or one of its tips, begins next to the threshold.
        begins = {"edge": 1.2, "off the middle": 1.0, "two": 1.0}[self.place]
        length = {"edge": lambda: first, "off the middle": lambda: half, "two": lambda: one}[self.place]()
        K = begins * stress * (3.14159 * length * 1e-3) ** 0.5
        threshold = dice.uniform(0.5, 0.95) * K * (1 - ratio)
        law = dice.choice(("WALKER", "NASGRO", "PARIS"))
        constants = {
            "PARIS": f"LAW=PARIS C=3e-8 M={dice.uniform(2.5, 4):.3g} DKTH={threshold * dice.uniform(0.6, 1):.4g}",
            "WALKER": f"LAW=WALKER C=3e-8 M={dice.uniform(2.5, 4):.3g} P=0.6 DKTH={threshold * dice.uniform(0.6, 1):.4g}",
            "NASGRO": f"LAW=NASGRO C=1.5e-7 M=3.2 P={dice.choice((0.25, 0.5))} Q=1 KC=150 "
                      f"DK0={threshold / (1 - ratio) * 0.9:.4g} CTHP=1.2 CTHM=0.1 AINTRINSIC=0"}[law]
        self.values = {"number": number, "cracks": cracks, "stress": round(stress, 3), "slope": round(slope, 3),
                       "ratio": ratio, "law": constants, "last": round(last, 4),
                       "spectrum": SPECTRUM.format(low=ratio) if self.spectrum else "",
                       "loads": "SPECTRUM=S" if self.spectrum else "KMAX=FULL KMIN=LOW"}

    def text(self, tol):
        return DECK.format(tol=tol, **self.values)


def life(program, case, tol):
    """Cycles at the end, arms there, and how it ended."""
    run = Run(program, case.text(tol))
    if run.code != 0:
        return None
    curve = numbers(run.out / "life_curve.csv")
    ended = next(line for line in run.listing().splitlines() if line.startswith("Ended by"))
    return [{k: float(v) for k, v in row.items() if v} for row in curve], ended.split(":")[0]


def at(curve, column, a):
    """N where a tip has a length."""
    for before, after in zip(curve, curve[1:]):
        if before[column] <= a <= after[column] and after[column] > before[column]:
            return before["N"] + (after["N"] - before["N"]) * (a - before[column]) / (after[column] - before[column])
    return curve[-1]["N"]


def main():
    program = sys.argv[1]
    chosen = [int(word) for word in sys.argv[2:] if word.isdigit()]
    full = "--full" in sys.argv or os.environ.get("SPRICKA_FULL")
    cases = [Case(number) for number in chosen or (ALL if full else FEW)]
    right = known = 0
    for case in cases:
        found, wanted = life(program, case, TOL), life(program, case, TOL / 100)
        if found is None or wanted is None:
            print(f"{case.number:3} {case.place:15} not solved")
            known += 1
            continue
        # A growth that ends at a threshold has no last cycle to compare: of each 98 % of the way.
        column = max((name for name in wanted[0][0] if name != "N"),
                     key=lambda name: wanted[0][-1][name] / wanted[0][0][name])
        begin, end = wanted[0][0][column], min(wanted[0][-1][column], found[0][-1][column])
        a = begin + 0.98 * (end - begin)
        N, true = at(found[0], column, a), at(wanted[0], column, a)
        error = N / true - 1 if true > 0 else (0.0 if N == true else 1.0)
        good = abs(error) <= TOL and found[1] == wanted[1]
        known += 1
        right += good
        print(f"{case.number:3} {case.place:15} {'spectrum' if case.spectrum else 'steps':9} "
              f"{case.values['law'].split()[0]:11} N {N:10.6g} {error:+.1e} {wanted[1]}"
              f"{'' if good else '   <-- ' + found[1]}", flush=True)
    print(f"{right} of {known} right to {TOL}")
    return 0 if right >= WANTED * known else 1


if __name__ == "__main__":
    sys.exit(main())
