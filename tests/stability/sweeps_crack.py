# SPDX-License-Identifier: GPL-3.0-or-later
"""Cracks in bad meshes, thin ligaments, cracks shorter than elements, tip meshes."""
import math
import random
import re
import statistics

from cracked_meshes import Grid, deck
from program import Row, Run, changed, numbers, text_of, without_checks

SENT_HALF = 2.824579  # F01, a/W = 0.5


def stress_intensities(run, crack="C"):
    """{tip: (K1, K2, a)} of a run's only step."""
    return {row["crack"]: (float(row["K1"]), float(row["K2"]), float(row["a"]))
            for row in numbers(run.out / "k.csv") if row["K1"] and row["crack"].startswith(crack)}


def strip_error(program, grid, angle=0.0):
    """F01 with a/W = 0.5: the run and the relative error of K1, none if refused."""
    run = Run(program, deck(grid, [(0.0, 0.0), (0.5, 0.0)], angle))
    if run.code != 0:
        return run, None
    return run, abs(stress_intensities(run)["C"][0] / (SENT_HALF * math.sqrt(math.pi * 0.5)) - 1.0)


def slant_error(program, grid, angle=0.0):
    """F04 at 45 degrees, a = 1: the larger error of K1 and K2 over K0 at both tips."""
    h = math.sqrt(0.5)
    run = Run(program, deck(grid, [(-h, -h), (h, h)], angle))
    if run.code != 0:
        return run, None
    k0 = math.sqrt(math.pi)
    return run, max(max(abs(k1 / k0 - 0.5), abs(abs(k2) / k0 - 0.5)) for k1, k2, _ in stress_intensities(run).values())


STRIP, PLATE = (0.0, 1.0, -2.0, 2.0), (-40.0, 40.0, -40.0, 40.0)


def distortion(program, full):
    """S01."""
    rows = []
    cases = (("F01, a/W = 0.5", strip_error, STRIP, 12, 48), ("F04, 45 deg", slant_error, PLATE, 20, 20))
    for name, error_of, box, nx, ny in cases:
        for d in (0.0, 0.1, 0.2, 0.3, 0.4, 0.45) if full else (0.3, 0.45):
            rows += shaken(program, (name, error_of, box, nx, ny), d, 10 if full and d > 0.0 else 1)
        for angle in (0.3, 1.2, math.pi / 2.0) if full else (0.3,):
            run, error = error_of(program, Grid(box, nx, ny).shake(0.2, 7), angle)
            rows.append(Row("S01", f"{name}, d = 0.2, turned by {angle:.3g} rad", run, number=error, reference=0.0,
                            allowed=3e-3, error=error))
    for name, error_of, box, nx, ny in (("F01", strip_error, STRIP, 40, 8), ("F01", strip_error, STRIP, 3, 240),
                                        ("F04", slant_error, PLATE, 80, 4), ("F04", slant_error, PLATE, 4, 80)):
        for d in (0.0, 0.3) if full else (0.3,):
            run, error = error_of(program, Grid(box, nx, ny).shake(d, 3))
            rows.append(Row("S01", f"{name}, elements stretched 20:1, {nx} by {ny}, d = {d}", run, number=error,
                            reference=0.0, allowed=3e-3, error=error))
    return rows + folded(program)


def shaken(program, case, d, seeds):
    """Worst (to d = 0.3) or median error over seeds."""
    name, error_of, box, nx, ny = case
    errors = []
    for seed in range(seeds):
        run, error = error_of(program, Grid(box, nx, ny).shake(d, seed))
        if error is None:
            return [Row("S01", f"{name}, d = {d}, seed {seed}", run, ok=False)]
        errors.append(error)
    middle = d > 0.3
    error, allowed = (statistics.median(errors), 1e-2) if middle else (max(errors), 3e-3)
    word = f"median of {seeds} seeds (worst {max(errors):.1e})" if middle else f"worst of {seeds} seeds"
    return [Row("S01", f"{name}, d = {d}: {word}", run, number=error, reference=0.0, allowed=allowed, error=error)]


def folded(program):
    """A corner pulled over the other side of its element."""
    rows = []
    for case, grid in (("one corner moved by 1.2 elements", Grid(STRIP, 12, 48)),
                       ("d = 0.45, folded elements not mended", Grid(STRIP, 12, 48).shake(0.45, 0, fold=True))):
        if "corner" in case:
            grid.corner[6, 24][0] += 1.2 / 12.0
        run, error = strip_error(program, grid)
        said = run.code != 0 and "Jacobian" in run.messages and "lement" in run.messages
        rows.append(Row("S01", f"F01, {case}: refused by name", run, number=error, ok=said))
    return rows


SENT = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Edge crack in a strip, whole'
$PARAMETER
  a = 0.9
  n = 16
$MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=-2 LX=1 LY=4 NX=(n) NY=(4*n)
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=P WHERE=(abs(x-1) < 1e-9 and abs(y) < 1e-9)
$NSET NAME=Q WHERE=(abs(x-1) < 1e-9 and abs(y-2) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P
$FREEDOM CLASS=SUPPRESSED DOF=X
  Q
$CRACK NAME=C A0=(a) ANGLE=0
  0 0
$LOAD CASE=T TYPE=TRACTION
  YMAX 0 1
  YMIN 0 -1
$STEP NAME=PULL
  LOAD T 1
$END
"""

CENTRE = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Centre crack, whole plate'
$PARAMETER
  a = 0.9
$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=-1 Y0=-3 LX=2 LY=6 NX=20 NY=60
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=P WHERE=(abs(x) < 1e-9 and abs(y+3) < 1e-9)
$NSET NAME=Q WHERE=(abs(x) < 1e-9 and abs(y-3) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P
$FREEDOM CLASS=SUPPRESSED DOF=X
  Q
$CRACK NAME=C
  (-a) 0
  (a) 0
$LOAD CASE=T TYPE=TRACTION
  YMAX 0 1
  YMIN 0 -1
$STEP NAME=PULL
  LOAD T 1
$END
"""

HOLE = """// Plate with a hole of radius 1 beside a crack's line
DefineConstant[ fine = 1 ];
Mesh.ElementOrder = 2;
Point(1) = {-10, -10, 0, 2 / fine};
Point(2) = {10, -10, 0, 2 / fine};
Point(3) = {10, 10, 0, 2 / fine};
Point(4) = {-10, 10, 0, 2 / fine};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Point(5) = {0, 0, 0};
For i In {0:3}
  Point(10 + i) = {Cos(i * Pi / 2), Sin(i * Pi / 2), 0, 0.4 / fine};
EndFor
For i In {0:3}
  Circle(10 + i) = {10 + i, 5, 10 + (i + 1) % 4};
EndFor
Curve Loop(1) = {1:4};
Curve Loop(2) = {10:13};
Plane Surface(1) = {1, 2};
Physical Surface("BODY") = {1};
Physical Curve("SOUTH") = {1};
Physical Curve("NORTH") = {3};
"""

TO_HOLE = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Crack that meets a hole'
$PARAMETER
  gap  = 0.1
  fine = 1
$IMPORT FILE='shaft.geo' FORMAT=GEO
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=P WHERE=(abs(x+10) < 1e-9 and abs(y+10) < 1e-9)
$NSET NAME=Q WHERE=(abs(x-10) < 1e-9 and abs(y+10) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P
$FREEDOM CLASS=SUPPRESSED DOF=Y
  Q
$CRACK NAME=C
  -5 0
  (-1-gap) 0
$LOAD CASE=T TYPE=TRACTION
  NORTH 0 1
  SOUTH 0 -1
$STEP NAME=PULL
  LOAD T 1
$END
"""


def ligament(program, full):
    """S08."""
    rows = []
    reference = {0.9: (34.6326, 1e-3), 0.95: (99.1303, 3e-3), 0.98: (394.647, 1e-2)}
    for n in (8, 16, 31) if full else (16,):
        for a, (f, allowed) in reference.items():
            run = Run(program, SENT, [f"a={a}", f"n={n}"])
            rows.append(row_of("S08", f"edge crack, a/W = {a}, {n} elements over the width", run, f, a, allowed))
        # beyond: F (1 - a/W)^1.5 tends to 1.1215 (Benthem and Koiter 1973)
        for a in (0.99, 0.999):
            run = Run(program, SENT, [f"a={a}", f"n={n}"])
            rows.append(row_of("S08", f"edge crack, a/W = {a}, {n} elements, against the limit of deep cracks", run,
                               1.12152 / (1.0 - a) ** 1.5, a, 4.0 * (1.0 - a) / 10.0 + 2e-3))
        rows.append(refused("S08", f"edge crack, a/W = 0.99995, {n} elements", Run(program, SENT, ["a=0.99995",
                                                                                            f"n={n}"]), "net section"))
    rows.append(refused("S08", "edge crack, a/W = 1", Run(program, SENT, ["a=1"]), "net section"))
    for a in (0.5, 0.9, 0.95, 0.98, 0.99) if full else (0.95, 0.98):
        f = (1.0 - 0.025 * a ** 2 + 0.06 * a ** 4) / math.sqrt(math.cos(math.pi * a / 2.0))
        run = Run(program, CENTRE, [f"a={a}"])
        for tip in ("C.1", "C.2"):
            rows.append(row_of("S08", f"centre crack, a/W = {a}, {tip}, formula good to 0.1 %", run, f, a, 2e-3, tip))
    return rows + to_hole(program, full)


def to_hole(program, full):
    """No reference: hosts three times as fine must say the same."""
    rows = []
    for gap in (0.5, 0.1, 0.04, 0.01) if full else (0.04,):
        runs = [Run(program, TO_HOLE, [f"gap={gap}", f"fine={fine}"], files={"shaft.geo": HOLE}) for fine in (1, 3)]
        if any(run.code != 0 for run in runs):
            rows.append(Row("S08", f"crack {gap} from the next hole", next(r for r in runs if r.code != 0), ok=False))
            continue
        coarse, fine = (stress_intensities(run) for run in runs)
        for tip in ("C.1", "C.2"):
            rows.append(Row("S08", f"crack {gap} from the next hole (R = 1), {tip}, against a finer net", runs[0],
                            number=coarse[tip][0], reference=fine[tip][0], allowed=3e-3))
    rows.append(refused("S08", "crack that ends in the next hole",
                        Run(program, TO_HOLE, ["gap=-0.5"], files={"shaft.geo": HOLE}), "leaves its body"))
    return rows


def row_of(sweep, case, run, f, a, allowed, tip="C"):
    """K1 over sqrt(pi a) against F, and the length that is reported."""
    if run.code != 0:
        return Row(sweep, case, run, reference=f, allowed=allowed, ok=False)
    k1, _, length = stress_intensities(run)[tip]
    row = Row(sweep, case, run, number=k1 / math.sqrt(math.pi * a), reference=f, allowed=allowed)
    row.ok = row.ok and abs(length - a) <= 1e-6 * a
    return row


def refused(sweep, case, run, words):
    """A refusal that says why."""
    return Row(sweep, f"{case}: refused", run, ok=run.code in (3, 4) and words in run.messages)


def short_crack(program, full):
    """S09: F03, one crack, hosts with elements of a tenth of the radius and larger ones."""
    text = changed(without_checks(text_of("hole_crack")), ("NR=44 NT=48 BIAS=180", "NR=(nr) NT=(nt) BIAS=(bias) "
                                                           "T0=(turn) T1=(turn+2*pi)"),
                   ("$PARAMETER\n", "$PARAMETER\n  a = 0.05\n  nr = 51\n  nt = 62\n  bias = 190\n  turn = 0\n"),
                   ("A0=(0.1*R)", "A0=(a)"), ("NAME=R A0", "NAME=C A0"),
                   ("NAME=WEST WHERE=(abs(y) < 1e-6 and abs(x + W) < 1e-6)",
                    "NAME=WEST WHERE=(abs(sqrt(x^2+y^2)-W) < 1e-6 and x < -0.99*W and abs(atan2(y,x)-pi-turn) < 4)"),
                   ("NAME=EAST WHERE=(abs(y) < 1e-6 and abs(x - W) < 1e-6)",
                    "NAME=EAST WHERE=(abs(x-W*cos(turn)) < 1e-6 and abs(y-W*sin(turn)) < 1e-6)"))
    return shorts(program, full, text)


def shorts(program, full, text):
    """Lengths from half an element down to a hundredth of one; mouths at nodes and anywhere."""
    text = re.sub(r"\$GROW.*?(?=^\$)", "", text, flags=re.M | re.S)
    text = re.sub(r"WEST WHERE=.*", "WEST WHERE=(abs(x+W*cos(turn)) < 1e-6 and abs(y+W*sin(turn)) < 1e-6)", text)
    rows = []
    hosts = ((51, 62, 190), (27, 32, 170)) if full else ((51, 62, 190),)
    for nr, nt, bias in hosts:
        for turn in (0.0, 0.03, 0.05) if full else (0.03,):
            for a, f in ((0.05, 3.0373), (0.02, 3.2249), (0.01, 3.2932), (0.001, 3.357), (1e-5, 3.3645)):
                run = Run(program, text, [f"a={a}", f"nr={nr}", f"nt={nt}", f"bias={bias}", f"turn={turn}"])
                case = f"a/R = {a:g}, elements of {2.0 * math.pi / nt:.2f} R, mouth {turn / (2.0 * math.pi / nt):.2f} from a node"
                if run.code != 0:
                    rows.append(Row("S09", case, run, ok=False))
                    continue
                found = [row for row in numbers(run.out / "k.csv") if row["step"] == "TENSION"][0]
                row = Row("S09", case, run, number=float(found["K1"]) / math.sqrt(math.pi * a), reference=f, allowed=1e-2)
                row.ok = row.ok and abs(float(found["a"]) - a) <= 1e-6 * a
                rows.append(row)
    return rows


PLATE_DECK = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Random cracks'
$PARAMETER
  n = 10
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=10 NX=(n) NY=(n)
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN
$NSET NAME=P WHERE=(abs(x) < 1e-9 and abs(y) < 1e-9)
$NSET NAME=Q WHERE=(abs(x-10) < 1e-9 and abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  P
$FREEDOM CLASS=SUPPRESSED DOF=Y
  Q
$LOAD CASE=T TYPE=TRACTION
  YMAX 0 1
  YMIN 0 -1
  XMAX 1 0
  XMIN -1 0
$STEP NAME=PULL
  LOAD T 1
"""


def random_cracks(dice):
    """Up to three cracks, from 0.006 to more than the plate, from an edge or inside, bent and smooth."""
    cards = ""
    for name in "ABC"[:dice.choice((1, 1, 2, 3))]:
        size = 10.0 ** dice.uniform(-1.5, 0.6)
        edge = dice.random() < 0.5
        x, y = (0.0, dice.uniform(0.5, 9.5)) if edge else (dice.uniform(1.0, 9.0), dice.uniform(1.0, 9.0))
        turn = dice.uniform(-1.2, 1.2) if edge else dice.uniform(-3.1, 3.1)
        points = [(x, y)]
        for _ in range(dice.choice((1, 1, 1, 2, 3, 5))):
            step = size * dice.uniform(0.2, 1.0)
            x, y = x + step * math.cos(turn), y + step * math.sin(turn)
            points.append((x, y))
            turn += dice.uniform(-1.3, 1.3)
        smooth = " LINE=SMOOTH" if dice.random() < 0.25 and len(points) > 2 else ""
        cards += f"$CRACK NAME={name}{smooth}\n" + "".join(f"  {p:.17g}  {q:.17g}\n" for p, q in points)
    return cards


def any_crack(program, full):
    """Random cracks in three hosts and with both joins: one answer, or the same refusal."""
    dice = random.Random(2026)
    rows = []
    for number in range(60 if full else 2):
        cards = random_cracks(dice)
        names = re.findall(r"CRACK NAME=(\w)", cards)
        tied = "".join(f"$TIPNET CRACK={name} JOIN=TRANSITION\n" for name in names)
        runs = [Run(program, PLATE_DECK + cards + more + "$END\n", [f"n={n}"])
                for n, more in ((10, ""), (17, ""), (7, tied))]
        case = f"set {number + 1}, {len(names)} crack{'s' if len(names) > 1 else ''}"
        if any(run.code != 0 for run in runs):
            said = {run.refusal().split()[0] for run in runs}
            rows.append(Row("ANY", f"{case}: the same in all nets", runs[0],
                            ok=said in ({"E423"}, {"E425"}, {"E430"})))
            continue
        first, *others = ({row["crack"]: (float(row["K1"]), float(row["K2"])) for row in numbers(run.out / "k.csv")}
                          for run in runs)
        error = max(math.hypot(first[tip][0] - other[tip][0], first[tip][1] - other[tip][1]) / math.hypot(*first[tip])
                    for other in others for tip in first)
        rows.append(Row("ANY", f"{case}: spread of K over three nets and both joins", runs[0], number=error,
                        reference=0.0, allowed=3e-3, error=error))
    return rows
