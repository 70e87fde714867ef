#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cracks by chance in plates under a tension that is inclined to them any way: their fronts turn until K2 has gone from
all of them, without a mesh that cannot be made.

    tests/stability/turning_cracks.py PROGRAM [--full | --all] [NUMBER ..]

The stress is uniform, s e e, by tractions on all faces. --all runs twenty in an hour, --full (or SPRICKA_FULL in the
environment) eight; else one is grown by a little.
"""
import math
import os
import random
import sys

from program import Run, numbers

SEED = 4711
ALL = range(20)
SOME = range(8)
FEW = (1,)
THIN = (8,)  # leaves strips too thin for a mesh where its front hardly grows: MESH, in the manual
FARTHER = 1.25  # times the longer axis
K2_LEFT = 0.15  # of K1, at the worst place of the last front
ENDS = ("AMAX", "EDGE")

DECK = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Turning by chance {number}'
$PARAMETER
  W = {W}
  t = {t}
$NET NAME=PLATE
  $MESH SHAPE=BLOCK TYPE={type} X0=(-W) Y0=0 Z0=(-W) LX=(2*W) LY=(t) LZ=(2*W) NX=7 NY=3 NZ=7
$ENDNET
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=PLATE.BODY MATERIAL=M STATE=SOLID
$NSET NAME=P1 WHERE=(x < -W + 1e-6 and y < 1e-6 and z < -W + 1e-6)
$NSET NAME=P2 WHERE=(x > W - 1e-6 and y < 1e-6 and z < -W + 1e-6)
$NSET NAME=P3 WHERE=(x < -W + 1e-6 and y > t - 1e-6 and z < -W + 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
{crack}
$LOAD CASE=PULL TYPE=TRACTION
{tractions}
$STEP NAME=FULL
  LOAD PULL 1
$STEP NAME=ZERO
  LOAD PULL 0
$GROW LAW=PARIS DIRECTION={direction} KMAX=FULL KMIN=ZERO C=1e-12 M={m} TOL=0.05 AMAX={last:.4g} KUNIT='MPa*mm^0.5' AUNIT='mm'
$END
"""


class Case:
    """Of the same number always the same."""

    def __init__(self, number):
        dice = random.Random(SEED + number)
        self.number = number
        self.place = ("embedded", "through", "surface", "corner")[number % 4]
        self.t = dice.uniform(4, 8)
        self.W = self.t * dice.uniform(2.5, 4)
        self.a = self.t * dice.uniform(0.12, 0.22)
        self.c = self.a * dice.uniform(0.7, 1.6)
        # in the plane of the plate's face, where that cannot be a free surface that bears shear
        tilt = math.radians(dice.uniform(10, 45)) * dice.choice((1, -1))
        self.e = (math.sin(tilt), 0.0, math.cos(tilt))
        self.m = dice.choice((2.5, 3, 4))
        self.direction = dice.choice(("HOOP", "K2ZERO"))
        self.type = dice.choice(("TET10", "HEXEC20"))

    def text(self, whole=True):
        W, t = round(self.W, 4), round(self.t, 4)
        y = 0.5 * t if self.place == "embedded" else 0.0
        x = -W if self.place in ("through", "corner") else 0.0
        longest = max(self.a, self.c)
        if self.place == "through":
            crack = (f"$CRACK NAME=C1 NET=PLATE X0={x} Y0={t / 2} Z0=0\n"
                     f"  {x + 2 * self.a:.5g} {t + 1} 0\n  {x + 2 * self.a:.5g} -1 0")
            longest = math.hypot(2 * self.a, t / 2)
        else:
            crack = f"$CRACK NAME=C1 NET=PLATE A={self.a:.5g} C={self.c:.5g} X0={x} Y0={y} Z0=0 NORMAL=Z"
        lines = []
        for axis, name in ((0, "X"), (2, "Z")):
            on = [100 * self.e[axis] * one for one in self.e]
            for sign, end in ((1, "MAX"), (-1, "MIN")):
                lines.append(f"  PLATE.{name}{end} " + " ".join(f"{sign * one:.6g}" for one in on))
        return DECK.format(number=self.number, W=W, t=t, type=self.type, crack=crack, tractions="\n".join(lines),
                           direction=self.direction, m=self.m, last=longest * (FARTHER if whole else 1.15))


def judge(run, whole, thin):
    """What went wrong, or nothing; and a line of the table."""
    if run.code not in (0, 4) or not (run.out / "life.csv").exists():
        return f"exit {run.code}: {run.messages.strip().splitlines()[-1:]}", "no life"
    head = (run.out / "life.csv").read_text(encoding="utf-8").splitlines()[0]
    ended = head.split("ended: ")[1].split(";")[0].strip()
    rows = numbers(run.out / "life.csv")
    last = rows[-1]["increment"]
    left = [abs(float(row["K2_max"])) / max(float(row["K_max"]), 1e-9) for row in rows if row["increment"] == last]
    first = [abs(float(row["K2_max"])) / max(float(row["K_max"]), 1e-9) for row in rows if row["increment"] == "1"]
    bare = run.listing().count("and no tube")
    line = (f"{ended} at front {last}, K2 up to {max(first):.2f} of K at first, {max(left):.3f} at last"
            f"{f', {bare} without a tube' if bare else ''}, {run.seconds:.0f} s")
    if ended not in ENDS and not (thin and ended == "MESH"):
        reason = next((one for one in run.listing().splitlines() if one.startswith("Ended by")), "")
        return f"{ended}: {reason}", line
    if whole and max(left) > K2_LEFT:
        return "it has not turned", line
    return "", line


def main():
    program = sys.argv[1]
    chosen = [int(word) for word in sys.argv[2:] if word.isdigit()]
    if not chosen and "--all" in sys.argv:
        chosen = ALL
    elif not chosen and ("--full" in sys.argv or os.environ.get("SPRICKA_FULL")):
        chosen = SOME
    wrong = 0
    for number in chosen or FEW:
        case = Case(number)
        run = Run(program, case.text(whole=bool(chosen)))
        trouble, line = judge(run, bool(chosen), number in THIN)
        print(f"{number:2d} {case.place}, {case.direction}: {line}{'  WRONG: ' + trouble if trouble else ''}", flush=True)
        wrong += bool(trouble)
    print(f"{wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
