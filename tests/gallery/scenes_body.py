# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of round surfaces, of bodies that only contact holds, of pairs given twice, of tolerances with a unit."""
import numpy as np
import scipy.sparse as sparse

import pictures as pic
from answers import Given, answer, numbers
from blocks import radial, rings, stacked
from joint import Joint, consistent_matrix, contact_rows
from meshes import ring
from naive_averaged_normals import averaged_normals, spin
from naive_doubled_pair import multipliers
from naive_hertz_pin import hertz
from naive_huge_modulus import pressed_by_stiff
from naive_penalty import penalty
from naive_soft_springs import grounded
from plane import Material, body_load, stiffness
from scene import Row, Scene, Table


def uneven_ring(sides):
    """A ring whose sides differ by up to a tenth."""
    i = np.arange(sides + 1)
    angles = 2 * np.pi * i / sides
    angles[1:-1] += 0.05 * 2 * np.pi / sides * np.sin(12.9898 * i[1:-1] * (1 + 0.07 * i[1:-1]))
    return ring([30.0, 33.0, 36.0], angles, "Q8", Material(206000, 0.32))


def rim_of(mesh, radius):
    on = np.abs(np.hypot(*mesh.x.T) - radius) < 1e-6
    edges = mesh.edges()
    edges = edges[on[edges[:, 0]] & on[edges[:, 1]]]
    return np.unique(edges), edges


def loaded_shaft(program):
    """Torque of the deck's shaft, with averaged normals and as spricka has it, over F R."""
    run, R, F = answer(program, "uneven_shaft"), 36.0, 1000.0
    given = Given(run, [Material(206000, 0.32)] * 2)
    mesh, owner = given.mesh, np.zeros(len(given.mesh.x), int)
    for block in given.parts[1]:
        owner[block.nodes] = 1
    nodes, edges = rim_of(mesh, R)
    mine = edges[owner[edges[:, 0]] == 1]
    slaves = np.unique(mine)
    normals = averaged_normals(mesh, slaves, mine)
    G, _, used = contact_rows(mesh, slaves, normals, edges[owner[edges[:, 0]] == 0])
    x, y = mesh.x.T
    rim = np.flatnonzero((np.hypot(x, y) > 60 - 1e-6))
    ends = np.flatnonzero((np.abs(np.abs(x) - 20) < 1e-9) & (np.abs(y) < 1e-9))
    joint = Joint(stiffness(mesh), G, np.r_[2 * rim, 2 * rim + 1, 2 * ends + 1])
    _, force = joint.exact(body_load(mesh, given.parts[1], (F, 0.0)), np.full(len(used), -0.01))
    moment = (mesh.x[slaves[used], 0] * normals[used, 1] - mesh.x[slaves[used], 1] * normals[used, 0]) @ force
    values = {r["name"]: float(r["value"]) for r in numbers(run.out / "reaction.csv") if r["component"] == "Y"}
    ours = 20.0 * (values["SHAFT.EAST"] - values["SHAFT.WEST"])
    return abs(moment) / (F * R), abs(ours) / (F * R), run


def normals(program):
    rows, points = [], []
    for sides, measured in ((28, (0.004, 0.009)), (56, 0.002), (112, 0.001)):
        mesh = uneven_ring(sides)
        slaves, edges = rim_of(mesh, 36.0)
        found = spin(mesh.x[slaves], averaged_normals(mesh, slaves, edges))
        points.append((360 / sides, found))
        rows.append(Row("naive", f"averaged, {sides} sides that differ by a tenth", f"{found:.2e}", found, unit=" ",
                        measured=measured))
    slaves, edges = rim_of(uneven_ring(28), 36.0)
    rows.append(Row("other", "radial normals",
                    f"{spin(uneven_ring(28).x[slaves], radial(uneven_ring(28).x[slaves])):.1e}",
                    spin(uneven_ring(28).x[slaves], radial(uneven_ring(28).x[slaves])), unit=" ", allowed=1e-12))
    naive, ours, run = loaded_shaft(program)
    rows += [Row("naive", f"torque of the shaft of {run.name} over F R", f"{naive:.2e}", naive, unit=" ",
                 at_least=1e-5),
             Row("spricka", "spricka, the same", f"{ours:.1e}", ours, unit=" ", allowed=1e-7, said=run.said())]
    return Scene(
        "averaged_normals",
        [Table("How far a turn of the rim runs into the partner, over the same of a shift: 0 for a round shaft. It "
               "goes with how uneven the sides are:", rows)],
        [pic.Chart("Spin of a round shaft over the sides of its rim", "degrees per side", "|G turn| / |G shift|",
                   [pic.Curve("naive: averaged normals", points,
                              pic.NAIVE)], log_x=True, log_y=True)], "round surfaces")


def facets(program):
    """C02."""
    rows, gaps = [], []
    for inner, outer in ((8, 13), (16, 26), (32, 52), (64, 104)):
        pair = rings("Q4", inner, outer)
        _, force = pair.joint.exact(pair.f, pair.gap)
        mean = force.sum() / np.pi
        gaps.append((360 / (2 * inner), 100 * abs(mean / 0.8 - 1)))
        rows.append(Row("naive", f"as drawn, {2 * inner} sides on {2 * outer}: overlap up to {-pair.gap.min():.2g}, "
                        f"{(force <= 0).sum()} of {len(force)} nodes open", f"{mean:.3g}", mean / 0.8 - 1,
                        at_least=1.0 if inner == 8 else 0.05))
    run = answer(program, "facet_rings")
    for contact in ("DRAWN", "DECLARED"):
        p = np.array(run.column(contact, "A"))
        mean = p.mean()
        drawn = contact == "DRAWN"
        rows.append(Row("spricka", f"spricka, {run.name}, {contact}", f"{mean:.3g}", mean / 0.8 - 1,
                        allowed=0.05, said=run.said() if drawn else "", limit=drawn))
    return Scene(
        "facets",
        [Table("Two rings pressed from outside, exactly 0.8 between them (benchmark C02), E = 5000, straight sides:",
               rows)],
        [pic.Chart("Error of the mean pressure over the sides", "degrees per side", "error, %",
                   [pic.Curve("naive: gap as drawn", gaps, pic.NAIVE)], log_x=True, log_y=True)], "C02, S03")


def floating(program):
    """S10."""
    rows, points = [], []
    for spring in (1e-2, 1.0, 1e2, 1e4):
        pair = stacked("Q8", 7, 4)
        upper = np.flatnonzero(pair.mesh.x[:, 1] > 5 - 1e-9)
        mine = np.setdiff1d(upper, pair.targets[pair.targets >= 0])
        K = grounded(stiffness(pair.mesh), 2 * mine + 1, spring)
        joint = Joint(K, sparse.csr_matrix(whole_rows(pair)), held_of(pair))
        _, force = joint.exact(pair.f, pair.gap)
        lifted, _ = joint.exact(-pair.f, pair.gap)
        error = force.sum() / 10000 - 1
        points.append((spring, 100 * abs(error)))
        rows.append(Row("naive", f"springs of {spring:g} N/mm, pressed: {force.sum():.6g} N of 10000",
                        f"pulled off: moves {lifted[2 * mine + 1].max():.3g} mm", error,
                        at_least=1e-6 if spring >= 1 else None))
    pressed, pulled = answer(program, "pulled_block", "up=-1"), answer(program, "pulled_block")
    total = abs(pressed.results().table("checks")["found"][0])
    rows += [Row("spricka", f"spricka, {pressed.name}, up=-1, pressed: {total:.6g} N", "", total / 10000 - 1,
                 allowed=1e-9,
                 said=pressed.said()),
             Row("spricka", f"spricka, {pulled.name}, pulled off", "", said=pulled.said(), allowed=0.0)]
    return Scene(
        "floating",
        [Table("A block on another, pressed by 10000 N or pulled off (error: of the contact force):", rows)],
        [pic.Chart("Contact force lost to the springs", "N/mm on each node", "%",
                   [pic.Curve("naive: springs", points, pic.NAIVE)], log_x=True, log_y=True)], "S10, peer trap: exit "
                                                                                               "255")


def whole_rows(pair):
    """Rows of a pair for all freedoms."""
    normals = np.tile((0.0, -1.0), (len(pair.slaves), 1))
    return contact_rows(pair.mesh, pair.slaves, normals, pair.targets)[0]


def held_of(pair):
    x, y = pair.mesh.x.T
    return np.r_[2 * np.flatnonzero(np.abs(x) < 1e-9), 2 * np.flatnonzero(np.abs(y) < 1e-9) + 1]


def doubled(program):
    """S11."""
    pair = stacked("Q8", 7, 4)
    free = np.setdiff1d(np.arange(pair.mesh.freedoms()), held_of(pair))
    K, G = stiffness(pair.mesh), sparse.csr_matrix(whole_rows(pair))
    rows = []
    for copies in (1, 2):
        try:
            force = multipliers(K, G, pair.f, pair.gap, free, copies)
            largest = np.abs(force).max()
            rows.append(Row("naive" if copies > 1 else "other",
                            f"multipliers, {copies} cop{'y' if copies == 1 else 'ies'}: "
                            f"{force.sum():.6g} N in all", f"largest {largest:.3g} N",
                            largest / 2300 - 1 if copies > 1 else None, at_least=0.5 if copies > 1 else None))
        except RuntimeError as error:
            rows.append(Row("naive", f"multipliers, {copies} copies", "", note=f"stops: {error}"))
    areas = consistent_matrix(pair.mesh, pair.slaves, pair.edges).sum(1)
    depth = []
    for copies in (1, 2):
        u, force, _ = penalty(pair.joint, pair.f, pair.gap, areas * copies, 1e6)
        depth.append((G @ u).max())
        rows.append(Row("naive" if copies > 1 else "other", f"springs of 1e6 N/mm^3, {copies} cop"
                        f"{'y' if copies == 1 else 'ies'}", f"{depth[-1]:.3g} mm deep",
                        depth[1] / depth[0] - 1 if copies > 1 else None, at_least=0.3 if copies > 1 else None))
    once, twice = answer(program, "pulled_block", "up=-1"), answer(program, "doubled_pair")
    single = np.array(once.column("FACE", "LOAD"))
    total = np.array(twice.column("FACE", "LOAD")) + np.array(twice.column("MORE", "LOAD"))
    rows.append(Row("spricka", f"spricka, {twice.name}: pressures of both pairs added, against the single pair", "",
                    np.abs(total / single - 1).max(), allowed=1e-9, said=twice.said()))
    return Scene(
        "doubled_pair",
        [Table("Two blocks on each other, pressed by 10000 N:", rows)],
        [], "S11")


def pin(program):
    """S03, C06."""
    exact = {5: (36.33, 1.05901), 1: (60.92, 0.704604), 0.5: (69.72, 0.650839), 0.1: (80.91, 0.609033), 0: (84.80,
                                                                                                            0.599626)}
    rows, curves = [], {"hertz": [], "exact": [], "ours": []}
    for clearance, (angle, peak) in exact.items():
        if clearance:
            half, p = hertz(clearance)
            shown = f"{half:.1f} deg" if half is not None else "wider than the pin"
            rows.append(Row("naive", f"Hertz, E dR/Q = {clearance:g}: {shown}", f"p {p:.4g}", p / peak - 1,
                            measured=0.3 if clearance >= 1 else None, at_least=0.3))
            curves["hertz"].append((clearance, p))
            curves["exact"].append((clearance, peak))
    rows.append(Row("naive", "cosine, net fit: 90 deg", f"p {2 / np.pi:.4g}", 2 / np.pi / exact[0][1] - 1,
                    measured=0.0617))
    for clearance, (angle, peak) in exact.items():
        run = answer(program, "pin_in_hole", f"dR={clearance:g}")
        p = max(run.column("FIT", "ONE"))
        rows.append(Row("spricka", f"spricka, {run.name}, dR={clearance:g}", f"p {p:.4g}", p / peak - 1, allowed=3e-3,
                        said=run.said()))
        if clearance:
            curves["ours"].append((clearance, p))
    return Scene(
        "hertz_pin",
        [Table("A pin in a large plate of the same material, R = 1, Q = 1: largest pressure against Persson's and "
               "Ciavarella and Decuzzi's solution (benchmark C06):", rows)],
        [pic.Chart("Largest pressure over the clearance", "E dR / Q", "p R / Q",
                   [pic.Curve("naive: Hertz", curves["hertz"], pic.NAIVE),
                    pic.Curve("exact", curves["exact"], pic.TRUE, dashed=True),
                    pic.Curve("spricka", curves["ours"], pic.OURS, line=False)], log_x=True)], "S03, C06")


def huge_modulus(program):
    """S07."""
    soft, rows, points = 1000 * (1 - 0.3 ** 2) / 1e6 * 5, [], []
    for power in (2, 4, 6, 8, 10, 12, 14, 16):
        pair = stacked("Q8", 4, 4)
        pair.mesh.blocks[1].material = Material(10.0 ** power * 1e6, 0.3, True)
        free = np.setdiff1d(np.arange(pair.mesh.freedoms()), held_of(pair))
        G = sparse.csr_matrix(whole_rows(pair))
        u, force = pressed_by_stiff(pair, stiffness(pair.mesh), G, free)
        found = u[1::2].min()
        error = -found / (soft * (1 + 10.0 ** -power)) - 1
        points.append((10.0 ** power, 100 * max(abs(error), 1e-14)))
        if power in (6, 10, 12, 14, 16):
            rows.append(Row("naive", f"1e{power} times as stiff: contact carries {force.sum():.6g} N of 10000",
                            f"{found:.4g} mm", error, at_least=0.01 if power > 12 else None))
    ours = []
    for power in (2, 6, 8, 10, 14):
        run = answer(program, "stiff_block", f"ratio=1e{power}")
        if run.outcome() == "refusal":
            rows.append(Row("spricka", f"spricka, {run.name}, ratio=1e{power}", "", said=run.said()))
            continue
        found = float(run.results().table("checks")["found"][0])
        error = -found / (soft * (1 + 10.0 ** -power)) - 1
        ours.append((10.0 ** power, 100 * max(abs(error), 1e-14)))
        rows.append(Row("spricka", f"spricka, {run.name}, ratio=1e{power}", f"{found:.9g} mm", error, allowed=1e-6,
                        said=run.said()))
    return Scene(
        "huge_modulus",
        [Table(f"A stiff block pressed by 10000 N on a soft one: exactly {soft:g} mm and the stiff block's share:",
               rows)],
        [pic.Chart("Error of the displacement over the contrast", "ratio of moduli", "error, %",
                   [pic.Curve("naive: one matrix", points, pic.NAIVE), pic.Curve("spricka", ours, pic.OURS)],
                   log_x=True, log_y=True)], "S07")


SCENES = {"averaged_normals": normals, "facets": facets, "floating": floating, "doubled_pair": doubled,
          "hertz_pin": pin, "huge_modulus": huge_modulus}
