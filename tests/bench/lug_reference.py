#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""K1 of the paper's lug with one crack or two, a/R = 0.3, literal reading, to 1e-6: meshes of 1/2, 1/4 and 1/8 of the
lug's sizes with a patch cut in, of 2/3, 1/3 and 1/6 with one joined by ties, and the limits of both (Aitken 1926).

    tests/bench/lug_reference.py [--spricka PROGRAM] [--deck single|double] [--out FOLDER]

Prints K1 (of two cracks the mean) of both steps, the order found and the limits. Needs nothing but python3; some
minutes on one thread.
"""
import argparse
import csv
import math
import re
import statistics
import subprocess
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
STEPS = ("PRESS", "LOAD")
# Keys of $TIPNET, and the finest of three divisions of all sizes, each twice that of the one before.
SETTINGS = {"cut in": ("", 8), "joined by ties": (" JOIN=TRANSITION", 6)}


def deck_of(name, fine, patch):
    text = (TOP / "decks" / f"lug_{name}_literal.deck").read_text(encoding="utf-8")
    text = text[:text.index("$CHECK")] + "$END\n"
    lengths = text[text.index("  (0.05*R) (0.10*R)"):].splitlines()[0]
    text = text.replace(lengths, "  (0.30*R)")
    cards = "".join(f"$TIPNET CRACK={crack} FINER={fine}{patch}\n"
                    for crack in re.findall(r"^\$CRACK NAME=(\w+)", text, flags=re.M))
    text = text.replace("$STEP NAME=PRESS", cards + "$STEP NAME=PRESS", 1)
    return text.replace("  fine = 0.75 ", f"  fine = {fine} ", 1)


def solve(program, folder, name, deck):
    file = folder / f"{name}.deck"
    file.write_text(deck, encoding="utf-8")
    out = folder / f"{name}.run"
    subprocess.run([program, "run", file, "--threads", "1", "--quiet", "--out", out], check=True)
    with open(out / "k.csv", encoding="utf-8") as rows:
        found = list(csv.DictReader(line for line in rows if not line.startswith("#")))
    return [statistics.fmean(float(row["K1"]) for row in found if row["step"] == step) for step in STEPS]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spricka", type=Path, default=TOP / "build/release/bin/spricka")
    parser.add_argument("--deck", choices=("single", "double"), default="single")
    parser.add_argument("--out", type=Path, default=Path("lug_reference.run"))
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for part in list((TOP / "decks").glob("lug_*.inc")) + [TOP / "decks" / f"{name}.geo"
                                                           for name in ("lug", "sleeve", "shaft")]:
        (arguments.out / part.name).write_text(part.read_text(encoding="utf-8"), encoding="utf-8")
    limits = {step: [] for step in STEPS}
    for setting, (patch, most) in SETTINGS.items():
        K = []
        for fine in (most / 4, most / 2, most):
            K.append(solve(arguments.spricka, arguments.out.resolve(), f"fine_{fine:g}",
                           deck_of(arguments.deck, fine, patch)))
            print(f"{setting}: fine = {fine:g}, K1 =", " ".join(f"{k:.7g}" for k in K[-1]), flush=True)
        for step, (coarse, middle, finest) in zip(STEPS, zip(*K)):
            ratio = (middle - coarse) / (finest - middle)
            limits[step].append(finest + (finest - middle) / (ratio - 1.0))
            print(f"  {step}: order {math.log2(ratio):.2f}, limit {limits[step][-1]:.8g}")
    for step, (one, other) in limits.items():
        print(f"{step}: {0.5 * (one + other):.7g}, the two apart by {abs(one - other) / one:.1e}")


if __name__ == "__main__":
    main()
