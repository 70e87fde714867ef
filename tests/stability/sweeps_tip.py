# SPDX-License-Identifier: GPL-3.0-or-later
"""Tip meshes of an edge crack, and the square lug with its two cracks."""
import math
import re

from cracked_meshes import Grid, deck
from program import Row, Run, changed, text_of, without_checks
from sweeps_crack import SENT_HALF, STRIP, refused, row_of, stress_intensities


def tip_mesh(program, full):
    """S12: fans, rings and middle nodes of the tip elements."""
    f, a = SENT_HALF, 0.5
    rows = []
    for sectors, allowed in ((4, None), (6, 2e-2), (8, 3e-3), (12, 3e-3), (16, 3e-3), (24, 1e-3), (48, 1e-3)):
        run = Run(program, deck(Grid(STRIP, 12, 48), [(0.0, 0.0), (0.5, 0.0)], tipnet=f"$TIPNET CRACK=C SECTORS={sectors}"))
        case = f"F01, fan of {sectors} elements"
        rows.append(refused("S12", case, run, "SECTORS") if allowed is None else row_of("S12", case, run, f, a, allowed))
    for rings in (2, 3, 5, 10) if full else (2,):
        run = Run(program, deck(Grid(STRIP, 12, 48), [(0.0, 0.0), (0.5, 0.0)], tipnet=f"$TIPNET CRACK=C RINGS={rings}"))
        rows.append(row_of("S12", f"F01, {rings} rings", run, f, a, 3e-3))
    run = Run(program, deck(Grid(STRIP, 12, 48), [(0.0, 0.0), (0.5, 0.0)], tipnet="$TIPNET CRACK=C QUARTER=NO"))
    rows.append(row_of("S12", "F01, middle nodes in the middle, 5 rings", run, f, a, 1e-2))
    return rows + middle_nodes(program, full)


def own_tip(quarter, shift):
    """F01 in the deck's own rectangles, PATCH=NO: middle nodes at the tip at 0.25 + shift of their edges."""
    text = deck(Grid(STRIP, 20, 80), [(0.0, 0.0), (0.5, 0.0)],
                tipnet=f"$TIPNET CRACK=C PATCH=NO QUARTER={quarter} RINGS=4")
    text = re.sub(r"\$CRACK NAME=C\n.*\n.*\n", "$NSET NAME=LINE WHERE=(abs(y) < 1e-9) ORDER=(x)\n"
                  "$CRACK NAME=C PATH=LINE A0=0.5\n", text)

    def move(line):
        label, x, y = line.group(1), float(line.group(2)) - 0.5, float(line.group(3))
        if abs(math.hypot(x, y) - 0.025) < 1e-9 and min(abs(x), abs(y)) < 1e-12:
            x, y = (v * (0.25 + shift) / 0.5 for v in (x, y))
        return f"  {label}  {0.5 + x:.17g}  {y:.17g}\n"

    nodes, rest = text.split("$ELEMENT", 1)
    return re.sub(r"  (\d+)  (\S+)  (\S+)\n", move, nodes) + "$ELEMENT" + rest


def middle_nodes(program, full):
    """Small shifts hardly matter, larger ones are told or put right, folded elements refused."""
    plain = stress_intensities(Run(program, own_tip("NO", 0.0)))["C"][0]
    rows = []
    for shift in (0.001, -0.001, 0.01, -0.01, 0.05, -0.05, 0.1) if full else (0.01, -0.05):
        run = Run(program, own_tip("NO", shift))
        k1 = stress_intensities(run)["C"][0] if run.code == 0 else None
        case = f"F01, rectangles of the deck, middle nodes at {0.25 + shift:g}, K1 over that at a quarter"
        if abs(shift) <= 0.01:
            rows.append(Row("S12", case, run, number=k1 / plain, reference=1.0, allowed=5e-3))
        else:
            rows.append(Row("S12", f"{case}: told", run, number=k1 and k1 / plain, reference=1.0, allowed=2e-2,
                            ok="W505" in run.messages and abs(k1 / plain - 1.0) < 2e-2))
    run = Run(program, own_tip("YES", 0.05))
    rows.append(Row("S12", "F01, middle nodes at 0.3, QUARTER=YES puts them right", run,
                    number=stress_intensities(run)["C"][0] / plain, reference=1.0, allowed=1e-12))
    rows.append(refused("S12", "F01, middle nodes at 0.15", Run(program, own_tip("NO", -0.1)), "Jacobian"))
    run = Run(program, own_tip("YES", -0.1))
    if run.code == 0:  # put right before anything is made of it, or refused as read
        rows.append(Row("S12", "F01, middle nodes at 0.15, QUARTER=YES", run,
                        number=stress_intensities(run)["C"][0] / plain, reference=1.0, allowed=1e-12))
    else:
        rows.append(refused("S12", "F01, middle nodes at 0.15, QUARTER=YES", run, "Jacobian"))
    return rows


def mean_pressure(run, contact, increment, first, last):
    """Mean of the pressure over an arc, degrees, by the trapezoidal rule on its own points."""
    points = sorted((float(row["theta"]) % 360.0, float(row["p_lumped"])) for row in run.pressures(contact, "LOAD")
                    if row["increment"] == str(increment))
    points = [(t - 360.0, p) for t, p in points[-3:]] + points  # round the circle
    area = 0.0
    for (t, p), (u, q) in zip(points, points[1:]):
        low, high = max(t, first), min(u, last)
        if low < high:
            at = [p + (q - p) * (x - t) / (u - t) for x in (low, high)]
            area += 0.5 * (at[0] + at[1]) * (high - low)
    return area / (last - first)


def square_lug(program, full):
    """X01: means over arcs counted from +x, the load at 90 degrees."""
    text = without_checks(text_of("square_lug"))
    whole = re.sub(r"^\$(CRACK|GROW).*?(?=^\$)", "", text, flags=re.M | re.S)
    rows = []
    for case, deck_text, increment, means in (("a = 0", whole, 1, (89.08, 95.3, 114.217)),
                                              ("a = 10.8", text, 2, (99.62, 95.14, 114.255)))[:2 if full else 1]:
        run = Run(program, deck_text, ["fine=2"])
        for (contact, first, last), mean in zip((("BUSH", 0, 30), ("BUSH", 60, 120), ("PINS", 60, 120)), means):
            found = mean_pressure(run, contact, increment, first, last) if run.code == 0 else None
            rows.append(Row("X01", f"{case}: mean pressure of {contact}, {first} to {last} deg", run, number=found,
                            reference=mean, allowed=3e-3))
    run = Run(program, changed(whole, ("$END", "$CHECK\n  ARC.FROM(BUSH,LOAD) = 0 ABS 1e9\n  CPRESS.MAX(PINS,LOAD) = 0 "
                                       "ABS 1e9\n$END")))
    separated = 180.0 + 2.0 * run.asked("ARC.FROM") * (180.0 / math.pi if abs(run.asked("ARC.FROM")) < 3.2 else 1.0)
    rows.append(Row("X01", "a = 0: separation of lug and sleeve, degrees", run, number=separated, reference=144.0,
                    allowed=1e-2))
    rows.append(Row("X01", "a = 0: largest pressure on the shaft", run, number=run.asked("CPRESS.MAX"),
                    reference=124.85, allowed=1e-2))
    return rows
