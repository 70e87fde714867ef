# SPDX-License-Identifier: GPL-3.0-or-later
"""One net by MUMPS over all ranks: pressures and K of the lug and of a solid with a crack are those of Cholesky."""

import csv
import os
import unittest

from mpi_runs import MISSING, MODULE, RankTest, corner, main

FULL = bool(os.environ.get("SPRICKA_FULL"))
SAME = 1e-10
TABLES = {"k.csv": {"K1", "K2", "K3", "G", "T"}, "front.csv": {"K1", "K2", "K3", "G", "T"}, "pressure.csv": {"p_lumped", "p_consistent"}}

BLOCK = """$DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=TET10 LX=1 LY=1 LZ=1 NX=4 NY=4 NZ=4
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  ZMIN
$LOAD CASE=PULL TYPE=TRACTION
  ZMAX  0 0 1
$STEP NAME=PULLED
  LOAD PULL 1
$END
"""


@unittest.skipIf(MISSING, MISSING)
class Mumps(RankTest):
    def numbers(self, folder):
        """K, G and T of all fronts, and contact pressures, by table and column."""
        found = {}
        for table, wanted in TABLES.items():
            if not (self.folder / folder / table).exists():
                continue
            with (self.folder / folder / table).open(encoding="utf-8") as file:
                for row in csv.DictReader(line for line in file if line[0] != "#"):
                    for name in wanted.intersection(row):
                        found.setdefault((table, name), []).append(float(row[name]))
        return found

    def check_same(self, one, other):
        """Every number, against the largest of its column."""
        a, b = self.numbers(one), self.numbers(other)
        self.assertEqual(a.keys(), b.keys())
        self.assertIn("K1", {name for _, name in a})
        for column, values in a.items():
            largest = max(map(abs, values))
            for x, y in zip(values, b[column], strict=True):
                self.assertLessEqual(abs(x - y), SAME * largest, (column, x, y))

    def same_as_cholesky(self, deck):
        self.expect(0, "run", deck, "--out", "cholesky.run", "--quiet", "--engine", "cholesky")
        for count in (2, 4) if FULL else (2,):
            with self.subTest(ranks=count):
                out = f"{count}.run"
                self.run_ranks(0, count, "run", deck, "--out", out, "--quiet", "--engine", "mumps")
                self.check_same("cholesky.run", out)
                self.assertIn("by MUMPS over all ranks", self.lines_of_ranks(out)[1])

    def test_lug(self):
        deck = self.copy_deck("lug_single")
        text = deck.read_text(encoding="utf-8")
        one_length = "$GROW LAW=INCREMENT KMAX=LOAD KMIN=UNLOAD\n  (0.2*R)\n$END\n"
        self.same_as_cholesky(self.deck(text[: text.index("$GROW")] + one_length))

    def test_solid_with_a_crack(self):
        text = corner("ELLIPSE")
        self.same_as_cholesky(self.deck(text[: text.index("$GROW")] + "$END\n"))

    def test_multigrid_of_rank_0_ends_with_the_run(self):
        # Both are users of MPI: who ends it first must not leave the other with calls that abort the run.
        if not MODULE.with_name("spricka-multigrid.so").exists():
            self.skipTest("built without PETSc")
        n = 14 if FULL else 8
        deck = self.deck(BLOCK.replace("NX=4 NY=4 NZ=4", f"NX={n} NY={n} NZ={n}"))
        self.run_ranks(0, 2, "run", deck, "--out", "iterated.run", "--quiet", "--engine", "multigrid")
        self.check_memory_of_ranks("iterated.run")
        self.run_ranks(0, 2, "run", deck, "--out", "mumps.run", "--quiet", "--engine", "mumps")
        self.check_memory_of_ranks("mumps.run")

    def test_bodies_in_contact_without_loads(self):
        deck = self.copy_deck("press_fit_solid")
        self.run_ranks(0, 2, "run", deck, "--out", "fit.run", "--quiet", "--engine", "mumps")
        self.check_memory_of_ranks("fit.run")


if __name__ == "__main__":
    main()
