# SPDX-License-Identifier: GPL-3.0-or-later
"""A square from a geometry script, and a deck that imports it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "terminal"))

from program import ProgramTest  # noqa: E402  (the folder is known only now)

SQUARE = """Point(1) = {0, 0, 0, 0.5}; Point(2) = {1, 0, 0, 0.5};
Point(3) = {1, 1, 0, 0.5}; Point(4) = {0, 1, 0, 0.5};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("BODY") = {1}; Physical Curve("LOW") = {1}; Physical Curve("TOP") = {3};
Mesh.ElementOrder = 2;
"""

DECK = """$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Square'
$IMPORT FILE='{file}' FORMAT={form}
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=BODY MATERIAL=STEEL STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LOW
$LOAD CASE=PULL TYPE=TRACTION
  TOP  0  100
$STEP NAME=LOAD
  LOAD PULL 1
$END
"""


class MeshTest(ProgramTest):
    """Imports files that tests write."""

    def square(self, more="", before="", name="x.geo", form="GEO"):
        """A deck with the square; `more` and `before` stand round it in its script."""
        (self.folder / name).write_text(before + SQUARE + more)
        return self.deck(DECK.replace("{file}", name).replace("{form}", form))

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())

    def refused(self, code, words, deck, *options):
        result = self.expect(3, "check", deck, *options)
        self.assertIn(f"error {code}: ", result.stderr)
        self.assertIn(words, result.stderr)
        return result.stderr
