#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the solid lug costs in spricka and in ccx (surface to surface) on the same meshes, and how far the bore moves
in both. Writes the CPU times into manual/work_precision_solid.csv; its errors of ccx are those of the same meshes.

    tests/bench/solid_lug.py [--spricka PROGRAM] [--levels 4] [--mortar]
"""
import argparse
import sys
from pathlib import Path

import numpy as np

import measure
from front_calculix import run

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "manual"))
from spricka_results import Results  # noqa: E402

FINE = ("0.35", "0.5", "0.7", "1")
BODIES = {"LUG": (69800.0, 0.33), "SLEEVE": (206000.0, 0.32), "SHAFT": (196000.0, 0.32)}
SIDES = ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5))  # S3, S4, S5 of a wedge by its corners
MIDDLES = ((6, 13, 9, 12), (7, 14, 10, 13), (8, 12, 11, 14))
HALF_FIT = 0.021  # of the interference on the radius, on each of the two surfaces
STIFFNESS = 1.0e6
FORCE, THICK, END = 97100.0 / 2.0, 7.0, -232.5


def bodies_of(x, wedges):
    """Wedges of lug, sleeve and shaft: a body is what hangs together."""
    parent = np.arange(len(x))

    def root(n):
        while parent[n] != n:
            parent[n] = parent[parent[n]]
            n = parent[n]
        return n
    for row in wedges:
        for n in row[1:]:
            parent[root(n)] = root(row[0])
    roots = np.array([root(row[0]) for row in wedges])
    reach = {r: np.hypot(*x[np.unique(wedges[roots == r])][:, :2].T).max() for r in np.unique(roots)}
    names = dict(zip(sorted(reach, key=reach.get, reverse=True), BODIES))
    return {name: wedges[roots == r] for r, name in names.items()}


def round_side(x, wedges, radius):
    """(wedge, S number) of the sides on a cylinder, and their nodes."""
    found, nodes = [], set()
    for e, row in enumerate(wedges):
        for s, side in enumerate(SIDES):
            of_side = row[list(side + MIDDLES[s])]
            if np.all(np.abs(np.hypot(*x[of_side][:, :2].T) - radius) < 1e-6):
                found.append((e, s + 3))
                nodes.update(of_side)
    return found, sorted(nodes)


def write(path, results, mortar):
    x = results.mesh(1)["x"].copy()
    (_, wedges), = results.elements(1)
    bodies = bodies_of(x, wedges)
    lines, first, number = [], {}, 1
    for name, rows in bodies.items():
        first[name] = number
        lines.append(f"*ELEMENT, TYPE=C3D15, ELSET={name}")
        for row in rows:
            words = [str(number)] + [str(n + 1) for n in row]
            lines += [",".join(words[:9]) + ",", ",".join(words[9:])]
            number += 1
    surfaces = {}
    for name, body, radius, moved in (("BORE", "LUG", 36.0, -HALF_FIT), ("OUTER", "SLEEVE", 36.0, HALF_FIT),
                                      ("INNER", "SLEEVE", 30.0, 0.0), ("PIN", "SHAFT", 30.0, 0.0)):
        sides, nodes = round_side(x, bodies[body], radius)
        surfaces[name] = (nodes, moved / radius)
        lines.append(f"*SURFACE, NAME={name}")
        lines += [f"{first[body] + e}, S{s}" for e, s in sides]
    bore = surfaces["BORE"][0]
    for nodes, part in surfaces.values():
        x[nodes, :2] *= 1.0 + part
    for name, (modulus, nu) in BODIES.items():
        lines += [f"*MATERIAL, NAME={name}", "*ELASTIC", f"{modulus}, {nu}", "*DENSITY", "1.",
                  f"*SOLID SECTION, ELSET={name}, MATERIAL={name}"]
    kind = "TYPE=MORTAR" if mortar else "TYPE=SURFACE TO SURFACE"
    lines.append("*SURFACE INTERACTION, NAME=HARD")
    lines += ["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=" + ("HARD" if mortar else f"LINEAR\n{STIFFNESS:g}, 1e-6")]
    for slave, master in (("BORE", "OUTER"), ("INNER", "PIN")):
        lines += [f"*CONTACT PAIR, INTERACTION=HARD, {kind}", f"{slave}, {master}"]
    lines.append("*BOUNDARY")
    lines += [f"{n + 1}, 1, 2" for n in np.flatnonzero(x[:, 0] < END + 1e-6)]
    lines += [f"{n + 1}, 3" for n in np.flatnonzero(x[:, 2] < 1e-9)]
    for body in ("SLEEVE", "SHAFT"):  # nothing else stops their rotation
        nodes = np.unique(bodies[body])
        far = [nodes[np.argmax(sign * x[nodes, 0] - 1e3 * np.abs(x[nodes, 1]) - x[nodes, 2])] for sign in (1, -1)]
        lines += ["*EQUATION", "2", f"{far[0] + 1}, 2, 1., {far[1] + 1}, 2, -1."]
    lines += ["*NSET, NSET=BORE", *[f"{n + 1}," for n in bore]]
    force = FORCE / (np.pi * 30.0 ** 2 * THICK)  # per volume
    for load in ((), ("*DLOAD", f"SHAFT, GRAV, {force:.12g}, 1., 0., 0.")):
        lines += ["*STEP, INC=200", "*STATIC", "1., 1.", *load, "*NODE PRINT, NSET=BORE", "U", "*END STEP"]
    head = ["*NODE, NSET=ALL"] + [f"{n + 1},{p[0]:.12g},{p[1]:.12g},{p[2]:.12g}" for n, p in enumerate(x)]
    Path(path).write_text("\n".join(head + lines) + "\n")
    return bore


def bore_moves(results, nodes):
    """The largest displacement along x of the bore under load."""
    return results.field("u", 1, "LOAD")[nodes][:, 0].max()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spricka", type=Path, default=TOP / "build/release/bin/spricka")
    parser.add_argument("--levels", type=int, default=4)
    parser.add_argument("--mortar", action="store_true")
    parser.add_argument("--out", type=Path, default=Path("solid_lug.run"))
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    cpu = {}
    for fine in FINE[:arguments.levels]:
        run_folder = arguments.out / f"lug_{fine}.run"
        command = [str(arguments.spricka), "run", str(TOP / "decks/lug_solid.deck"), "-D", f"fine={fine}", "--quiet",
                   "--out", str(run_folder.resolve())]
        best = min((measure.run(command, str(arguments.out), f"{fine}.log") for _ in range(3)), key=lambda c: c.cpu)
        cpu["spricka", fine] = best.cpu
        print(f"spricka {fine}: {best.cpu:.2f} s, {best.memory:.0f} MiB", flush=True)
        for mortar in ((False, True) if arguments.mortar else (False,)):
            name = f"ccx_{fine}_{'mortar' if mortar else 'surface'}"
            results = Results(run_folder / "results.h5")
            bore = write(arguments.out / f"{name}.inp", results, mortar)
            cost, moved = run(arguments.out, name)  # of the last step
            key = ("ccx mortar" if mortar else "ccx surface to surface", fine)
            cpu[key] = cost.cpu
            own = bore_moves(results, bore)
            print(f"{key[0]} {fine}: {cost.cpu:.2f} s, {cost.cpu / best.cpu:.1f} times, {cost.memory:.0f} MiB, bore "
                  f"{max(u[0] for u in moved.values()):.5f}, spricka {own:.5f}", flush=True)
    table = TOP / "manual/work_precision_solid.csv"
    lines = table.read_text(encoding="utf-8").splitlines()
    for i, line in enumerate(lines):
        words = line.split(",")
        if tuple(words[:2]) in cpu:
            lines[i] = ",".join([*words[:3], f"{cpu[tuple(words[:2])]:.2f}", *words[4:]])
    table.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
