#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps in which contact and crack methods fail: every row is an answer within its accuracy, an answer with a
warning, or a refusal that names its cause.

    tests/stability/stability.py PROGRAM [--full] [--write] [SWEEP ..]

--full (or SPRICKA_FULL in the environment) runs all rows; --write makes manual/stability.md, or makes the
sections of the sweeps named anew.
"""
import os
import re
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
from program import TOP

SWEEPS = {
    "LAW": ("pressure along the surface against closed forms (L2)", sweeps_contact.pressure_laws),
    "S02": ("no penalty: settings change nothing", sweeps_contact.no_penalty),
    "S03": ("clearance through zero into interference (half angle of contact, degrees)",
            sweeps_contact.clearance),
    "S04": ("friction from zero to far beyond one", sweeps_friction.friction),
    "S05": ("crack tips and mouths near the edge of a contact (F = K over that of uniform tension; K1)",
            sweeps_closure.closure),
    "C07": ("net fit: the load does not matter", sweeps_contact.load_independence),
    "S07": ("contrast of moduli and units", sweeps_contact.contrast),
    "S10": ("bodies held by contact only", sweeps_held.floating),
    "S11": ("redundant constraints", sweeps_held.redundant),
    "ASM": ("assembly in steps and undone (K1, pressures)", sweeps_held.assembly),
    "S01": ("cracks in distorted, turned and stretched meshes (K)", sweeps_crack.distortion),
    "S08": ("thin ligaments (F = K / sqrt(pi a))", sweeps_crack.ligament),
    "S09": ("cracks shorter than an element (F)", sweeps_crack.short_crack),
    "S12": ("elements at the tip (F)", sweeps_tip.tip_mesh),
    "S06": ("step of the virtual crack extension (K1 against the analytic derivative)", sweeps_vce.shifts),
    "ANY": ("random cracks in three nets, both joins (spread of K)", sweeps_crack.any_crack),
    "X01": ("square lug, sleeve and shaft: mean pressures and separation", sweeps_tip.square_lug),
    "TOL": ("K of the lug to a tolerance, from coarse meshes (error over K1 and bar)", sweeps_tolerance.tolerance),
    "LUG": ("pairings, mirrors, turns and units of the lug (K1)", sweeps_lug.lug),
}

HEAD = """# Stability

Sweeps in which contact and crack methods are known to fail, made by `tests/stability/stability.py PROGRAM --full
--write`; the tests run a part of them daily and all with `tests/run --full`. Each row is an answer (with its
error and what is allowed), an answer with a warning, or a refusal that says why. A wrong answer without
a word is a failure of the test. Times are wall seconds of one run, one thread.

"""


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


def write(parts):
    """Puts sections [name] into manual/stability.md, beside those it has, in the order of SWEEPS."""
    path = TOP / "manual" / "stability.md"
    old = path.read_text(encoding="utf-8") if path.exists() else ""
    for section in re.split(r"^(?=## )", old, flags=re.M)[1:]:
        parts.setdefault(section[3:6], section.rstrip() + "\n\n")
    text = HEAD + "".join(parts[name] for name in SWEEPS if name in parts)
    path.write_text(text.rstrip() + "\n", encoding="utf-8")


def main():
    words = [w for w in sys.argv[2:] if not w.startswith("--")]
    full = "--full" in sys.argv or "SPRICKA_FULL" in os.environ
    parts, wrong = {}, 0
    for name, (title, sweep) in SWEEPS.items():
        if words and name not in words:
            continue
        rows = sweep(sys.argv[1], full)
        wrong += sum(not row.ok for row in rows)
        parts[name] = f"## {name}: {title}\n\n{table(rows)}\n"
        print(parts[name])
    if "--write" in sys.argv:
        write(parts)
    print(f"{wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
