#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the shipped decks with two programs and compares every number of their tables by a rule.

    tests/bench/compare_programs.py OLD NEW [--rule same|merge|mesh] [--most CPU] [--keep FOLDER] [DECK ..]

same   the same bits: for changes that are to change nothing.
merge  K, pressures and all other results to 1e-9 of the largest in their table, lengths and lives to 1e-7, to 1e-6
       where a front breaks through or joins another: for changes that merge two pieces of code into one.
mesh   K within its error bars and to 1e-4 of the largest, lives to 1e-3: for changes that number or place nodes
       otherwise. Name the decks in the commit.

Without names all decks of decks/costs.csv that take at most CPU seconds (default 20). With --keep the runs of OLD stay
in FOLDER and are not done again. Derivatives are differences of results: ten times as much of theirs. Exit code 1: a
deck is outside the rule.
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

DECKS = pathlib.Path(__file__).resolve().parents[2] / "decks"
RESULT = {"same": 0.0, "merge": 1e-9, "mesh": 1e-4}  # of the largest of its kind
LIFE = {"same": 0.0, "merge": 1e-7, "mesh": 1e-3}
JOINED_LIFE = {"same": 0.0, "merge": 1e-6, "mesh": 1e-3}
DERIVATIVE = 10.0
INTENSITIES = {"K1", "K2", "K3", "K1_smooth", "K2_smooth", "K3_smooth", "K1_raw", "K2_raw", "K3_raw"}
LENGTHS_AND_LIVES = {"a", "c", "s", "N", "da", "x", "y", "z", "phi", "dN"}
EVENTS = ("PASSAGE", "JOIN", "breaks through", "joins")
# Estimates of errors and numbers of a direction that may be any where its vector is nil.
NO_RESULTS = {"spread", "K1_bar", "K2_bar", "K3_bar"}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("decks", nargs="*", metavar="DECK")
    parser.add_argument("--rule", choices=RESULT, default="merge")
    parser.add_argument("--most", type=float, default=20.0, metavar="CPU")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER")
    return parser.parse_intermixed_args()


def table(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def run(program, deck, folder):
    """The folder of the run, and its exit code."""
    code = folder.parent / f"{folder.name}.code"
    if not code.exists():
        done = subprocess.run([program, "run", DECKS / f"{deck}.deck", "--out", folder, "--threads", "1", "--quiet"],
                              capture_output=True, check=False)
        code.write_text(str(done.returncode), encoding="utf-8")
    return int(code.read_text(encoding="utf-8"))


def value_of(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def kind_of(column):
    """K of all modes are of one kind, and so are their derivatives and coordinates."""
    if column in INTENSITIES:
        return "K"
    if column.startswith("dK"):
        return "dK"
    return "x" if column in ("x", "y", "z") else column


def scales(rows):
    """The largest magnitude of each kind of column."""
    largest = {}
    for row in rows:
        for column, text in row.items():
            value = value_of(text)
            if value is not None:
                kind = kind_of(column)
                largest[kind] = max(largest.get(kind, 0.0), abs(value))
    return largest


def allowed(rule, name, column, joined):
    if column in LENGTHS_AND_LIVES and name != "pressure.csv":
        return (JOINED_LIFE if joined else LIFE)[rule]
    return RESULT[rule] * (DERIVATIVE if name == "sensitivity.csv" else 1.0)


def compare_tables(rule, name, old, new, joined):
    """What parts by more than the rule, and the largest part of what it allows."""
    if [set(row) for row in old[:1]] != [set(row) for row in new[:1]] or len(old) != len(new):
        return [f"{name}: {len(old)} rows, now {len(new)}, or other columns"], float("inf")
    largest = scales(old)
    faults = {}
    worst = 0.0
    for before, after in zip(old, new):
        for column, text in before.items():
            if text == after[column]:
                continue
            one, two = value_of(text), value_of(after[column])
            scale = largest.get(kind_of(column), 0.0)
            if one is None or two is None or scale == 0.0:
                part = float("inf")
            elif column in NO_RESULTS and rule != "same":
                continue
            else:
                part = abs(one - two) / scale
                bar = value_of(before.get(f"{column}_bar"))
                if rule == "mesh" and bar is not None and abs(one - two) > bar:
                    part = float("inf")
            limit = allowed(rule, name, column, joined)
            worst = max(worst, part)
            if part > limit:
                faults[column] = max(part, faults.get(column, 0.0))
    return [f"{name} {column} parts by {part:.1e}" for column, part in faults.items()], worst


def compare(rule, old, new):
    """Faults of one deck, and the largest difference."""
    names = [sorted(path.name for path in folder.glob("*.csv")) for folder in (old, new)]
    faults = [] if names[0] == names[1] else [f"other tables: {names[0]}, now {names[1]}"]
    if not names[0]:
        faults.append("no tables: nothing was compared")
    listing = old / "listing.txt"
    joined = listing.exists() and any(word in listing.read_text(encoding="utf-8") for word in EVENTS)
    worst = 0.0
    for name in sorted(set(names[0]) & set(names[1])):
        found, part = compare_tables(rule, name, table(old / name), table(new / name), joined)
        faults += found
        worst = max(worst, part)
    return faults, worst


def main():
    asked = arguments()
    decks = asked.decks or [row["deck"] for row in table(DECKS / "costs.csv") if float(row["cpu"]) <= asked.most]
    outside = 0
    with tempfile.TemporaryDirectory() as place:
        kept = asked.keep or pathlib.Path(place) / "old"
        kept.mkdir(parents=True, exist_ok=True)
        fresh = pathlib.Path(place) / "new"
        fresh.mkdir()
        for deck in decks:
            codes = run(asked.old, deck, kept / deck), run(asked.new, deck, fresh / deck)
            faults, worst = compare(asked.rule, kept / deck, fresh / deck)
            if codes[0] != codes[1]:
                faults.insert(0, f"exit code {codes[0]}, now {codes[1]}")
            outside += bool(faults)
            verdict = "; ".join(faults) if faults else "the same" if worst == 0.0 else f"to {worst:.1e}"
            print(f"{deck:34} {verdict}", flush=True)
    print(f"{len(decks)} decks, {outside} outside the rule '{asked.rule}'")
    sys.exit(1 if outside else 0)


if __name__ == "__main__":
    main()
