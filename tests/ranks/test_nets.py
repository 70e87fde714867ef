# SPDX-License-Identifier: GPL-3.0-or-later
"""Nets over ranks: the same files to the last bit, memory as it was forecast, one exit code."""

import os
import re
import subprocess
import unittest
from pathlib import Path

from mpi_runs import CRACKED, MISSING, PROGRAM, TOP, RankTest, environment, main, press_fit

FULL = bool(os.environ.get("SPRICKA_FULL"))
USE = re.compile(r"(\d+) nets, (\d+) unknowns")
# Two solids in contact, whose rows are eliminated with their sparse factors, a crack in the larger one.
SOLIDS = """$DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=LOW
  $MESH SHAPE=BLOCK TYPE=HEXEC20 LX=8 LY=8 LZ=6 NX={n} NY={n} NZ=4
$ENDNET
$NET NAME=UP
  $MESH SHAPE=BLOCK TYPE=HEXEC20 X0=1 Y0=1 Z0=6 LX=6 LY=6 LZ=4 NX={m} NY={m} NZ=3
$ENDNET
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=LOW.BODY MATERIAL=M STATE=SOLID
$PROPERTY ESET=UP.BODY MATERIAL=M STATE=SOLID
$CONTACT NAME=JOINT SLAVE=UP.ZMIN MASTER=LOW.ZMAX
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  LOW.ZMIN
$FREEDOM CLASS=SUPPRESSED DOF=XY
  UP.ZMAX
$LOAD CASE=PRESS TYPE=TRACTION
  UP.ZMAX  0 0 -50
$STEP NAME=PRESSED
  LOAD PRESS 1
$END
"""


@unittest.skipIf(MISSING, MISSING)
class Nets(RankTest):
    def same_on_ranks(self, deck, counts):
        self.expect(0, "run", deck, "--out", "alone.run", "--quiet", "--threads", "1")
        for count in counts:
            self.run_ranks(0, count, "run", deck, "--out", f"{count}.run", "--quiet", "--threads", "1")
            self.same_folders(self.folder / "alone.run", self.folder / f"{count}.run")
            self.assertEqual(len(self.lines_of_ranks(f"{count}.run")), count)
        self.assertEqual(self.lines_of_ranks("alone.run"), [])

    def test_same_bits_in_the_plane(self):
        deck = self.deck(press_fit("FIT", 0.02, 6, 24))
        self.same_on_ranks(deck, (2, 3))
        nets = [int(USE.search(line)[1]) for line in self.lines_of_ranks("2.run")]
        self.assertEqual(nets, [1, 1])  # a body each
        nets = [int(USE.search(line)[1]) for line in self.lines_of_ranks("3.run")]
        self.assertEqual(sorted(nets), [0, 1, 1])

    def test_same_bits_of_a_growth(self):
        self.same_on_ranks(self.deck(CRACKED), (2,))

    def test_same_bits_in_space(self):
        n, m = (30, 28) if FULL else (8, 6)
        self.same_on_ranks(self.deck(SOLIDS.format(n=n, m=m)), (2,))
        for line in self.lines_of_ranks("2.run"):
            self.assertGreater(int(USE.search(line)[2]), 1000)
        self.check_memory_of_ranks("2.run")

    def test_a_refusal_ends_all_ranks(self):
        _, errors = self.run_ranks(3, 2, "run", self.deck(CRACKED.replace("NAME=C ", "NAME=C NOSUCH=1 ")))
        self.assertEqual(errors.count("NOSUCH"), 2, errors)  # the message, and the line of the deck: once
        self.assertFalse((self.folder / "test.run").exists())

    def test_commands_that_solve_nothing(self):
        deck = self.deck(CRACKED)
        output, _ = self.run_ranks(0, 2, "check", deck)
        self.assertEqual(output.count("no mistakes found"), 1, output)
        output, _ = self.run_ranks(0, 2, "help", "CRACK")
        self.assertEqual(output, self.expect(0, "help", "CRACK").stdout)

    def test_another_run_that_it_starts_is_no_rank(self):
        output, _ = self.run_ranks(0, 2, "verify", "patch_test", "--decks", TOP / "decks")
        self.assertEqual(output.count("patch_test "), 1, output)

    def test_without_the_module(self):
        alone = self.folder / "bin" / "spricka"
        alone.parent.mkdir()
        alone.write_bytes(Path(PROGRAM).read_bytes())
        alone.chmod(0o755)
        child = subprocess.run(
            [alone, "run", self.deck(CRACKED)],
            cwd=self.folder,
            env=environment(OMPI_COMM_WORLD_RANK="0", OMPI_COMM_WORLD_SIZE="2"),
            text=True,
            capture_output=True,
            check=False,
        )
        self.assertEqual(child.returncode, 7, child.stderr)
        self.assertIn("libopenmpi-dev", child.stderr)
        self.assertFalse((self.folder / "test.run").exists())


if __name__ == "__main__":
    main()
