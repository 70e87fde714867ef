#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps in which contact and crack methods fail: every row is an answer within its accuracy, an answer with a
warning, or a refusal that names its cause.

    tests/stability/stability.py PROGRAM [--full] [--write] [SWEEP ..]

--full (or SPRICKA_FULL in the environment) runs all rows; --write makes manual/stability.md and manual/stability.csv,
or puts the sweeps that are named into them anew.
"""
import os
import sys

import sweeps_closure
import sweeps_contact
import sweeps_crack
import sweeps_friction
import sweeps_held
import sweeps_lug
import sweeps_tip
import sweeps_tolerance
import sweeps_vce
from stability_page import FAMILIES, record, write

SWEEPS = {
    "LAW": sweeps_contact.pressure_laws,
    "S02": sweeps_contact.no_penalty,
    "S03": sweeps_contact.clearance,
    "S04": sweeps_friction.friction,
    "S05": sweeps_closure.closure,
    "C07": sweeps_contact.load_independence,
    "S07": sweeps_contact.contrast,
    "S10": sweeps_held.floating,
    "S11": sweeps_held.redundant,
    "ASM": sweeps_held.assembly,
    "S01": sweeps_crack.distortion,
    "S08": sweeps_crack.ligament,
    "S09": sweeps_crack.short_crack,
    "S12": sweeps_tip.tip_mesh,
    "S06": sweeps_vce.shifts,
    "ANY": sweeps_crack.any_crack,
    "X01": sweeps_tip.square_lug,
    "TOL": sweeps_tolerance.tolerance,
    "LUG": sweeps_lug.lug,
}


def cell(value):
    return "" if value is None else f"{value:.6g}"


def table(rows):
    out = ["| case | outcome | found | reference | error | allowed | s |\n", "|---|---|---|---|---|---|---|\n"]
    for r in rows:
        outcome = r.outcome + (f": {r.words}" if r.words else "") + ("" if r.ok else " **wrong**")
        error = "" if r.error is None else f"{r.error:.1e}"
        allowed = "" if r.allowed is None else f"{r.allowed:.0e}"
        out.append(f"| {r.case} | {outcome} | {cell(r.number)} | {cell(r.reference)} | {error} | {allowed} | "
                   f"{r.seconds:.2f} |\n")
    return "".join(out)


def main():
    words = [w for w in sys.argv[2:] if not w.startswith("--")]
    full = "--full" in sys.argv or "SPRICKA_FULL" in os.environ
    records, wrong = [], 0
    for name, sweep in SWEEPS.items():
        if words and name not in words:
            continue
        rows = sweep(sys.argv[1], full)
        wrong += sum(not row.ok for row in rows)
        records += [record(name, row) for row in rows]
        print(f"## {name}: {FAMILIES[name][0]}\n\n{table(rows)}")
    if "--write" in sys.argv:
        write(records)
    print(f"{wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
