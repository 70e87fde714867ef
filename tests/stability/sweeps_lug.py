# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes, mirrors, turns, sizes and units of the lug and of a pin in its plate."""
import math
import random

from program import DECKS, Row, Run, changed, difference, text_of, without_checks

REFERENCE = 664.467  # lug_reference: two independent 2D solvers


def pairings(program, full):
    """Sleeves and shafts of any meshes, turned by angles down to 1e-12: K1 does not feel them."""
    text = text_of("lug_pairing")
    dice = random.Random(2026)
    rows, first = [], None
    for number in range(200 if full else 5):
        n1, n2 = dice.randint(227, 300), dice.randint(189, 300)
        if number % 4 == 1:
            n2 = n1  # nodes that all but match
        turns = [dice.choice((-1.0, 1.0)) * 10.0 ** dice.uniform(-12.0, -1.5) for _ in range(2)]
        run = Run(program, text, [f"n1={n1}", f"n2={n2}", f"sleeve={turns[0]:.17g}", f"shaft={turns[1]:.17g}"])
        case = f"{n1} and {n2} elements, turned by {turns[0]:.1e} and {turns[1]:.1e}"
        if run.code != 0:
            rows.append(Row("LUG", case, run, ok=False))
            continue
        k = run.stress_intensity()
        first = first or k
        for tip in ("TOP", "BOT"):
            found = k["LOAD", tip]
            rows.append(Row("LUG", f"{case}, {tip}", run, number=found, reference=first["LOAD", tip],
                            allowed=2e-4))
    return worst(rows) if full else rows


def worst(rows, size=40):
    """Of each `size` rows the one with the largest error, and all that are wrong."""
    kept = [row for row in rows if not row.ok]
    for first in range(0, len(rows), size):
        part = [row for row in rows[first:first + size] if row.ok]
        if part:
            row = max(part, key=lambda r: r.error)
            row.case = f"worst of {len(part) // 2}: {row.case}"
            kept.append(row)
    return kept


def directions(program, _full):
    """A load and its mirror image find the same K1 on the mirrored crack."""
    run = Run(program, without_checks(text_of("lug_load_directions")))
    k = run.stress_intensity()
    rows = []
    for step, other in (("P0", "P0"), ("P45", "M45"), ("M45", "P45"), ("P90", "M90"), ("M90", "P90"),
                        ("P180", "P180")):
        rows.append(Row("LUG", f"{step} at TOP, {other} at BOT", run, number=k[step, "TOP"],
                        reference=k[other, "BOT"], allowed=2e-4))
    rows.append(Row("LUG", "P0 again after all directions", run, number=k["AGAIN", "TOP"],
                    reference=k["P0", "TOP"], allowed=1e-10))
    return rows + [closing(program)]


CLOSING = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Crack that closes'
$INCLUDE FILE='lug_model.inc'
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE     GAP=0
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER GAP=0
$STEP NAME=LOAD
  LOAD SHAFTLOAD 1
$CRACK NAME=BACK NET=LUG A0=(0.3*R) ANGLE=180[deg] STATE=STRESS
  (-R)  0
$END
"""


def closing(program):
    """A crack behind the shaft, where the pull of the load closes it at its tip."""
    run = Run(program, CLOSING)
    k = run.stress_intensity().get(("LOAD", "BACK")) if run.code == 0 else None
    return Row("LUG", "crack that the load closes: K1", run, number=k, reference=0.0, allowed=1e-12, error=k)


PIN = """$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Pin in plate, turned'
$PARAMETER
  turn = 0
  aside = 0.3
$NET NAME=PLATE
  $MESH SHAPE=RING TYPE=QUAMC8 RI=1 RO=10 NR=10 NT=60 T0=(turn) T1=(turn + 2*pi) BIAS=8
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=1 NR=6 NT=64 T0=(turn) T1=(turn + 2*pi)
$ENDNET
$MATERIAL NAME=UNIT E=1 NU=0.3
$PROPERTY ESET=PIN.BODY   MATERIAL=UNIT STATE=STRESS
$PROPERTY ESET=PLATE.BODY MATERIAL=UNIT STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  PLATE.OUTER
$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=PLATE.INNER GAP=0.1
$LOAD CASE=Q TYPE=RESULTANT
  PIN.BODY  (cos(turn + aside))  (sin(turn + aside))
$STEP NAME=LOAD
  LOAD Q 1
$END
"""


def turned(program, full):
    """A turned mesh has the same pressures, a mirrored load the mirrored ones."""
    plain = Run(program, PIN).column("FIT", "LOAD")
    rows = []
    for turn in (0.1, 1.0, 2.5, -0.7) if full else (1.0,):
        run = Run(program, PIN, [f"turn={turn}"])
        error = difference(run.column("FIT", "LOAD"), plain)
        rows.append(Row("LUG", f"pin turned by {turn} rad", run, number=error, reference=0.0, allowed=1e-9,
                        error=error))
    run = Run(program, PIN, ["aside=-0.3"])
    mirrored = run.column("FIT", "LOAD")
    error = difference([mirrored[0]] + mirrored[:0:-1], plain)
    rows.append(Row("LUG", "pin, load mirrored", run, number=error, reference=0.0, allowed=1e-9, error=error))
    return rows + turned_lug(program, full)


def turned_lug(program, full):
    """The whole lug turned, with a new mesh and new patches."""
    text = text_of("lug_pairing")
    geo = (DECKS / "lug.geo").read_text(encoding="utf-8")
    rows = []
    for turn in (0.3, math.pi / 2.0, 2.2) if full else (0.3,):
        spun = changed(geo, ("Curve Loop(1) =", f"Rotate {{ {{0, 0, 1}}, {{0, 0, 0}}, {turn:.17g} }} "
                             "{ Point{1:6}; Point{10:15}; }\nCurve Loop(1) ="))
        c, s = math.cos(turn), math.sin(turn)
        deck = changed(text, ("SHAFT.BODY  (F)  0", f"SHAFT.BODY  (F*{c:.17g})  (F*({s:.17g}))"),
                       ("ANGLE=90[deg] STATE=STRESS\n  0  (R)",
                        f"ANGLE={math.pi / 2 + turn:.17g} STATE=STRESS\n  (-R*({s:.17g}))  (R*({c:.17g}))"),
                       ("ANGLE=-90[deg] STATE=STRESS\n  0  (-R)",
                        f"ANGLE={turn - math.pi / 2:.17g} STATE=STRESS\n  (R*({s:.17g}))  (-R*({c:.17g}))"))
        run = Run(program, deck, files={"lug.geo": spun})
        for tip in ("TOP", "BOT"):
            found = run.stress_intensity()["LOAD", tip] if run.code == 0 else None
            rows.append(Row("LUG", f"lug turned by {turn:.3g} rad, {tip}", run, number=found,
                            reference=REFERENCE, allowed=2e-4))
    return rows


def scaled(program, full):
    """Lugs and pins of other sizes: K1 grows with the root of it, pressures stay."""
    return (scaled_lug(program) if full else []) + scaled_pin(program, full)


def scaled_lug(program):
    """A lug of another size has another mesh of gmsh's; the rest is the same."""
    text = text_of("lug_pairing")
    plain = Run(program, text).stress_intensity()["LOAD", "TOP"]
    rows = []
    for s in (1e-6, 1e-3, 1e3, 1e6):
        deck = changed(text, ("DIAMETRAL=0.084", f"DIAMETRAL={0.084 * s:.17g}"))
        sizes = [f"{name}={value * s:.17g}" for name, value in
                 (("D", 72.0), ("d0", 60.0), ("e", 86.5), ("L0", 232.5), ("h", 14.0))]
        run = Run(program, deck, sizes + [f"fine={1.0 / s:.17g}", f"F={97100.0 * s * s:.17g}"])
        found = run.stress_intensity()["LOAD", "TOP"] / math.sqrt(s) if run.code == 0 else None
        rows.append(Row("LUG", f"lug {s:g} as large, K1 over the root of that", run, number=found,
                        reference=plain, allowed=2e-4))
    return rows


def scaled_pin(program, full):
    """The same mesh in another size: the same pressures."""
    rows = []
    pin = Run(program, PIN).column("FIT", "LOAD")
    for s in (1e-6, 1e-3, 1e3, 1e6) if full else (1e6,):
        deck = changed(PIN, ("RI=1 RO=10", f"RI={s:g} RO={10.0 * s:g}"), ("RI=0 RO=1 ", f"RI=0 RO={s:g} "),
                       ("GAP=0.1", f"GAP={0.1 * s:g}"), ("STATE=STRESS", f"STATE=STRESS THICK={s:g}"),
                       ("(cos(", f"({s * s:g}*cos("), ("(sin(", f"({s * s:g}*sin("))
        run = Run(program, deck)
        error = difference(run.column("FIT", "LOAD"), pin) if run.code == 0 else None
        rows.append(Row("LUG", f"pin {s:g} as large", run, number=error, reference=0.0, allowed=1e-10,
                        error=error))
    return rows


def lug(program, full):
    """All of them."""
    return (pairings(program, full) + directions(program, full) + turned(program, full) +
            scaled(program, full))
