#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work against precision: spricka and CalculiX on the same problems, measured in the same go.

    tests/bench/work_precision.py [--spricka PROGRAM] [--only ccx|spricka] [--problem NAME ..]
                                  [--levels N] [--repeat N] [--stiffness K] [--out FOLDER]

Writes work_precision.csv and work_precision.svg and prints the ratios. Needs the packages
calculix-ccx, gmsh and python3-numpy. One thread each; CPU is user + system time of the whole
program. The mesh that ccx gets is not counted, spricka makes its own within its time. The limit is
what the flops of one plain factorisation of spricka's mesh take at the rate of dgemm.
"""
import argparse
import csv
import math
import re
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import calculix
import chart
import measure
import plane_mesh
from stress_intensity import stress_intensities

HERE = Path(__file__).resolve().parent
# spricka's refinements: mesh size divided by so much, which the tip mesh follows. The second is what
# the program does when nothing is said.
FINE = (0.5, 1.0, 2.0, 4.0)


@dataclass
class Problem:
    title: str
    deck: str         # for spricka, with parameter fine
    reference: float  # K1 at the end of the last step
    source: str
    step: str
    crack: str
    prepare: object   # (folder, level, contact stiffness) -> (mesh, ccx deck)
    direction: tuple  # of the crack ahead of its first tip
    body: str
    material: tuple
    radii: tuple      # of the domain of the interaction integral
    symmetry: float = 1.0
    doubt: float = 1e-4  # of the reference, relative


def lug_problem(double):
    def prepare(folder, level, stiffness):
        mesh = plane_mesh.lug(folder, level, 10.8, double)
        return mesh, calculix.lug_deck(mesh, stiffness)
    return prepare


def strip_problem(folder, level, _):
    mesh = plane_mesh.edge_strip(folder, level, 0.5)
    return mesh, calculix.strip_deck(mesh)


PROBLEMS = {
    "single": Problem("Lug, press-fitted sleeve, net-fit shaft, one crack a/R = 0.3",
                      "bench_lug_single.deck", 630.6572,
                      "limit of two rows of meshes, lug_reference.py; others' solvers 630.62 to 1e-4",
                      "LOAD", "TOP", lug_problem(False), (0.0, 1.0), "LUG",
                      calculix.LUG_MATERIAL["LUG"], (3.0, 8.0), doubt=1e-6),
    "double": Problem("The same with two cracks", "bench_lug_double.deck", 664.5201,
                      "limit of two rows of meshes, lug_reference.py; others' solvers 664.467 to 1e-4",
                      "LOAD", "TOP", lug_problem(True), (0.0, 1.0), "LUG",
                      calculix.LUG_MATERIAL["LUG"], (3.0, 8.0), doubt=2e-6),
    "edge": Problem("Edge crack in a strip under tension, a/W = 0.5", "bench_edge_crack.deck",
                    2.824579 * math.sqrt(math.pi * 0.5), "collocation; agrees with Kaya and Erdogan",
                    "TENSION", "C1", strip_problem, (1.0, 0.0), "STRIP", calculix.STRIP_MATERIAL,
                    (0.1, 0.35), 2.0, 1e-6),
}


@dataclass
class Row:
    problem: str
    program: str
    refinement: float  # level of ccx's mesh, fine of spricka's
    freedoms: int
    K1: float
    K2: float
    error: float       # of K1, relative
    cpu: float
    wall: float
    memory: float
    iterations: int
    code: int


def run_ccx(name, level, stiffness, folder):
    problem = PROBLEMS[name]
    mesh, deck = problem.prepare(folder, level, stiffness)
    cost, ends, facts = calculix.solve(deck, folder)
    K1 = K2 = math.nan
    if cost.code == 0 and ends:
        K1, K2 = (problem.symmetry * K for K in stress_intensities(
            mesh.nodes, mesh.bodies[problem.body], ends[-1], mesh.nodes[mesh.tips[0]],
            problem.direction, problem.material, problem.radii))
    if problem.symmetry > 1.0:
        K2 = 0.0
    return Row(name, "ccx", level, mesh.freedoms(), K1, K2, K1 / problem.reference - 1.0, cost.cpu,
               cost.wall, cost.memory, facts["iterations"], cost.code)


def read_k(path, problem):
    """K1, K2 of the crack at the end of the step, last increment."""
    result = (math.nan, math.nan)
    with open(path) as text:
        rows = csv.DictReader(line for line in text if not line.startswith("#"))
        for row in rows:
            if row["step"] == problem.step and row["crack"].split(".")[0] == problem.crack:
                result = float(row["K1"]), float(row["K2"])
    return result


def freedoms_of(folder):
    """Two for each node of the mesh that was solved (the listing names it for each increment)."""
    listing = (folder / "listing.txt").read_text(errors="replace")
    nodes = re.findall(r"^Mesh: (\d+) nodes", listing, re.MULTILINE)
    return 2 * int(nodes[-1]) if nodes else 0


def run_spricka(program, name, fine, folder):
    problem = PROBLEMS[name]
    out = folder / "run"
    command = [program, "run", HERE / "decks" / problem.deck, "--out", out, "-D", f"fine={fine:g}"]
    cost = measure.run(command, folder, "spricka.log")
    K1, K2, freedoms = math.nan, math.nan, 0
    if cost.code in (0, 1) and (out / "k.csv").exists():
        K1, K2 = read_k(out / "k.csv", problem)
        freedoms = freedoms_of(out)
    return Row(name, "spricka", fine, freedoms, K1, K2, K1 / problem.reference - 1.0, cost.cpu,
               cost.wall, cost.memory, 0, cost.code)


def limit_of(program, row, folder):
    """The floor of the run as a row: its flops at the rate of dgemm."""
    command = [program, "run", HERE / "decks" / PROBLEMS[row.problem].deck, "--out", folder / "run",
               "-D", f"fine={row.refinement:g}", "--profile", "--quiet"]
    measure.run(command, folder, "profile.log")
    seconds = measure.floor_flops(folder / "run") / measure.dgemm_rate()
    return replace(row, program="limit", cpu=seconds, wall=seconds, memory=0.0)


def best_of(times, once):
    """The run that took the least CPU: the others were disturbed."""
    rows = [once() for _ in range(times)]
    return min(rows, key=lambda row: row.cpu)


def show(row):
    print(f"{row.problem:7s} {row.program:8s} {row.refinement:5g} {row.freedoms:8d} freedoms  "
          f"K1 {row.K1:10.4f} ({100.0 * row.error:+8.4f} %)  K2 {row.K2:8.3f}  "
          f"CPU {row.cpu:8.3f} s  {row.memory:7.1f} MiB  rc {row.code}", flush=True)


def cpu_at(rows, error):
    """CPU that a program needs for this error, read off its curve between measured points; NaN when
    it never gets there."""
    good = sorted((row.cpu, abs(row.error)) for row in rows if abs(row.error) > 0.0)
    for (c0, e0), (c1, e1) in zip(good, good[1:]):
        if e0 > error >= e1:
            t = math.log(e0 / error) / math.log(e0 / e1)
            return math.exp(math.log(c0) + t * math.log(c1 / c0))
    return good[0][0] if good and good[0][1] <= error else math.nan


def ratios(rows):
    for name in PROBLEMS:
        ours = [r for r in rows if r.problem == name and r.program == "spricka" and r.K1 == r.K1]
        peers = [r for r in rows if r.problem == name and r.program == "ccx" and r.K1 == r.K1]
        default = next((r for r in ours if r.refinement == 1.0), None)
        if default is None:
            continue
        for peer in peers:
            equal = cpu_at(ours, max(abs(peer.error), PROBLEMS[name].doubt))
            print(f"{name}: ccx level {peer.refinement:g} takes {peer.cpu / default.cpu:.1f} times the "
                  f"CPU and {peer.memory / default.memory:.1f} times the memory of spricka as it "
                  f"comes (errors {100 * peer.error:+.3f} and {100 * default.error:+.3f} %); at ccx's "
                  f"error {peer.cpu / equal:.1f} times the CPU")


CURVES = {"limit": "flops at dgemm's rate"}
chart.COLOURS[CURVES["limit"]] = chart.COLOURS["limit"]


def panels(rows):
    sheet = []
    for name, problem in PROBLEMS.items():
        line = []
        for what, label in (("cpu", "CPU s"), ("freedoms", "freedoms")):
            panel = chart.Panel(problem.title if what == "cpu" else "", label, "error of K1 %",
                                floor=100.0 * problem.doubt, names_beside=True)
            for program in ("spricka", "ccx", "limit") if what == "cpu" else ("spricka", "ccx"):
                points = [(getattr(r, what), max(100.0 * abs(r.error), 1e-4)) for r in rows
                          if r.problem == name and r.program == program and r.error == r.error and
                          getattr(r, what) > 0]
                if points:
                    panel.curves[CURVES.get(program, program)] = sorted(points)
            line.append(panel)
        if any(panel.curves for panel in line):
            sheet.append(line)
    return sheet


def write(rows, folder):
    """Table and chart of what there is: ccx takes minutes, and a cut run keeps what it has."""
    with open(folder / "work_precision.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, list(asdict(rows[0])))
        writer.writeheader()
        writer.writerows(asdict(row) for row in rows)
    chart.sheet(folder / "work_precision.svg", panels(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--spricka", type=Path,
                        default=HERE.parents[1] / "build/release/bin/spricka")
    parser.add_argument("--only", choices=("ccx", "spricka"))
    parser.add_argument("--problem", nargs="+", choices=PROBLEMS, default=list(PROBLEMS))
    parser.add_argument("--levels", type=int, default=4)
    parser.add_argument("--repeat", type=int, default=3, help="of spricka; ccx runs once")
    parser.add_argument("--stiffness", type=float, default=calculix.STIFFNESS,
                        help="of ccx's contact, N/mm^3")
    parser.add_argument("--out", type=Path, default=Path("work_precision.run"))
    options = parser.parse_args()
    rows = []
    for name in options.problem:
        problem = PROBLEMS[name]
        print(f"{problem.title}: K1 = {problem.reference:.6g} ({problem.source})")
        for level in range(options.levels):
            folder = (options.out / f"{name}_{level}").resolve()
            folder.mkdir(parents=True, exist_ok=True)
            if options.only != "ccx":
                rows.append(best_of(options.repeat, lambda: run_spricka(
                    options.spricka.resolve(), name, FINE[level], folder)))
                show(rows[-1])
                rows.append(limit_of(options.spricka.resolve(), rows[-1], folder))
                show(rows[-1])
            if options.only != "spricka":
                rows.append(run_ccx(name, level, options.stiffness, folder))
                show(rows[-1])
            write(rows, options.out)
    ratios(rows)


if __name__ == "__main__":
    main()
