# SPDX-License-Identifier: GPL-3.0-or-later
"""Input files of other programs that say more than the mesh: bars and loads are passed over with a word,
never silently, and never where they carry load."""

from program import ProgramTest, main

# Two quadrilaterals, with the curve along y = 0 as gmsh writes it.
MESH = """*NODE
 1, 0, 0, 0
 2, 1, 0, 0
 3, 2, 0, 0
 4, 0, 1, 0
 5, 1, 1, 0
 6, 2, 1, 0
*ELEMENT, TYPE=T3D2, ELSET=Line1
 11, 1, 2
 12, 2, 3
*ELEMENT, TYPE=CPS4, ELSET=Surface1
 21, 1, 2, 5, 4
 22, 2, 3, 6, 5
*ELSET, ELSET=LOWER
 11, 12
*ELSET, ELSET=BODY
 21, 22
*NSET, NSET=LEFT
 1, 4
*NSET, NSET=RIGHT
 3, 6
"""
LOADS = """*BOUNDARY
 LEFT, 1, 2
*AMPLITUDE, NAME=A
 0., 0., 1., 1.
*STEP
*STATIC
 1., 1.
*CLOAD
 6, 1, 5.
*NODE FILE
 U
*END STEP
"""
DECK = """$DECK VERSION=1 LENGTH=MM FORCE=N
$IMPORT FILE='a.inp' FORMAT=INP {skip}
$MATERIAL NAME=M E=1000 NU=0
$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  LEFT
$LOAD CASE=PULL TYPE=TRACTION
  RIGHT 10 0
$STEP NAME=S
  LOAD PULL 1
$CHECK
  U.X.MAX(RIGHT,S) = 0.02 REL 1e-9 SOURCE 'bar: s L / E'
$END
"""


class Imports(ProgramTest):
    def messages(self, code, inp, skip="", command="check"):
        (self.folder / "a.inp").write_text(inp, encoding="utf-8")
        return self.expect(code, command, self.deck(DECK.format(skip=skip))).stderr

    def test_bars_of_curves_are_face_sets(self):
        held = "$FREEDOM CLASS=SUPPRESSED DOF=Y\n  LOWER\n$LOAD CASE=PULL"
        (self.folder / "a.inp").write_text(MESH, encoding="utf-8")
        deck = DECK.format(skip="").replace("$LOAD CASE=PULL", held)
        errors = self.expect(0, "run", self.deck(deck)).stderr
        self.assertIn("warning W466", errors)
        self.assertIn("their sets are taken as surfaces: 2 T3D2", errors)
        self.assertNotIn("W466", self.messages(0, MESH.replace("*ELEMENT, TYPE=T3D2, ELSET=Line1\n 11, 1, 2\n 12, 2, 3\n", "").replace("*ELSET, ELSET=LOWER\n 11, 12\n", "")))

    def test_bars_that_carry_load_are_refused(self):
        section = "*MATERIAL, NAME=M1\n*ELASTIC\n 1000., 0.\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M1\n 1.\n"
        errors = self.messages(3, MESH + section)
        self.assertIn("error E336", errors)
        self.assertIn("holds bars", errors)

    def test_loads_are_passed_over_when_asked(self):
        errors = self.messages(3, MESH + LOADS)
        self.assertIn("*BOUNDARY is not imported", errors)
        self.assertIn("SKIP=LOADS", errors)
        errors = self.messages(0, MESH + LOADS, "SKIP=LOADS", command="run")
        self.assertIn("warning W467", errors)
        for word in ("*BOUNDARY (1, line ", "*STEP (1, line ", "*CLOAD (1, line ", "*AMPLITUDE (1, line "):
            self.assertIn(word, errors)
        # what changes the model itself is not passed over
        tie = MESH + LOADS + "*TIE, NAME=T\n A, B\n"
        self.assertIn("SKIP=ALL passes over it", self.messages(3, tie, "SKIP=LOADS"))
        errors = self.messages(0, tie, "SKIP=ALL", command="run")
        self.assertIn("warning W468: a.inp: left out, though the model is another one without: *TIE (1, line 34)", errors)


if __name__ == "__main__":
    main()
