#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact pressure of spricka and CalculiX against closed forms, measured in the same go.

    tests/bench/contact_pressure.py [--spricka PROGRAM] [--levels N] [--out FOLDER]

Problem 3 of the peer comparison: a press-fitted sleeve (Lame) and a cylinder on a block (Hertz), both
in plane strain, six-node triangles of the same sizes for both programs. Writes contact_pressure.csv
and prints the table. Needs the packages calculix-ccx, gmsh and python3-numpy. One thread each; CPU is
that of the whole program; meshes are made before by gmsh and not counted, for neither program.
"""
import argparse
import csv
import math
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

import calculix
import measure
import plane_mesh

HERE = Path(__file__).resolve().parent
BORE, OUTER, INNER, FIT = 36.0, 86.5, 30.0, 0.042
RING, SLEEVE = (69800.0, 0.33), (206000.0, 0.32)
STEEL, R = (210000.0, 0.3), 100.0
APPROACH = 0.1          # of the cylinder's upper end
LAME_STIFFNESS, HERTZ_STIFFNESS = 1.0e6, 1.0e7  # of ccx's contact [N/mm^3], its best in each


@dataclass
class Row:
    problem: str
    program: str
    level: int
    inside: int        # nodes of the contact side that carry pressure
    mean_error: float  # Lame: of the mean pressure; Hertz: of the pressure in the middle third
    l2_error: float    # of the pressure over the surface, relative
    cpu: float
    memory: float
    code: int


def lame_pressure():
    """Press fit of two rings in plane strain (Lame 1852)."""
    def plane_strain(material):
        E, nu = material
        return E / (1.0 - nu * nu), nu / (1.0 - nu)
    (Eo, no), (Ei, ni) = plane_strain(RING), plane_strain(SLEEVE)
    outer = BORE / Eo * ((OUTER ** 2 + BORE ** 2) / (OUTER ** 2 - BORE ** 2) + no)
    inner = BORE / Ei * ((BORE ** 2 + INNER ** 2) / (BORE ** 2 - INNER ** 2) - ni)
    return FIT / (outer + inner)


def quarter_ring(geo, name, inner, outer):
    """Returns its arcs, inner and outer."""
    o = geo.point(0.0, 0.0)
    p = [geo.point(inner, 0.0), geo.point(outer, 0.0), geo.point(0.0, outer), geo.point(0.0, inner)]
    arcs = geo.arc(p[3], o, p[0]), geo.arc(p[1], o, p[2])
    loop = geo.loop([geo.line(p[0], p[1]), arcs[1], geo.line(p[2], p[3]), arcs[0]])
    geo.body(name, [geo.surface([loop])])
    return arcs


def rings(folder, level, sleeve_outer):
    """Two meshes that do not match; ring.msh and sleeve.msh stay in the folder."""
    meshes = []
    for name, side, radii, size in (("RING", "BORE", (BORE, OUTER), 8.0),
                                    ("SLEEVE", "SKIN", (INNER, sleeve_outer), 5.0)):
        geo = plane_mesh.Geo()
        arcs = quarter_ring(geo, name, *radii)
        geo.edge(side, arcs[0] if name == "RING" else arcs[1])
        geo.sizes([f"{size / 2.0 ** level!r}"])
        meshes.append(geo.mesh(folder))
        (folder / "mesh.msh").rename(folder / f"{name.lower()}.msh")
    shift = len(meshes[0].nodes)
    bodies = dict(meshes[0].bodies, SLEEVE=meshes[1].bodies["SLEEVE"] + shift)
    return plane_mesh.Mesh(np.vstack([m.nodes for m in meshes]), bodies)


def cylinder(folder, level):
    """Quarter of a cylinder on half a block; they touch in the origin."""
    geo = plane_mesh.Geo()
    o = geo.point(0.0, R)
    p = [geo.point(0.0, 0.0), geo.point(R, R)]
    round_side, head = geo.arc(p[0], o, p[1]), geo.line(p[1], o)
    geo.body("TOP", [geo.surface([geo.loop([round_side, head, geo.line(o, p[0])])])])
    q = [geo.point(0.0, 0.0), geo.point(0.0, -R), geo.point(R, -R), geo.point(R, 0.0)]
    sides = [geo.line(q[i], q[(i + 1) % 4]) for i in range(4)]
    geo.body("BASE", [geo.surface([geo.loop(sides)])])
    for name, side in (("ROUND", round_side), ("HEAD", head), ("FOOT", sides[1]),
                       ("FLAT", sides[3])):
        geo.edge(name, side)
    geo.sizes(["15", f"{0.8 / 2.0 ** level!r}+0.25*Max(0,Sqrt(x^2+y^2)-3)"])
    return geo.mesh(folder)


def sides_where(mesh, body, on):
    """Outer sides whose two corners lie where on(x, y) holds."""
    here = on(*mesh.nodes.T)
    return [(k, side) for k, side, a, b, _ in mesh.boundary(body) if here[a] and here[b]]


def contact_cards(deck, stiffness, slave, master):
    deck.add("*SURFACE INTERACTION, NAME=HARD", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
             f"{stiffness:g}, 1e-6",
             "*CONTACT PAIR, INTERACTION=HARD, TYPE=SURFACE TO SURFACE", f"{slave}, {master}")


def pressures_of_frd(path):
    """x, y, pressure of all contact nodes at the end; the slab of an element has three layers."""
    place, last, block, reading = {}, {}, None, False
    for line in Path(path).read_text().splitlines():
        if line.startswith("    2C"):
            reading = True
        elif line.startswith(" -4"):
            block = {} if line.split()[1] == "CONTACT" else None
            last = block if block is not None else last
        elif line.startswith(" -3"):
            reading, block = False, None
        elif line.startswith(" -1") and (reading or block is not None):
            values = [float(line[13 + 12 * i:25 + 12 * i])
                      for i in range((len(line.rstrip()) - 13) // 12)]
            (place if reading else block)[int(line[3:13])] = values
    return np.array([[*place[n][:2], v[3]] for n, v in last.items()]).reshape(-1, 3)


def pressures_of_csv(path):
    """x, y, pressure of all nodes of the contact side at the end."""
    with open(path) as text:
        rows = list(csv.DictReader(line for line in text if not line.startswith("#")))
    return np.array([[float(r["x"]), float(r["y"]), float(r["p_lumped"])] for r in rows])


def along(s, p):
    """Pressure over the coordinate, nodes of one place averaged."""
    s, at = np.unique(np.round(s, 6), return_inverse=True)
    return s, np.array([p[at == k].mean() for k in range(len(s))])


def run_spricka(program, folder, text):
    (folder / "job.deck").write_text(text)
    return measure.run([program, "run", folder / "job.deck", "--out", folder / "run"], folder,
                       "spricka.log")


def run_ccx(deck, folder):
    (folder / "job.inp").write_text("\n".join(deck.lines) + "\n")
    for old in folder.glob("job.[!i]*"):
        old.unlink()
    return measure.run(["ccx", "-i", "job"], folder, "ccx.log", 300.0)


LAME_DECK = f"""$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Benchmark: press fit of two rings'
$NET NAME=R
  $IMPORT FILE='ring.msh' FORMAT=MSH
$ENDNET
$NET NAME=S
  $IMPORT FILE='sleeve.msh' FORMAT=MSH
$ENDNET
$MATERIAL NAME=RINGM E={RING[0]} NU={RING[1]}
$MATERIAL NAME=SLEEVEM E={SLEEVE[0]} NU={SLEEVE[1]}
$PROPERTY ESET=R.RING MATERIAL=RINGM STATE=STRAIN
$PROPERTY ESET=S.SLEEVE MATERIAL=SLEEVEM STATE=STRAIN
$NSET NAME=SYMX WHERE=(abs(x) < 1e-9)
$NSET NAME=SYMY WHERE=(abs(y) < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  SYMX
$FREEDOM CLASS=SUPPRESSED DOF=Y
  SYMY
$CONTACT NAME=FIT SLAVE=S.SKIN MASTER=R.BORE INTERFERENCE={FIT}
$STEP NAME=PRESS
  FIT FIT 1
$END
"""


def judge_lame(points):
    exact = lame_pressure()
    on = np.abs(np.hypot(points[:, 0], points[:, 1]) - BORE) < 2e-3
    _, p = along(np.arctan2(points[on, 1], points[on, 0]), points[on, 2])
    p = p[p > 0.0]
    return len(p), p.mean() / exact - 1.0, math.sqrt(np.mean((p / exact - 1.0) ** 2))


def lame(level, folder, program):
    if program:
        rings(folder, level, BORE)
        cost = run_spricka(program, folder, LAME_DECK)
        return cost, judge_lame(pressures_of_csv(folder / "run" / "pressure.csv"))
    mesh = rings(folder, level, BORE + FIT)
    deck = calculix.Deck(mesh, "CPE6")
    deck.section("RING", RING, 1.0)
    deck.section("SLEEVE", SLEEVE, 1.0)
    deck.surface("BORE", "RING", mesh.circle("RING", BORE))
    deck.surface("SKIN", "SLEEVE", mesh.circle("SLEEVE", BORE + FIT))
    contact_cards(deck, LAME_STIFFNESS, "BORE", "SKIN")
    deck.node_set("SYMX", np.flatnonzero(np.abs(mesh.nodes[:, 0]) < 1e-9))
    deck.node_set("SYMY", np.flatnonzero(np.abs(mesh.nodes[:, 1]) < 1e-9))
    deck.add("*BOUNDARY", "SYMX, 1, 1", "SYMY, 2, 2", "*STEP, INC=300", "*STATIC", "1., 1.",
             "*CONTACT FILE, OUTPUT=3D", "CDIS, CSTR", "*END STEP")
    cost = run_ccx(deck, folder)
    return cost, judge_lame(pressures_of_frd(folder / "job.frd"))


HERTZ_DECK = f"""$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Benchmark: cylinder on a block'
$IMPORT FILE='mesh.msh' FORMAT=MSH
$MATERIAL NAME=STEEL E={STEEL[0]} NU={STEEL[1]}
$PROPERTY ESET=TOP MATERIAL=STEEL STATE=STRAIN
$PROPERTY ESET=BASE MATERIAL=STEEL STATE=STRAIN
$FSET NAME=UPPER FROM=ROUND WHERE=(x < 9)
$FSET NAME=LOWER FROM=FLAT WHERE=(x < 12)
$NSET NAME=SYM WHERE=(x < 1e-9)
$FREEDOM CLASS=SUPPRESSED DOF=X
  SYM
$FREEDOM CLASS=SUPPRESSED DOF=Y
  FOOT
$FREEDOM CLASS=PRESCRIBED DOF=Y
  HEAD
$CONTACT NAME=TOUCH SLAVE=UPPER MASTER=LOWER
$LOAD CASE=DOWN TYPE=DISP
  HEAD  0  {-APPROACH}
$STEP NAME=PRESS
  LOAD DOWN 1
$OUTPUT FILE='force.csv' FORMAT=CSV
  REACTION HEAD
$END
"""


def judge_hertz(points, force, ours):
    """Hertz 1882: half width and pressure from the force that the program itself found."""
    E = STEEL[0] / (2.0 * (1.0 - STEEL[1] ** 2))
    a = math.sqrt(4.0 * force * R / math.pi / E)
    p0 = 2.0 * force / math.pi / a
    on = (points[:, 1] > -1e-9) & (np.abs(np.hypot(points[:, 0], points[:, 1] - R) - R) < 2e-3)
    if ours:  # the program chooses the side that carries the pressure
        on |= np.abs(points[:, 1]) < 1e-9
    else:  # its block has none, and nodes that are hard to tell from the cylinder's
        on &= points[:, 2] > 0.0
    x, p = along(points[on, 0], points[on, 2])
    near = x < 1.5 * a
    x, p = x[near], p[near]
    exact = p0 * np.sqrt(np.maximum(0.0, 1.0 - (x / a) ** 2))
    w, middle = np.gradient(x), x < 0.3 * a
    return (int((x < a).sum()), p[middle].mean() / exact[middle].mean() - 1.0,
            math.sqrt(np.sum(w * (p - exact) ** 2) / np.sum(w * exact ** 2)))


def head_force(path):
    with open(path) as text:
        rows = csv.DictReader(line for line in text if not line.startswith("#"))
        return sum(float(r["value"]) for r in rows if r["component"] == "Y")


def hertz(level, folder, program):
    mesh = cylinder(folder, level)
    if program:
        cost = run_spricka(program, folder, HERTZ_DECK)
        force = 2.0 * abs(head_force(folder / "run" / "force.csv"))
        return cost, judge_hertz(pressures_of_csv(folder / "run" / "pressure.csv"), force, True)
    x, y = mesh.nodes.T
    deck = calculix.Deck(mesh, "CPE6")
    for body in ("TOP", "BASE"):
        deck.section(body, STEEL, 1.0)
    deck.surface("UPPER", "TOP", sides_where(
        mesh, "TOP", lambda x, y: (np.abs(np.hypot(x, y - R) - R) < 1e-6) & (x < 9.0)))
    deck.surface("LOWER", "BASE", sides_where(
        mesh, "BASE", lambda x, y: (np.abs(y) < 1e-9) & (x < 12.0)))
    contact_cards(deck, HERTZ_STIFFNESS, "UPPER", "LOWER")
    deck.node_set("SYM", np.flatnonzero(x < 1e-9))
    deck.node_set("FOOT", np.flatnonzero(y < -R + 1e-9))
    deck.node_set("HEAD", np.flatnonzero(y > R - 1e-9))
    deck.add("*BOUNDARY", "SYM, 1, 1", "FOOT, 2, 2", "*STEP, INC=300", "*STATIC", ".25, 1.",
             "*BOUNDARY", f"HEAD, 2, 2, {-APPROACH}", "*NODE PRINT, NSET=HEAD, TOTALS=ONLY", "RF",
             "*CONTACT FILE, OUTPUT=3D", "CDIS, CSTR", "*END STEP")
    cost = run_ccx(deck, folder)
    totals = [line.split() for line in (folder / "job.dat").read_text().splitlines()
              if len(line.split()) == 3 and "force" not in line]
    force = 2.0 * abs(float(totals[-1][1]))
    return cost, judge_hertz(pressures_of_frd(folder / "job.frd"), force, False)


def show(row):
    print(f"{row.problem:6s} {row.program:8s} level {row.level}  {row.inside:4d} nodes  "
          f"p {100 * row.mean_error:+8.3f} %  L2 {100 * row.l2_error:8.3f} %  "
          f"CPU {row.cpu:7.3f} s  {row.memory:7.1f} MiB  rc {row.code}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--spricka", type=Path,
                        default=HERE.parents[1] / "build/release/bin/spricka")
    parser.add_argument("--levels", type=int, default=3)
    parser.add_argument("--out", type=Path, default=Path("contact_pressure.run"))
    options = parser.parse_args()
    rows = []
    for name, once in (("lame", lame), ("hertz", hertz)):
        for level in range(options.levels):
            for program in (options.spricka.resolve(), None):
                folder = (options.out / f"{name}_{level}_{'ours' if program else 'ccx'}").resolve()
                folder.mkdir(parents=True, exist_ok=True)
                cost, figures = once(level, folder, program)
                rows.append(Row(name, "spricka" if program else "ccx", level, *figures, cost.cpu,
                                cost.memory, cost.code))
                show(rows[-1])
                with open(options.out / "contact_pressure.csv", "w", newline="") as file:
                    writer = csv.DictWriter(file, list(asdict(rows[0])))
                    writer.writeheader()
                    writer.writerows(asdict(row) for row in rows)


if __name__ == "__main__":
    main()
