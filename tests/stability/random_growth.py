#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cracks by chance in plates and at a bore, inside, at surfaces and at corners, grown to their ends: none
stops for want of a mesh before 80 % of the way to the surface, or the thickness, is cut; every end has its name.
From 50 on there is one on each side of the bore.

    tests/stability/random_growth.py PROGRAM [--full | --all] [NUMBER ..]

To its end one takes minutes: --all runs the sixty, --full (or SPRICKA_FULL in the environment) fourteen; else
one is grown, and only its beginning.
"""
import math
import os
import random
import sys

from program import Run, numbers

ALL = range(60)
SOME = (*range(10), 26, 47, 50, 53)  # 26 becomes two fronts; of 47 an axis went farther than was asked for, for ever
FEW = (0,)
BEGINNING = 1.2  # of the longer axis
SEED = 20262
CUT = 0.8
ENDS = ("EDGE", "LINK-UP", "THRESHOLD", "CLOSED", "ARREST", "AMAX")

PLATE = """$NET NAME=PLATE
  $MESH SHAPE=BLOCK TYPE={type} X0=(-W) Y0=0 Z0=(-L) LX=(2*W) LY=(t) LZ=(2*L) NX={nx} NY={ny} NZ={nz}
$ENDNET
"""
BORE = """$PARAMETER
  R = {R}
  x0 = (-W)
  x1 = (W)
  z0 = (-L)
  z1 = (L)
  h = {h}
$NET NAME=PLATE
  $IMPORT FILE='strip_bore_solid.geo' FORMAT=GEO
$ENDNET
"""
CRACK = """$CRACK NAME=C{number} NET=PLATE A={a:.4g} C={c:.4g} X0={x:.6g} Y0={y:.6g} Z0={z:.4g} NORMAL=Z
"""
DECK = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Crack by chance {number}'
$PARAMETER
  W = {W}
  t = {t}
  L = {L}
{body}$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET={eset} MATERIAL=M STATE=SOLID
$NSET NAME=TOP WHERE=(abs(z - L) < 1e-6)
$NSET NAME=FOOT WHERE=(abs(z + L) < 1e-6)
$NSET NAME=P1 WHERE=(x < -W + 1e-6 and y < 1e-6 and z < -L + 1e-6)
$NSET NAME=P2 WHERE=(x > W - 1e-6 and y < 1e-6 and z < -L + 1e-6)
$NSET NAME=P3 WHERE=(x < -W + 1e-6 and y > t - 1e-6 and z < -L + 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  P1
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  P2
$FREEDOM CLASS=SUPPRESSED DOF=Z
  P3
{cracks}$LOAD CASE=PULL TYPE=TRACTION
  TOP   0  0  ({tension})
  FOOT  0  0  (-({tension}))
$STEP NAME=FULL
  LOAD PULL 1
$STEP NAME=ZERO
  LOAD PULL 0
$GROW LAW=PARIS SHAPE={shape} KMAX=FULL KMIN=ZERO C=1e-12 M={m} TOL=0.1 KUNIT='MPa*mm^0.5' AUNIT='mm'{last}
$END
"""


class Case:
    """One plate with one crack, or two; of the same number always the same."""

    def __init__(self, number):
        dice = random.Random(SEED + number)
        self.number = number
        self.place = ("corner", "surface", "embedded", "bore corner", "bore surface")[number % 5]
        if number >= 50:
            self.place = "bore pair"
        self.bore = self.place.startswith("bore")
        self.shape = "ELLIPSE" if number % 4 == 3 else "FREE"
        self.t = dice.uniform(2, 6)
        self.W = self.t * dice.uniform(2.5, 5)
        self.H = self.W * dice.uniform(0.9, 1.3)
        self.R = dice.uniform(0.4, 1.2) * self.t
        self.W = max(self.W, 3 * self.R)
        # The longer axis along or across the thickness; both well inside.
        a = self.t * dice.uniform(0.15, 0.45)
        ratio = math.exp(dice.uniform(math.log(0.4), math.log(2.0)))
        c = min(a / ratio, 0.3 * self.W)
        self.x = self.y = 0.0
        if self.place == "corner":
            self.x = -self.W
        elif self.place == "surface":
            self.x = dice.uniform(-0.4, 0.4) * (self.W - 2 * c)
        elif self.place == "embedded":
            a = min(a, 0.3 * self.t)
            self.y = self.t * dice.uniform(0.4, 0.6)
            self.x = dice.uniform(-0.3, 0.3) * (self.W - 2 * c)
        elif self.place in ("bore corner", "bore pair"):
            self.x = self.R
            c = min(c, 0.5 * (self.W - self.R))
        else:
            # across the thickness along the bore: C is along x, A along y
            self.x = self.R
            self.y = self.t * dice.uniform(0.4, 0.6)
            a = min(a, 0.3 * self.t)
            c = min(c, 0.5 * (self.W - self.R))
        self.a, self.c = a, c
        self.z = 0.0 if self.bore else dice.uniform(-0.1, 0.1) * self.H
        self.m = dice.choice((2.5, 3, 3.5, 4))
        self.bend = dice.choice((0, 0, 0.5, -0.5))
        self.type = dice.choice(("TET10", "HEXEC20"))
        self.others = []  # a, c, x and y of more cracks
        if self.place == "bore pair":
            part = dice.uniform(0.4, 1)
            self.others.append((part * a, part * c, -self.R, dice.choice((0, round(self.t, 4)))))

    @property
    def cracks(self):
        return [(self.a, self.c, self.x, self.y), *self.others]

    def text(self, whole=True):
        body = BORE.format(R=round(self.R, 4), h=round(0.5 * self.R, 4)) if self.bore else PLATE.format(
            type=self.type, nx=6, ny=2, nz=6)
        last = "" if whole else f" AMAX={BEGINNING * max(self.a, self.c):.4g}"
        cracks = "".join(CRACK.format(number=k + 1, a=a, c=c, x=round(x, 4), y=round(y, 4), z=self.z)
                         for k, (a, c, x, y) in enumerate(self.cracks))
        bend = f"100*(1 + ({self.bend})*(2*y/t - 1))"
        return DECK.format(number=self.number, W=round(self.W, 4), t=round(self.t, 4), L=round(self.H, 4), body=body,
                           cracks=cracks, tension=bend, shape=self.shape, m=self.m, last=last, eset="PLATE.STRIP" if self.bore else "PLATE.BODY")

    def border(self, place, dx, dy):
        """How far it is from a crack's place to the border of the section, along a direction."""
        ways = [1e9]
        for d, x, low, high in ((dx, place[0], -self.W, self.W), (dy, place[1], 0.0, self.t)):
            if abs(d) > 1e-12:
                ways.append(((high if d > 0 else low) - x) / d)
        return max(min(ways), 1e-9)

    def cut(self, run):
        """How much of the way to the border a crack has gone, where it has gone most of it."""
        rows = numbers(run.out / "life.csv")
        last = rows[-1]["increment"]
        most = 0.0
        for row in rows:
            if row["increment"] == last:
                place = self.cracks[int(row["tip"][1]) - 1][2:]  # of C1 or C2
                dx, dy = float(row["x"]) - place[0], float(row["y"]) - place[1]
                way = math.hypot(dx, dy)
                # along the surface that it began at is no way to anywhere
                if way > 0 and self.border(place, dx / way, dy / way) > 1e-3 * self.t:
                    most = max(most, way / self.border(place, dx / way, dy / way))
        return most


def judge(case, run):
    """What went wrong, or nothing; and a line of the table."""
    if run.code not in (0, 4) or not (run.out / "life.csv").exists():
        return f"exit {run.code}: {run.messages.strip().splitlines()[-1:]}", "no life"
    head = (run.out / "life.csv").read_text(encoding="utf-8").splitlines()[0]
    ended = head.split("ended: ")[1].split(";")[0].strip()
    listing = run.listing()
    through = listing.count("goes through a surface")
    cut = case.cut(run)
    line = f"{ended}, {through} passages, {100 * cut:.0f} % cut, {run.seconds:.0f} s"
    if ended not in ENDS and not (ended == "MESH" and (cut >= CUT or through > 0)):
        reason = next((one for one in listing.splitlines() if one.startswith("Ended by")), "")
        return f"{ended} with {100 * cut:.0f} % cut: {reason}", line
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
        trouble, line = judge(case, run)
        print(f"{number:2d} {case.place}, {case.shape}: {line}{'  WRONG: ' + trouble if trouble else ''}", flush=True)
        wrong += bool(trouble)
    print(f"{wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
