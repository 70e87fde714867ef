# SPDX-License-Identifier: GPL-3.0-or-later
"""Crack tips and mouths near the edge of a contact: faces that close in part, loads that turn round a lug."""
import math
import re

from program import Row, Run, asking, ending, text_of, without_checks


def closure(program, full):
    return bent_crack(program, full) + turning_load(program, full)


def bent_text():
    """The deck of a crack under bending, without its sweep."""
    return re.sub(r"^\$SWEEP.*?(?=^\$)", "", without_checks(text_of("bent_crack")), flags=re.M | re.S)


def bent_crack(program, full):
    """F11 with stress x/a + r from a crack that is open all along to one that is closed all along."""
    text = asking(bent_text(), "K1(C.1,BENT)", "K1(C.2,BENT)", "ARC.TO(C.FACES,BENT)", "CPRESS.MIN(C.FACES,BENT)")
    rows = []
    every = (0.7, 0.5, 0.499, 0.49, 0.45, 0.4, 0.3, 0.2, 0.1, 0.0, -0.2, -0.4, -0.6, -0.8, -0.9, -0.95, -0.99,
             -0.999, -0.9999, -1.0, -1.001, -1.2)
    for r in every if full else (0.5, 0.4, 0.0, -0.9, -0.9999, -1.0):
        run = Run(program, text, [f"r={r}"])
        if run.code != 0:
            rows.append(Row("S05", f"F11, r = {r}", run, ok=False))
            continue
        rows += bent_rows(run, r)
    return rows


def bent_rows(run, r):
    """K of both tips over that of the crack without bending, and how far it is closed."""
    unit = math.sqrt(math.pi)
    is_open, shut = r >= 0.5, r <= -1.0
    b = 2.0 * (1.0 + r) / 3.0  # half length of the open part
    left = r - 0.5 if is_open else 0.0
    right = r + 0.5 if is_open else (0.0 if shut else b ** 1.5)
    closed = 0.0 if is_open else (2.0 if shut else 2.0 - 2.0 * b)
    rows = []
    for name, tip, exact in (("left", "C.1", left), ("right", "C.2", right)):
        found = run.asked(f"K1({tip},BENT)") / unit
        rows.append(Row("S05", f"F11, r = {r}: F of the {name} tip", run, number=found, reference=exact,
                        allowed=3e-3, error=abs(found - exact)))
    found = run.asked("ARC.TO(C.FACES,BENT)")
    length = Row("S05", f"F11, r = {r}: closed length over a", run, number=found, reference=closed, allowed=3e-2,
                 error=abs(found - closed))
    rows.append(length)
    # where the faces part the listing says how exactly the place is known
    for place, bar in re.findall(r"faces part at (\S+) along the crack, \+- (\S+) by", run.listing()):
        rows.append(Row("S05", f"F11, r = {r}: the place where the faces part, in its bar", run, number=float(place),
                        reference=closed, allowed=float(bar) + 1e-4, error=abs(float(place) - closed)))
    told = "touch at the tip" in run.listing()
    said = told if closed > 0.01 else not (told and is_open)  # between them the tip element decides
    length.ok = length.ok and said and run.asked("CPRESS.MIN(C.FACES,BENT)") >= 0.0
    return rows


SQUARE = """DefineConstant[ R = 36, e = 86.5, L0 = 86.5, fine = 1 ];
Mesh.ElementOrder = 2;
Point(1) = {0, 0, 0};
For i In {0:3}
  Point(10 + i) = {R * Cos(i * Pi / 2), R * Sin(i * Pi / 2), 0, 2.4 / fine};
EndFor
For i In {0:3}
  Circle(10 + i) = {10 + i, 1, 10 + (i + 1) % 4};
EndFor
Point(2) = {-e, -e, 0, 10 / fine};
Point(3) = {e, -e, 0, 10 / fine};
Point(4) = {e, e, 0, 10 / fine};
Point(5) = {-e, e, 0, 10 / fine};
Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 2};
Curve Loop(1) = {1:4};
Curve Loop(2) = {10:13};
Plane Surface(1) = {1, 2};
Physical Surface("BODY") = {1};
Physical Curve("BORE") = {10:13};
Physical Curve("END") = {1};
"""

TURNING = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Square lug, load that turns'
$INCLUDE FILE='lug_model.inc'
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE DIAMETRAL=0.084
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER GAP=0
$LOAD CASE=ACROSS TYPE=RESULTANT
  SHAFT.BODY  0  (F)
$PARAMETER
  a = 10.8
$CRACK NAME=RIGHT NET=LUG A0=(a) ANGLE=0 STATE=STRESS
  (R)  0
$CRACK NAME=LEFT NET=LUG A0=(a) ANGLE=180[deg] STATE=STRESS
  (-R)  0
$END
"""


def turning_load(program, full):
    """X01: the load turns past the crack mouths, in and out of contact: K follows smoothly."""
    angles = list(range(60, 121, 1 if full else 5))
    step = angles[1] - angles[0]
    steps = "".join(f"$STEP NAME=A{angle}\n  LOAD SHAFTLOAD (cos({angle}[deg]))\n  LOAD ACROSS (sin({angle}[deg]))\n"
                    for angle in angles)
    rows = []
    for part in (0.02, 0.1, 0.3, 0.6, 1.0) if full else (0.3,):
        text = asking(ending(TURNING, steps), f"SUM(BUSH,A{angles[0]},X)")
        fine = 2 if part < 0.05 else 1  # elements of 1.2 or 2.4 mm on the bore
        run = Run(program, text, [f"a={36.0 * part}", f"fine={fine}"], files={"lug.geo": SQUARE})
        case = f"X01, a = {part} R, elements of {2.4 / fine} mm, load at 60 to 120 degrees by {step}"
        if run.code not in (0, 1):
            rows.append(Row("S05", case, run, ok=False))
            continue
        k = run.stress_intensity()
        for crack in ("RIGHT", "LEFT"):
            K = [k[f"A{angle}", crack] for angle in angles]
            bends = [abs(K[i - 1] - 2.0 * K[i] + K[i + 1]) / K[i] for i in range(1, len(K) - 1)]
            rows.append(Row("S05", f"{case}: largest second difference of K {crack}", run, number=max(bends),
                            reference=0.0, allowed=1e-2, error=max(bends)))
        # mirrored loads have mirrored cracks; the meshes are no mirror images
        error = max(abs(k[f"A{angle}", "RIGHT"] / k[f"A{180 - angle}", "LEFT"] - 1.0) for angle in angles)
        rows.append(Row("S05", f"{case}: RIGHT against LEFT of the mirrored load", run, number=error, reference=0.0,
                        allowed=3e-3, error=error))
        balance = abs(run.asked(f"SUM(BUSH,A{angles[0]},X)") / (-97100.0 * 0.5) - 1.0)
        rows.append(Row("S05", f"{case}: force between sleeve and lug", run, number=balance, reference=0.0,
                        allowed=1e-5, error=balance))
    return rows
