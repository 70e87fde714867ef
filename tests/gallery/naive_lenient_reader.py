# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: a reader that counts the cards it does not know and goes on, and a solver that goes on as well."""
import numpy as np

from naive_soft_springs import solved_anyway
from plane import Material, edge_load, solve, stiffness

KNOWN = {"DECK", "MESH", "MATERIAL", "PROPERTY", "FREEDOM", "LOAD", "STEP", "CHECK", "END"}


def cards(text):
    """Names of the cards, and how many are passed over."""
    names = [line[1:].split()[0].upper() for line in text.splitlines() if line.startswith("$")]
    return [n for n in names if n in KNOWN], sum(n not in KNOWN for n in names)


def stretched_block(text, grid):
    """Largest displacement of the block that decks/broken_*.deck describe: 10 by 10, pulled by 1 on top, its supports
    as far as they are understood."""
    known, passed = cards(text)
    mesh = grid(np.linspace(0, 10, 5), np.linspace(0, 10, 5), "Q8", Material(1000.0, 0.3))
    f = edge_load(mesh, mesh.edges_in(np.flatnonzero(np.abs(mesh.x[:, 1] - 10) < 1e-9)), lambda *_: (0.0, 1.0))
    foot = np.flatnonzero(mesh.x[:, 1] < 1e-9)
    K = stiffness(mesh)
    u = solve(K, f, np.r_[2 * foot, 2 * foot + 1]) if "FREEDOM" in known else solved_anyway(K, f)
    return np.abs(u).max(), passed
