# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of crack faces that close, and of friction with a history."""
import numpy as np

import pictures as pic
from answers import Given, answer
from naive_open_faces import passing
from naive_total_friction import partial_slip, strips
from plane import Material
from scene import Row, Scene, Table

UNIT = np.sqrt(np.pi)


def corner_supports(mesh):
    """The middles of two opposite sides, as the decks hold them."""
    x, y = mesh.x.T
    left = np.flatnonzero((np.abs(x - x.min()) < 1e-6) & (np.abs(y) < 1e-6))
    right = np.flatnonzero((np.abs(x - x.max()) < 1e-6) & (np.abs(y) < 1e-6))
    return np.r_[2 * left, 2 * left + 1, 2 * right + 1]


def faces(mesh, u, scale):
    """Deformed faces of a crack on y = 0: two lists of points, upper and lower."""
    edges = mesh.edges()
    x, y = mesh.x.T
    on = (np.abs(y) < 1e-9) & (np.abs(x) < 1.0 + 1e-9)
    side = edges[on[edges[:, 0]] & on[edges[:, 1]]]
    found = []
    for sign in (1, -1):  # the body is on the left of a side: upper faces run along +x
        some = side[np.sign(x[side[:, 1]] - x[side[:, 0]]) == sign]
        nodes = np.unique(some[some >= 0])
        nodes = nodes[np.argsort(x[nodes])]
        found.append([(x[n], scale * u[2 * n + 1]) for n in nodes])
    return found


def bent(program):
    """F11: a crack in a plate under bending, faces that overlap on one side."""
    material, rows = Material(1e5, 0.3, True), []
    run = answer(program, "bent_crack_faces", "r=0")
    mesh = Given(run, [material]).mesh
    tips = (((-1.0, 0.0), (-1.0, 0.0)), ((1.0, 0.0), (1.0, 0.0)))
    u, K = passing(mesh, lambda x, n: (0.0, n[1] * x[0]) if abs(n[1]) > 0.5 else (0.0, 0.0), corner_supports, tips,
                   (0.2, 0.7))
    exact = (2 / 3) ** 1.5
    rows.append(Row("naive", "faces free, tip in tension: F", f"{K[1][0] / UNIT:.4f}", K[1][0] / UNIT / exact - 1,
                    measured=1 / 1.089 - 1))
    rows.append(Row("naive", "faces free, tip in compression: F", f"{K[0][0] / UNIT:.4f}", K[0][0] / UNIT, unit="of s",
                    measured=-0.5, note="below zero: no answer, nobody says so"))
    for tip, true, name in (("C.2", exact, "tension"), ("C.1", 0.0, "compression")):
        found = run.K("BENT", tip) / UNIT
        error = found / true - 1 if true else found
        rows.append(Row("spricka", f"spricka, {run.name}, tip in {name}", f"{found:.4f}", error, allowed=5e-3,
                        unit="%" if true else "of s"))
    sweep, naive, ours, true = (0.5, 0.25, 0.0, -0.25, -0.5, -0.75), [], [], []
    for r in sweep:
        naive.append((r, 0.5 + r))
        ours.append((r, answer(program, "bent_crack_faces", f"r={r:g}").K("BENT", "C.2") / UNIT))
        true.append((r, (2 * (1 + r) / 3) ** 1.5))
    upper, lower = faces(mesh, u, 2e4)
    return rows, [
        pic.Sketch("The naive solution's faces, enlarged",
                   [(pic.NAIVE, 1.8, upper), (pic.OURS, 1.8, lower)],
                   [(pic.NAIVE, "upper face"), (pic.OURS, "lower face: above the upper one on the left")]),
        pic.Chart("F of the tip in tension over the even part of the stress", "r of the stress x/a + r", "F",
                  [pic.Curve("naive: 0.5 + r", naive, pic.NAIVE), pic.Curve("exact", true, pic.TRUE, dashed=True),
                   pic.Curve("spricka", ours, pic.OURS, line=False)])]


def pressed(program):
    """F10: a slanting crack pressed shut."""
    material, rows = Material(1000.0, 0.3), []
    run = answer(program, "pressed_crack", "mu=0.3")
    mesh = Given(run, [material]).mesh
    c = np.sqrt(0.5)
    u, K = passing(mesh, lambda x, n: (0.0, -n[1]), corner_supports,
                   (((-c, -c), (-c, -c)), ((c, c), (c, c))), (0.2, 0.7))
    exact = 0.35 * UNIT
    rows.append(Row("naive", "faces free: K1", f"{K[1][0]:.4f}", K[1][0] / UNIT, unit="of s sqrt(pi a)", measured=-0.5))
    rows.append(Row("naive", "faces free: K2", f"{abs(K[1][1]):.4f}", abs(K[1][1]) / exact - 1, measured=0.43))
    row = run.k_row("PUSH", "C.2")
    rows.append(Row("spricka", f"spricka, {run.name}, mu=0.3: K1", f"{float(row['K1']):.4f}", float(row["K1"]) / UNIT,
                    unit="of s sqrt(pi a)", allowed=1e-6))
    rows.append(Row("spricka", f"spricka, {run.name}, mu=0.3: K2", f"{abs(float(row['K2'])):.4f}",
                    abs(float(row["K2"])) / exact - 1, allowed=5e-3))
    return rows


def open_faces(program):
    rows, drawings = bent(program)
    return Scene(
        "open_faces",
        [Table("A crack of half length 1 under bending, stress x/a, F = K1 / (s sqrt(pi a)): exactly (2/3)^1.5 = "
               "0.5443 and 0 (benchmark F11):", rows),
         Table("A crack at 45 degrees under compression, friction 0.3: exactly K1 = 0, K2 = 0.35 s sqrt(pi a) "
               "(benchmark F10):", pressed(program))],
        drawings, "S05, F10, F11")


def locked_in(x):
    """Shear over mu p0 at x/a after Q = mu P / 2 has come and gone (Mindlin and Deresiewicz 1953)."""
    def arc(c):
        return c * np.sqrt(np.maximum(0.0, 1.0 - (x / c) ** 2))

    return arc(1.0) - arc(np.sqrt(0.5)) - 2.0 * (arc(1.0) - arc(np.sqrt(0.75)))


def friction_history(program):
    """S04, C10."""
    n, mu = 200, 0.5
    x, h, A = strips(1.0, n)
    p = np.sqrt(1 - x ** 2)
    Q = 0.5 * mu * h * p.sum()
    first = partial_slip(A, h, mu * p, Q) / mu
    back = first - partial_slip(A, h, 2 * mu * p, Q) / mu
    total = partial_slip(A, h, mu * p, 0.0) / mu
    exact = (1 - np.sqrt(0.5)) - 2 * (1 - np.sqrt(0.75))
    peak = np.abs(back).max()
    run = answer(program, "cattaneo")
    a = 0.23489

    def shear(step):
        half = 2 * 500.0 / (np.pi * a)
        return sorted((float(r["x"]) / a, -float(r["q_lumped"]) / (mu * half)) for r in run.pressures("C", step)
                      if abs(float(r["x"])) < 1.1 * a)

    ours = shear("BACK")
    law = locked_in(np.array([v for v, _ in ours]))
    far = np.sqrt(np.mean((np.array([q for _, q in ours]) - law) ** 2))
    middle = min(ours, key=lambda v: abs(v[0]))[1]
    rows = [Row("naive", "all in one go, largest shear when the push is gone", f"{np.abs(total).max():.3f}",
                np.abs(total).max() / peak - 1, measured=-1.0),
            Row("other", "step by step, the same strips", f"{peak:.3f}"),
            Row("spricka", f"spricka, {run.name}, all along, root mean square from the closed form", f"{far:.4f}", far,
                unit="of mu p0", allowed=0.02, said=run.said()),
            Row("spricka", f"spricka, {run.name}, in the middle, exactly {exact:.4f}", f"{middle:.4f}", middle - exact,
                unit="of mu p0", allowed=0.01)]
    return Scene(
        "friction_history",
        [Table("Two cylinders pressed together, pushed aside by half of what would make them slide, and let go; "
               "shear over mu p0 (Cattaneo; Mindlin and Deresiewicz; benchmark C10):", rows)],
        [pic.Chart("Shear along the contact, push gone", "x / a", "q / (mu p0)",
                   [pic.Curve("naive: in one go", list(zip(x, total)), pic.NAIVE, marks=False),
                    pic.Curve("step by step", list(zip(x, back)), pic.TRUE, marks=False, dashed=True),
                    pic.Curve("spricka", ours, pic.OURS, line=False)])], "S04, C10")


SCENES = {"open_faces": open_faces, "friction_history": friction_history}
