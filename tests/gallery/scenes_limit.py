# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes at which spricka is at a limit itself, and has to say so."""
import numpy as np

import pictures as pic
from answers import answer
from naive_largest_stress import largest
from scene import Row, Scene, Table


def lip(program):
    """C09: a pressure without bound."""
    rows, tops, middles = [], [], []
    exact = 1 / (np.pi * 1.01)
    for h in (0.16, 0.08, 0.04, 0.02):
        run = answer(program, "flat_punch", f"h={h:g}")
        p = run.column("PUNCH", "PRESS")
        x = [abs(float(r["x"])) for r in run.pressures("PUNCH", "PRESS")]
        top, middle = largest(p), p[int(np.argmin(x))]
        tops.append((h, top / exact))
        middles.append((h, middle / exact))
    for h, top in tops:
        rows.append(Row("naive", f"largest pressure, elements of {h:g}", f"{top:.3g} times that in the middle",
                        top / tops[0][1] - 1 if h < 0.16 else None, at_least=0.1 if h < 0.16 else None))
    run = answer(program, "flat_punch")
    note = next((n for n in run.notes() if "no bound" in n), "")
    rows.append(Row("spricka", f"spricka, {run.name}: the largest pressure", f"{dict(tops)[0.04]:.3g} times", said=note,
                    allowed=0.0))
    rows.append(Row("spricka", f"spricka, {run.name}: in the middle", f"{dict(middles)[0.04]:.5f} of the exact",
                    dict(middles)[0.04] - 1, allowed=5e-3))
    return Scene(
        "limit_lip",
        [Table("A rigid flat punch on a half plane; exactly P / (pi b) in the middle, without bound at the ends "
               "(benchmark C09); error: growth against the coarsest mesh:", rows)],
        [pic.Chart("Largest pressure over that in the middle", "element at the edge / b", "times",
                   [pic.Curve("largest pressure", tops, pic.NAIVE), pic.Curve("in the middle", middles, pic.OURS)],
                   log_x=True)], "C09, X01")


def solid_friction(program):
    """Mindlin's problem between solids whose meshes do not match."""
    run = answer(program, "mindlin_solid")
    R, f, nu = 200.0, 0.3, 0.3
    P, E_star = 20000.0 / R, 210000.0 / (2 * (1 - nu ** 2))
    a = (3 * P * R / (4 * E_star)) ** (1 / 3)
    c, p0 = a * 0.5 ** (1 / 3), 3 * P / (2 * np.pi * a * a)
    table = {step: np.array([[np.hypot(float(r["x"]), float(r["y"])) / a, float(r["q_lumped"]) / (f * p0),
                              abs(float(r["q_x"])) / (f * p0)] for r in run.pressures("MINDLIN", step)])
             for step in ("PRESS", "PUSH")}

    def exact(x):
        return np.sqrt(np.maximum(0, 1 - x ** 2)) - c / a * np.sqrt(np.maximum(0, 1 - (x * a / c) ** 2))

    inside = table["PUSH"][table["PUSH"][:, 0] < 1.05]
    law = exact(inside[:, 0])
    off = np.sqrt(np.mean((inside[:, 2] - law) ** 2) / np.mean(law ** 2))
    press = table["PRESS"][:, 1].max()
    rows = [Row("spricka", f"spricka, {run.name}: largest shear after pressing, exactly 0", f"{press:.3f}", press,
                unit="of mu p0", said=run.said(), limit=True),
            Row("spricka", "shear after the push against Mindlin, root mean square", "", off, said=run.said(),
                limit=True)]
    x = np.linspace(0, 1, 60)
    return Scene(
        "limit_solid_friction",
        [Table("A sphere pressed on a half space and pushed aside by half of what would make it slide, meshes that "
               "do not match, 5 elements over the contact radius:", rows)],
        [pic.Chart("Shear after the push", "r / a", "q / (mu p0)",
                   [pic.Curve("exact (Mindlin)", list(zip(x, exact(x))), pic.TRUE, marks=False),
                    pic.Curve("spricka", sorted(zip(inside[:, 0], inside[:, 2])), pic.OURS, line=False)]),
         pic.Chart("Shear after pressing: exactly none", "r / a", "q / (mu p0)",
                   [pic.Curve("spricka", sorted((r, q) for r, q, _ in table["PRESS"] if r < 1.05), pic.OURS,
                              line=False)])], "C10 in space")


SCENES = {"limit_lip": lip, "limit_solid_friction": solid_friction}
