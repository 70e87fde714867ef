# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes at the paper's lug that take load, fit, pressure and life apart."""
import numpy as np

import pictures as pic
from answers import answer
from lug import DOUBLE, SINGLE, A, F, R, lug_of
from naive_assumed_pressure import cosine, uniform
from naive_one_beta import one_beta, paris_life
from naive_superposition import superposed
from naive_uncracked_stress import edge_crack
from plane import nodal_stress
from scene import Row, Scene, Table
from scenes_tip import ours

WHEN = {"PRESS": "after the press fit", "LOAD": "under load"}
LENGTHS = tuple(x * R for x in (0.05, 0.1, 0.2, 0.3, 0.5, 0.8))


def superposition(program):
    lug = lug_of(program, "lug_double_literal", 4)
    load, fit, total = superposed(lug, A)
    both = lug.K1(lug.state()[0], A)[0]
    true = DOUBLE["LOAD"]
    run = answer(program, "lug_double_literal")
    rows = [Row("naive", "load without the fit", f"{load:.4g}", load / true - 1, measured=0.14),
            Row("naive", "and the fit without the load added", f"{total:.4g}", total / true - 1, measured=0.49),
            Row("other", "both in one solution, the same mesh", f"{both:.4g}", both / true - 1, allowed=2e-3),
            ours(run, "LOAD", "TOP", A, true, 1e-3)]
    parts = np.linspace(0, 1, 11)
    K = [lug.K1(lug.state(t)[0], A)[0] for t in parts]
    alone = [lug.K1(lug.state(t, 0.0)[0], A)[0] for t in parts[1:]]
    curves = [pic.Curve("naive: load alone plus fit alone", list(zip(parts, [fit] + [fit + k for k in alone])),
                        pic.NAIVE),
              pic.Curve("naive: load alone", list(zip(parts, [0.0] + alone)), pic.OTHERS[1]),
              pic.Curve("both at once", list(zip(parts, K)), pic.FAIR),
              pic.Curve("spricka", [(0.0, run.K("PRESS", "TOP", A)), (1.0, run.K("LOAD", "TOP", A))], pic.OURS,
                        line=False)]
    return Scene(
        "superposition",
        [Table(f"The paper's lug, two cracks of a/R = 0.3, K1 (two independent solvers: {true}):", rows)],
        [pic.Chart("K1 over the load", "load / full load", "K1, MPa mm^0.5", curves)], "X01")


def assumed_pressure(program):
    lug = lug_of(program, "lug_double_literal", 4)
    true, nofit = DOUBLE["LOAD"], DOUBLE["NO FIT"]
    found = {name: lug.K1(lug.lug_alone(law(F, R)), A)[0] for name, law in (("cosine", cosine), ("uniform", uniform))}
    contact, force = lug.state()
    free, free_force = lug.state(1.0, 0.0)
    none = lug.K1(free, A)[0]
    run, other = answer(program, "lug_double_literal"), answer(program, "lug_no_interference")
    rows = [Row("naive", "cosine pressure, against the joint with its fit", f"{found['cosine']:.4g}",
                found["cosine"] / true - 1, measured=0.45),
            Row("naive", "cosine pressure, against a joint without fit", f"{found['cosine']:.4g}",
                found["cosine"] / nofit - 1, measured=(0.19, 0.28)),
            Row("naive", "uniform pressure, against the joint with its fit", f"{found['uniform']:.4g}",
                found["uniform"] / true - 1, at_least=0.05),
            Row("naive", "fit forgotten, contact right", f"{none:.4g}", none / true - 1, measured=0.14),
            ours(run, "LOAD", "TOP", A, true, 1e-3),
            ours(other, "LOAD", "TOP", A, nofit, 1e-3)]
    theta = np.degrees(np.arctan2(*lug.mesh.x[lug.walls].T[::-1]))
    order = np.argsort(theta)

    def along(forces):
        p = (forces[lug.bush] / lug.area[lug.bush])[order]
        return [(t, v) for t, v in zip(theta[order], p) if 0 <= t <= 180 and abs(t - 90) > 2]

    at = np.linspace(0, 180, 61)
    curves = [pic.Curve("naive: cosine", [(t, cosine(F, R)(np.radians(t))) for t in at], pic.NAIVE, marks=False),
              pic.Curve("naive: uniform", [(t, uniform(F, R)(np.radians(t))) for t in at], pic.OTHERS[1], marks=False),
              pic.Curve("contact with the fit", along(force), pic.FAIR, marks=False),
              pic.Curve("contact without a fit", along(free_force), pic.TRUE, marks=False, dashed=True)]
    return Scene(
        "assumed_pressure",
        [Table(f"The paper's lug, two cracks of a/R = 0.3, K1 ({true} with the fit, {nofit} without):", rows)],
        [pic.Chart("Pressure on the bore (2 degrees at the crack left out)", "degrees from the load", "MPa",
                   curves)], "X01, paper's Fig. 1")


def life(program):
    C, m = 1e-13, 3.0
    run = answer(program, "lug_single_literal")
    K = {step: [run.K(step, "TOP", a) for a in LENGTHS] for step in ("LOAD", "UNLOAD")}
    naive = one_beta(LENGTHS, K["LOAD"], C, m)
    swing = [a - b for a, b in zip(K["LOAD"], K["UNLOAD"])]
    right = paris_life(LENGTHS, swing, C, m)
    grown = answer(program, "lug_life")
    found = float(grown.results().table("checks")["found"][0])
    rows = [Row("naive", "K from 0 to that of full load (one beta)", f"{naive:.0f} cycles", naive / right - 1,
                measured=1 / 4.03 - 1),
            Row("naive", "its swing of K at a/R = 0.3", f"{K['LOAD'][3]:.4g}", K["LOAD"][3] / swing[3] - 1,
                measured=0.53),
            Row("other", "K between both loads, the six lengths by hand", f"{right:.0f} cycles"),
            Row("spricka", f"spricka, {grown.name}", f"{found:.0f} cycles", found / right - 1, allowed=0.02,
                said=grown.said())]
    x = [a / R for a in LENGTHS]
    cycles = [(0.0, x[0])] + [(one_beta(LENGTHS[:i + 1], K["LOAD"][:i + 1], C, m) / 1e6, x[i]) for i in range(1,
                                                                                                              len(x))]
    file = grown.results().file
    curve = list(zip(file["growth.curve"]["cycles"][::6] / 1e6, file["growth.curve.a"][::6] / R))
    return Scene(
        "one_beta",
        [Table("The paper's lug, one crack from a/R = 0.05 to 0.8, load between zero and full, da/dN = 1e-13 dK^3 "
               "(mm, MPa mm^0.5):", rows)],
        [pic.Chart("Growth", "million cycles", "a / R", [pic.Curve("naive: one beta", cycles, pic.NAIVE),
                                                         pic.Curve("spricka", curve, pic.OURS, marks=False)]),
         pic.Chart("K over the length", "a / R", "K1, MPa mm^0.5",
                   [pic.Curve("full load", list(zip(x, K["LOAD"])), pic.OURS),
                    pic.Curve("unloaded: the fit alone", list(zip(x, K["UNLOAD"])), pic.TRUE)])], "X01, G01")


def uncracked_stress(program):
    lug = lug_of(program, "lug_uncracked")
    nodes = np.flatnonzero((np.abs(lug.mesh.x[:, 0]) < 6) & (np.abs(lug.mesh.x[:, 1] - R - A) < 5) & (lug.owner == 0))
    found = {}
    for name, load in (("PRESS", 0.0), ("LOAD", 1.0)):
        stress = nodal_stress(lug.mesh, lug.state(load)[0])[nodes, 0]
        d = lug.mesh.x[nodes] - (0.0, R + A)  # a quadratic surface through the nodes near the place of the tip
        basis = np.stack([np.ones(len(d)), *d.T, d[:, 0] ** 2, d.prod(1), d[:, 1] ** 2], 1)
        found[name] = edge_crack(np.linalg.lstsq(basis, stress, rcond=None)[0][0], A)
    run, rows = answer(program, "lug_single_literal"), []
    for step, measured in (("PRESS", 0.055), ("LOAD", -0.029)):
        rows.append(Row("naive", f"1.12 s sqrt(pi a), {WHEN[step]}", f"{found[step]:.4g}",
                        found[step] / SINGLE[step] - 1,
                        measured=measured))
    true, swing = SINGLE["LOAD"] - SINGLE["PRESS"], found["LOAD"] - found["PRESS"]
    rows.append(Row("naive", "swing of K", f"{swing:.4g}", swing / true - 1, measured=-0.077))
    rows.append(Row("naive", "rate of growth, its cube", "", (swing / true) ** 3 - 1, measured=-0.21))
    rows += [ours(run, "PRESS", "TOP", A, SINGLE["PRESS"], 1e-3, f"spricka, {run.name}, after the press fit"),
             ours(run, "LOAD", "TOP", A, SINGLE["LOAD"], 1e-3, f"spricka, {run.name}, under load")]
    lengths = LENGTHS
    curve = [(a / R, run.K("LOAD", "TOP", a)) for a in lengths]
    naive = []
    for a in lengths:
        near = np.flatnonzero((np.abs(lug.mesh.x[:, 0]) < 6) & (np.abs(lug.mesh.x[:,
                                                                                  1] - R - a) < 5) & (lug.owner == 0))
        d = lug.mesh.x[near] - (0.0, R + a)
        basis = np.stack([np.ones(len(d)), *d.T, d[:, 0] ** 2, d.prod(1), d[:, 1] ** 2], 1)
        s = nodal_stress(lug.mesh, lug.state()[0])[near, 0]
        naive.append((a / R, edge_crack(np.linalg.lstsq(basis, s, rcond=None)[0][0], a)))
    return Scene(
        "uncracked_stress",
        [Table("The paper's lug, one crack of a/R = 0.3, K1 (two independent methods: 229.705 and 630.62):", rows)],
        [pic.Chart("K1 at full load", "a / R", "K1, MPa mm^0.5",
                   [pic.Curve("naive: stress of the uncracked lug", naive, pic.NAIVE),
                    pic.Curve("spricka", curve, pic.OURS)])], "X02")


SCENES = {"superposition": superposition, "assumed_pressure": assumed_pressure, "one_beta": life,
          "uncracked_stress": uncracked_stress}
