# SPDX-License-Identifier: GPL-3.0-or-later
"""A fit is one number, however it is given: DIAMETRAL and GAP pass through zero."""

import csv
import math

from program import ProgramTest, main

# A pin of radius 10 in a ring of 30, both of one material in plane stress.
DECK = """$DECK VERSION=1 LENGTH=MM FORCE=N
$PARAMETER
  d = 0.02
$NET NAME=RING
  $MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR=6 NT=24
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=3 RO=10 NR=4 NT=24
$ENDNET
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=RING.BODY MATERIAL=STEEL STATE=STRESS THICK=1
$PROPERTY ESET=PIN.BODY MATERIAL=STEEL STATE=STRESS THICK=1
$CONTACT NAME=C SLAVE=PIN.OUTER MASTER=RING.INNER {fit}
$FREEDOM CLASS=SUPPRESSED DOF=XY
  PIN.INNER
  RING.OUTER
$STEP NAME=PRESS
  FIT C 1
{more}$END
"""


class Fits(ProgramTest):
    def pressures(self, fit, more=""):
        self.deck(DECK.format(fit=fit, more=more))
        self.expect(0, "run", "test.deck", "--out", "out", "--quiet")
        return (self.folder / "out" / "pressure.csv").read_text(encoding="utf-8")

    def test_one_fit_in_three_words(self):
        overlap = self.pressures("INTERFERENCE=0.01")
        self.assertEqual(self.pressures("DIAMETRAL=0.02"), overlap)
        self.assertEqual(self.pressures("GAP=-0.01"), overlap)
        clearance = self.pressures("GAP=0.01")
        self.assertEqual(self.pressures("DIAMETRAL=-0.02"), clearance)
        self.assertNotEqual(clearance, overlap)
        self.assertIn("E109", self.run_program("check", self.deck(DECK.format(fit="INTERFERENCE=-0.01", more=""))).stderr)

    def test_a_sweep_from_overlap_to_clearance(self):
        """The pressure is proportional to the overlap (linear elasticity) and 0 from 0 on."""
        sweep = "$SWEEP PARAMETER=d\n  0.02 0.01 0 -0.01 -0.02\n"
        self.deck(DECK.format(fit="DIAMETRAL=(d)", more=sweep))
        self.expect(0, "run", "test.deck", "--out", "out", "--quiet")
        lines = (self.folder / "out" / "sweep.csv").read_text(encoding="utf-8").splitlines()
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        self.assertEqual([row["status"] for row in rows], ["done"] * 5)
        mean = [float(row["PMAX:C:PRESS:1"] or 0.0) for row in rows]
        self.assertGreater(mean[0], 10.0)
        self.assertTrue(math.isclose(mean[0], 2.0 * mean[1], rel_tol=1e-9), mean)
        for none in mean[2:]:
            self.assertLess(abs(none), 1e-9 * mean[0])


if __name__ == "__main__":
    main()
