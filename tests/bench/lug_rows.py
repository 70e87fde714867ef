#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The twelve rows of the paper's lug, read literally (six lengths, one and two cracks), everything
included, against twelve plain assemble-factor-solves of the same lug with 25 458 equations. On the
meshes of the decks, and on finer ones; beside each the largest error of its K1, against meshes four
times as fine as lug_model.inc has.

usage: lug_rows.py [BUILD] [REPEATS]      BUILD: a release build with bench_plain_lug
"""
import csv
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FINE = "1.5"  # of the lug with one crack: 25 496 equations
DECKS = ("lug_single_literal", "lug_double_literal")
MESHES = (None, "1", "1.5")  # None: as the decks come
BEST = "4"


def plain(build):
    """Number of equations; seconds of twelve solutions by CHOLMOD as it comes and ordered node by
    node, each by METIS and by AMD."""
    out = subprocess.run(
        [os.path.join(build, "tests/bench/bench_plain_lug"),
         os.path.join(ROOT, "decks/lug_single_literal.deck"), FINE, "12"],
        env=dict(os.environ, OPENBLAS_NUM_THREADS="1"), check=True, capture_output=True,
        text=True).stdout
    return int(out.split()[0]), [float(x) for x in re.findall(r"(?:METIS|AMD) ([\d.]+) s", out)]


def rows(build, folder, mesh):
    """CPU seconds of both decks, from start to exit of the program; K1 of all their rows."""
    total = 0.0
    K1 = []
    for deck in DECKS:
        command = [os.path.join(build, "bin/spricka"), "run", "--threads", "1",
                   os.path.join(ROOT, f"decks/{deck}.deck"), "--out", os.path.join(folder, deck)]
        cost = measure.run(command + (["-D", f"fine={mesh}"] if mesh else []), folder, deck + ".log")
        if cost.code != 0 and mesh is None:
            sys.exit(f"{deck} failed, exit code {cost.code}")
        total += cost.cpu
        with open(os.path.join(folder, deck, "k.csv"), encoding="utf-8") as table:
            rows_of = csv.DictReader(line for line in table if not line.startswith("#"))
            K1 += [float(row["K1"]) for row in rows_of if row["step"] == "LOAD"]
    return total, K1


def main():
    build = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build/release")
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    ours, floor, equations = dict.fromkeys(MESHES, 1e9), [1e9] * 4, 0
    K1 = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(repeats):
            for mesh in MESHES:
                cpu, K1[mesh] = rows(os.path.abspath(build), folder, mesh)
                ours[mesh] = min(ours[mesh], cpu)
            equations, seconds = plain(os.path.abspath(build))
            floor = [min(a, b) for a, b in zip(floor, seconds)]
        best = rows(os.path.abspath(build), folder, BEST)[1]
    print("twelve rows, everything included:")
    for mesh in MESHES:
        error = max(abs(a / b - 1.0) for a, b in zip(K1[mesh], best))
        print(f"  fine = {mesh or 'as it comes':<12} {ours[mesh]:.3f} s CPU, K1 to "
              f"{100.0 * error:.3f} %, {ours[mesh] / floor[0]:.2f} times CHOLMOD by METIS")
    print(f"twelve plain solutions of {equations} equations:")
    for name, seconds in zip(("CHOLMOD as it comes, METIS", "CHOLMOD as it comes, AMD",
                              "ordered by nodes, METIS", "ordered by nodes, AMD"), floor):
        print(f"  {name:<28} {seconds:.3f} s")


if __name__ == "__main__":
    main()
