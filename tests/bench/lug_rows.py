#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The twelve rows of the paper's lug, read literally (six lengths, one and two cracks), everything
included, against twelve plain assemble-factor-solves of the same lug with 25 458 equations.

usage: lug_rows.py [BUILD] [REPEATS]      BUILD: a release build with bench_plain_lug
"""
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


def plain(build):
    """Number of equations; seconds of twelve solutions by CHOLMOD as it comes and ordered node by
    node, each by METIS and by AMD."""
    out = subprocess.run(
        [os.path.join(build, "tests/bench/bench_plain_lug"),
         os.path.join(ROOT, "decks/lug_single_literal.deck"), FINE, "12"],
        env=dict(os.environ, OPENBLAS_NUM_THREADS="1"), check=True, capture_output=True,
        text=True).stdout
    return int(out.split()[0]), [float(x) for x in re.findall(r"(?:METIS|AMD) ([\d.]+) s", out)]


def rows(build, folder):
    """CPU seconds of both decks, from start to exit of the program."""
    total = 0.0
    for deck in DECKS:
        cost = measure.run([os.path.join(build, "src/run/spricka"), "run", "--threads", "1",
                            os.path.join(ROOT, f"decks/{deck}.deck"), "--out",
                            os.path.join(folder, deck)], folder, deck + ".log")
        if cost.code != 0:
            sys.exit(f"{deck} failed, exit code {cost.code}")
        total += cost.cpu
    return total


def main():
    build = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build/release")
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    ours, floor, equations = 1e9, [1e9] * 4, 0
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(repeats):
            ours = min(ours, rows(os.path.abspath(build), folder))
            equations, seconds = plain(os.path.abspath(build))
            floor = [min(a, b) for a, b in zip(floor, seconds)]
    print(f"twelve rows, everything included: {ours:.3f} s CPU")
    print(f"twelve plain solutions of {equations} equations:")
    for name, seconds in zip(("CHOLMOD as it comes, METIS", "CHOLMOD as it comes, AMD",
                              "ordered by nodes, METIS", "ordered by nodes, AMD"), floor):
        print(f"  {name:<28} {seconds:.3f} s, the rows take {ours / seconds:.2f} times that")


if __name__ == "__main__":
    main()
