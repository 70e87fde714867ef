#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work against precision of K along fronts in space: a penny under tension and shear, an ellipse under
tension and bending, on tubes of several sizes, against closed forms.

    tests/bench/front_precision.py [--spricka PROGRAM] [--only penny|ellipse] [--ccx LEVELS]
                                   [--repeat N] [--out FOLDER]

Writes work_precision_front.csv and .svg into front_precision.run, where --only renews the rows of
one. With --ccx it gives CalculiX the same meshes of the first so many levels, under tension, and
takes K1 from its displacements. Needs python3-numpy and python3-h5py; --ccx calculix-ccx. One
thread; CPU is user + system time of the whole program, its mesher in it. The limit is what the flops
of one plain factorisation of the mesh take at the rate of dgemm.
"""
import argparse
import csv
import sys
from pathlib import Path

import numpy as np

import chart
import measure

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
sys.path.insert(0, str(TOP / "manual"))
# Radius of the tube over the crack's smaller half axis, its rings and sectors. The third is what the
# program does when nothing is said.
LEVELS = ((0.2, 2, 6), (0.27, 3, 6), (None, 3, 8), (0.13, 3, 10), (0.09, 4, 12))
# Size of tetrahedra at the front over the same half axis, where there is no tube.
FREE = (0.2, 0.14, 0.1, 0.07)
COLUMNS = ("problem", "program", "radius", "rings", "sectors", "unknowns", "cpu_s", "memory_MiB",
           "limit_s", "rms", "largest", "raw_rms", "raw_largest", "bar_rms", "inside")


def penny(phi, step):
    a, nu = 1.0, 0.3
    k = 4.0 / (np.pi * (2.0 - nu)) * np.sqrt(np.pi * a)
    K = np.zeros((len(phi), 3))
    K[:, 0] = 2.0 * np.sqrt(a / np.pi)
    if step == "BOTH":
        K[:, 1] = k * np.cos(phi)
        K[:, 2] = (1.0 - nu) * k * np.sin(phi)
    return K


def ellipse(phi, step):
    """Half axes c = 1 along x and a = 0.5 along y; Fourier's method, exact for a linear stress."""
    c, a = 1.0, 0.5
    D = lambda t: np.sqrt(np.cos(t) ** 2 / c ** 2 + np.sin(t) ** 2 / a ** 2)
    t = np.linspace(0.0, 2.0 * np.pi, 4096, endpoint=False)
    I0 = np.mean(D(t)) * 2.0 * np.pi
    Ic = np.mean(D(t) * np.cos(t) ** 2) * 2.0 * np.pi
    K = np.zeros((len(phi), 3))
    K[:, 0] = np.sqrt(np.pi * D(phi)) * 4.0 / I0
    if step == "BOTH":
        K[:, 0] += np.sqrt(np.pi * D(phi)) * 4.0 * np.cos(phi) / (3.0 * Ic)
    return K


# Deck, exact K, smaller half axis.
PROBLEMS = {"penny": ("penny_solid.deck", penny, 1.0),
            "ellipse": ("ellipse_solid.deck", ellipse, 0.5)}


def deck_of(problem, level):
    """The deck of decks/ with a front of that level, without its checks, which are of another."""
    name, _, a = PROBLEMS[problem]
    text = (TOP / "decks" / name).read_text(encoding="utf-8")
    card = ""
    if isinstance(level, float):
        card = f"$TIPNET CRACK=C1 TUBE=NO SIZE={level * a:g}\n"
    elif level[0] is not None:
        radius, rings, sectors = level
        card = f"$TIPNET CRACK=C1 RADIUS={radius * a:g} RINGS={rings} SECTORS={sectors}\n"
    text = text.replace("$LOAD CASE=PULL", card + "$LOAD CASE=PULL")
    return text[:text.index("$CHECK")] + "$END\n"


def k_rows(folder, step):
    with open(folder / "k.csv", encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [row for row in rows if row["step"] == step]


def columns(rows, *names):
    return np.array([[float(row[name]) for name in names] for row in rows])


def errors(problem, folder):
    """Of the last step, of all modes at all points, in per cent of the largest K along the front."""
    rows = k_rows(folder, "BOTH")
    exact = PROBLEMS[problem][1](np.radians(columns(rows, "phi")[:, 0]), "BOTH")
    largest = np.linalg.norm(exact, axis=1).max()
    raw = np.abs(columns(rows, "K1_raw", "K2_raw", "K3_raw") - exact)
    bar = columns(rows, "K1_bar", "K2_bar", "K3_bar")
    off = np.abs(columns(rows, "K1", "K2", "K3") - exact)

    def rms(v):
        return 100.0 * np.sqrt(np.mean(v ** 2)) / largest

    return {"rms": rms(off), "largest": 100.0 * off.max() / largest,
            "raw_rms": rms(raw), "raw_largest": 100.0 * raw.max() / largest,
            "bar_rms": rms(bar), "inside": 100.0 * np.mean(off <= bar)}


def unknowns(folder):
    for line in (folder / "listing.txt").read_text(encoding="utf-8").splitlines():
        if "unknowns" in line and "CONDENSE" in line:
            return int(line.split(" unknowns")[0].split()[-1])
    raise RuntimeError(f"no unknowns in {folder}")


def spricka(arguments, problem, level, deck):
    folder = deck.parent
    deck.write_text(deck_of(problem, level), encoding="utf-8")
    out = deck.with_suffix(".run")
    command = [str(arguments.spricka), "run", str(deck), "--threads", "1", "--out", str(out)]
    costs = [measure.run(command, str(folder), f"{deck.stem}.log") for _ in range(arguments.repeat)]
    if costs[0].code == 3:
        print(f"{deck.stem}: refused, see {folder / deck.stem}.log", flush=True)
        return None
    if any(cost.code != 0 for cost in costs):
        raise RuntimeError(f"{deck.stem}: see {folder / deck.stem}.log")
    best = min(costs, key=lambda cost: cost.cpu)
    measure.run([*command, "--profile", "--quiet"], str(folder), f"{deck.stem}.log")
    radius, rings, sectors = (level, "", "") if isinstance(level, float) else level
    return {"problem": problem, "program": "spricka, no tube" if isinstance(level, float) else "spricka",
            "radius": radius or "as it comes", "rings": rings, "sectors": sectors,
            "unknowns": unknowns(out), "cpu_s": round(best.cpu, 2),
            "memory_MiB": round(best.memory),
            "limit_s": f"{measure.floor_flops(out) / measure.dgemm_rate():.3g}",
            **errors(problem, out)}


def ccx(problem, number, folder):
    """K1 under tension by the displacements of ccx, on the mesh of the run of that level."""
    import front_calculix
    from spricka_results import Results
    out = folder / f"{problem}_{number}.run"
    name = f"{problem}_{number}_ccx"
    x, pairs = front_calculix.write(folder / f"{name}.inp", Results(out / "results.h5"))
    cost, moved = front_calculix.run(folder, name)
    rows = k_rows(out, "PULL")
    phi = np.radians(columns(rows, "phi")[:, 0])
    exact = PROBLEMS[problem][1](phi, "PULL")[:, 0]
    a = PROBLEMS[problem][2]
    growth = np.stack([a * np.cos(phi), np.sin(phi)], axis=1)
    growth /= np.linalg.norm(growth, axis=1)[:, None]
    K = front_calculix.extrapolated(columns(rows, "x", "y"), growth, pairs, moved)
    own = columns(rows, "K1")[:, 0]
    print(f"{problem} {number}: K1 of spricka under tension, rms "
          f"{100.0 * np.sqrt(np.mean((own - exact) ** 2)) / exact.max():.3f} %, largest "
          f"{100.0 * np.abs(own - exact).max() / exact.max():.3f} %")
    off = 100.0 * np.abs(K - exact) / exact.max()
    radius, rings, sectors = LEVELS[number]
    return {"problem": problem, "program": "ccx", "radius": radius or "as it comes",
            "rings": rings, "sectors": sectors, "unknowns": unknowns(out),
            "cpu_s": round(cost.cpu, 2), "memory_MiB": round(cost.memory),
            "rms": np.sqrt(np.mean(off ** 2)), "largest": off.max()}


def draw(rows, path):
    chart.COLOURS.update({"raw K, rms": "#5aa0d6", "bar, rms": "#2e8b57", "K, rms": "#1b5e9b",
                          "no tube, K, rms": "#b8860b", "ccx, K1 rms": "#c2571a",
                          "K, rms; flops at dgemm's rate": "#777"})
    panels = []
    for problem, title in (("penny", "penny, tension and shear"),
                           ("ellipse", "ellipse a/c = 0.5, tension and bending")):
        panel = chart.Panel(title, "CPU  [s]", "part of the largest K  [%]", names_beside=True)
        for name, program, cost, column in (
                ("raw K, rms", "spricka", "cpu_s", "raw_rms"), ("bar, rms", "spricka", "cpu_s", "bar_rms"),
                ("K, rms", "spricka", "cpu_s", "rms"),
                ("no tube, K, rms", "spricka, no tube", "cpu_s", "rms"),
                ("ccx, K1 rms", "ccx", "cpu_s", "rms"),
                ("K, rms; flops at dgemm's rate", "spricka", "limit_s", "rms")):
            points = [(float(row[cost]), float(row[column])) for row in rows
                      if row["problem"] == problem and row["program"] == program]
            if points:
                panel.curves[name] = sorted(points)
        if panel.curves:
            panels.append(panel)
    chart.sheet(path, [panels])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spricka", type=Path, default=TOP / "build/release/bin/spricka")
    parser.add_argument("--only", choices=list(PROBLEMS))
    parser.add_argument("--ccx", type=int, default=0, metavar="LEVELS")
    parser.add_argument("--repeat", type=int, default=2)
    parser.add_argument("--out", type=Path, default=Path("front_precision.run"))
    arguments = parser.parse_args()
    arguments.spricka = arguments.spricka.resolve()
    arguments.out.mkdir(parents=True, exist_ok=True)
    folder = arguments.out.resolve()
    rows = []
    for problem in [arguments.only] if arguments.only else PROBLEMS:
        found = [lambda size=size: spricka(arguments, problem, size, folder / f"{problem}_free_{size}.deck")
                 for size in FREE]
        for number, level in enumerate(LEVELS):
            deck = folder / f"{problem}_{number}.deck"
            found.append(lambda level=level, deck=deck: spricka(arguments, problem, level, deck))
            if number < arguments.ccx:
                found.append(lambda number=number: ccx(problem, number, folder))
        for run in found:
            row = run()
            if row is None:
                continue
            row |= {key: f"{row[key]:.4g}" for key in COLUMNS[9:] if key in row}
            print(row, flush=True)
            rows.append(row)
    table = folder / "work_precision_front.csv"
    if arguments.only and table.exists():
        with open(table, encoding="utf-8", newline="") as file:
            known = csv.DictReader(line for line in file if not line.startswith("#"))
            rows += [row for row in known if row["problem"] != arguments.only]
    rows.sort(key=lambda row: list(PROBLEMS).index(row["problem"]))
    with open(table, "w", encoding="utf-8", newline="") as file:
        file.write("# errors in % of the largest K along the front, all modes and points; of ccx K1 "
                   "under tension\n")
        writer = csv.DictWriter(file, COLUMNS, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    draw(rows, folder / "work_precision_front.svg")


if __name__ == "__main__":
    main()
