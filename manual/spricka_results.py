#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads results.h5 of a run folder of spricka. Needs h5py; tables come as pandas.DataFrame where
pandas is there, else as dictionaries of numpy arrays. One file: copy it where you need it.

    from spricka_results import Results
    r = Results("lug.run/results.h5")
    print(r.k[["step", "a", "K1", "K1_bar"]])            # a table
    x, u = r.mesh(1)["x"], r.field("u", 1, "LOAD")         # [node][direction]

From the command line it prints what a file holds:  spricka_results.py lug.run/results.h5
"""

import sys

import h5py
import numpy as np

try:
    import pandas
except ImportError:
    pandas = None

# Nodes of the element types, by their number in mesh["type"].
ELEMENTS = (
    ("TRIM3", 3), ("TRIMC6", 6), ("QUAM4", 4), ("QUAMC8", 8), ("QUAMC9", 9), ("TET4", 4),
    ("TET10", 10), ("PENTA6", 6), ("PENTAC15", 15), ("HEXE8", 8), ("HEXEC20", 20), ("HEXEC27", 27),
)  # fmt: skip


def plain(value):
    """Texts as str, not bytes."""
    if isinstance(value, bytes):
        return value.decode("utf-8")
    if isinstance(value, np.ndarray) and value.dtype.kind == "S":
        return np.array([v.decode("utf-8") for v in value], dtype=object)
    return value


class Results:
    """One results file, or one increment of a restart file (NAME.rst.d/0001-....h5)."""

    def __init__(self, path):
        self.file = h5py.File(path, "r")
        self.attributes = {name: plain(value) for name, value in self.file.attrs.items()}

    def table(self, name):
        """A table by its path: "k", "increments/0001/steps/LOAD/fronts"; empty if there is none."""
        if name not in self.file:
            return pandas.DataFrame() if pandas else {}
        rows = self.file[name][()]
        columns = {column: plain(rows[column]) for column in rows.dtype.names}
        return pandas.DataFrame(columns) if pandas else columns

    @property
    def k(self):
        """Stress intensity factors by increment, step, crack and point of its front."""
        return self.table("k")

    @property
    def pressure(self):
        """Contact nodes by increment, step and contact."""
        return self.table("pressure")

    @property
    def load_path(self):
        """K at the breakpoints of the load paths."""
        return self.table("load_path")

    @property
    def checks(self):
        return self.table("checks")

    @property
    def deck(self):
        """Texts of the deck and its includes by file name."""
        names = self.table("deck/files")["file"]
        return {n: plain(self.file[f"deck/text_{i + 1}"][0]) for i, n in enumerate(names)}

    def _increment(self, number):
        return self.file[f"increments/{number:04d}"] if "increments" in self.file else self.file

    def increments(self):
        """Their numbers."""
        return sorted(int(name) for name in self.file["increments"])

    def steps(self, number=1):
        """Names of the steps, in their order."""
        return [plain(name) for name in self._increment(number)["order"][()]]

    def mesh(self, number=1):
        """Arrays of the mesh by name: x, node_label, type, first, nodes, element_label, ..."""
        mesh = self._increment(number)["mesh"]
        return {name: mesh[name][()] for name in mesh if mesh[name].dtype.names is None}

    def elements(self, number=1):
        """(type, nodes [element][node]) for each type of the mesh; nodes count from 0."""
        mesh = self.mesh(number)
        found = []
        for code in np.unique(mesh["type"]):
            name, count = ELEMENTS[code]
            first = mesh["first"][:-1][mesh["type"] == code]
            found.append((name, mesh["nodes"][first[:, None] + np.arange(count)]))
        return found

    def field(self, name, number, step):
        """u, reaction, temperature, stress or element_stress at the end of a step; None if it was
        not kept. Stresses are xx yy zz xy yz zx."""
        group = self._increment(number)["steps"][step]
        return group[name][()] if name in group else None


def main():
    if pandas:  # all columns, however many
        pandas.set_option("display.width", None, "display.max_columns", None)
    for path in sys.argv[1:]:
        results = Results(path)
        print(path, results.attributes.get("title", ""))
        for table in ("k", "checks", "growth"):
            if table in results.file:
                print(f"\n{table}\n{results.table(table)}")


if __name__ == "__main__":
    main()
