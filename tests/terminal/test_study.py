# SPDX-License-Identifier: GPL-3.0-or-later
"""Work against precision of decks that the program has never seen, and the ladder of their models."""

import csv
import re
import shutil
import unittest

from program import TOP, ProgramTest, main

# A ring under inner pressure: smooth everywhere. Numbers of elements stand on the card.
RING = """$DECK VERSION=1 LENGTH=MM FORCE=N
$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR=10 NT=10 T1=90[deg]
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=1
$NSET NAME=BOTTOM WHERE=(abs(y) < 1e-6)
$NSET NAME=LEFT WHERE=(abs(x) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=Y
  BOTTOM
$FREEDOM CLASS=SUPPRESSED DOF=X
  LEFT
$LOAD CASE=P TYPE=PRESSURE
  INNER  10
$STEP NAME=LOAD
  LOAD P 1
$END
"""

# An edge crack; `density` is a name of its own for the number of elements, b is none of the mesh.
STRIP = """$DECK VERSION=1 LENGTH=MM FORCE=N
$PARAMETER
  b = 10
  density = 4
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=(b) LY=(4*b) NX=(2*density) NY=(8*density)
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=1
$NSET NAME=CORNER WHERE=(x > b - 1e-6 and abs(y - 2*b) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  CORNER
$NSET NAME=FAR WHERE=(x > b - 1e-6 and y < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=X
  FAR
$CRACK NAME=C ANGLE=0 A0=5
  0  (2*b)
$LOAD CASE=PULL TYPE=TRACTION
  YMAX  0  1
  YMIN  0  -1
$STEP NAME=LOAD
  LOAD PULL 1
$END
"""

# A whole ring, held outside, with two cracks at its bore.
TWICE_CRACKED_RING = """$DECK VERSION=1 LENGTH=MM FORCE=N
$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR=8 NT=32
$MATERIAL NAME=M E=1000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=STRAIN THICK=1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  OUTER
$CRACK NAME=R
  10 0
  14 0
$CRACK NAME=L
  -10 0
  -14 0
$LOAD CASE=P TYPE=PRESSURE
  INNER  10
$STEP NAME=LOAD
  LOAD P 1
$END
"""

# The same ring by a script that maps it; its numbers of elements are no business of the deck. Lame: the
# displacement of the bore is p a^2 (1+nu) ((1-2nu) a + b^2/a) / (E (b^2-a^2)), the hoop stress there 12.5.
MAPPED_SCRIPT = """DefineConstant[ n = 6, order = 2 ];
Mesh.ElementOrder = order;
Mesh.SecondOrderIncomplete = 1;
Point(1) = {0, 0, 0};
Point(2) = {10, 0, 0};
Point(3) = {30, 0, 0};
Point(4) = {0, 30, 0};
Point(5) = {0, 10, 0};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1, 2, 3, 4} = n + 1;
Transfinite Surface{1};
Recombine Surface{1};
Physical Surface("BODY") = {1};
Physical Curve("INNER") = {4};
"""
MAPPED = RING.replace("$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR=10 NT=10 T1=90[deg]",
                      "$IMPORT FILE='ring.geo' FORMAT=GEO").replace("$END\n", """$CHECK
  U.X.AT(10,0,LOAD) = 0.15275  REL 0.01  SOURCE 'Lame'
  S.YY.AT(10,0,LOAD) = 12.5  REL 0.1  SOURCE 'Lame'
$END
""")

# A pin pressed into a ring, both of one material in plane stress.
FIT = """$DECK VERSION=1 LENGTH=MM FORCE=N
$NET NAME=RING
  $MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR=6 NT=24
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=10 NR=4 NT=24
$ENDNET
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=RING.BODY MATERIAL=STEEL STATE=STRESS THICK=1
$PROPERTY ESET=PIN.BODY MATERIAL=STEEL STATE=STRESS THICK=1
$CONTACT NAME=C SLAVE=PIN.OUTER MASTER=RING.INNER INTERFERENCE=0.01 MU=0.1
$FREEDOM CLASS=SUPPRESSED DOF=XY
  RING.OUTER
$STEP NAME=PRESS
  FIT C 1
$END
"""


class TableTest(ProgramTest):
    def rows(self, name, folder="out"):
        with (self.folder / folder / name).open(encoding="utf-8") as table:
            return list(csv.DictReader(table))


class StudyTest(TableTest):
    def study(self, text, *options):
        self.deck(text)
        result = self.expect(0, "study", "test.deck", "--out", "out", "--quiet", *options)
        return result.stdout, self.rows("study.csv")

    def slope(self, output, answers, series):
        """The power in the line of a series."""
        found = re.search(rf"^  {answers} +{series} +([\d.]+)( |$)", output, re.MULTILINE)
        self.assertIsNotNone(found, output)
        return float(found.group(1))

    def test_smooth_problem_has_the_powers_of_theory(self):
        output, rows = self.study(RING)
        self.assertAlmostEqual(self.slope(output, "energy", "all sizes"), 4.0, delta=0.2)
        self.assertAlmostEqual(self.slope(output, "energy", "linear elements"), 2.0, delta=0.2)
        self.assertIn("elements*0.5", output)
        page = (self.folder / "out" / "study.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("<svg"), 2)
        self.assertEqual({row["exit_code"] for row in rows}, {"0"})

    def test_the_sentence_is_what_the_runs_say(self):
        output, rows = self.study(STRIP)
        self.assertIn("density=2 FINER=0.5", output)  # found, whatever it is called
        self.assertNotIn("b=", output)
        self.assertAlmostEqual(self.slope(output, "K", "all sizes"), 3.0, delta=0.5)
        self.assertAlmostEqual(self.slope(output, "K", "without quarter points"), 1.0, delta=0.2)
        found = re.search(r"^K within 0.1 %: (.+) gives ([\d.e-]+) % for ([\d.]+) s(.*)$", output,
                          re.MULTILINE)
        self.assertIsNotNone(found, output)
        column = "error" if "taken out" in found.group(4) else "raw_error"
        own = [row for row in rows if row["setting"] == found.group(1)]
        self.assertTrue(own)
        largest = max(abs(float(row[column])) for row in own)
        self.assertLessEqual(largest, 1e-3)
        self.assertGreaterEqual(float(found.group(2)), 100.0 * largest * 0.94)  # and all finer ones
        self.assertAlmostEqual(float(own[0]["cpu"]), float(found.group(3)), delta=0.006)
        # F of a/W = 0.5 in a long strip: 2.8266 (Kaya and Erdogan 1987), K = F sqrt(5 pi).
        finest = [row for row in rows if row["setting"] == "density=8 FINER=2"]
        self.assertTrue(finest)
        self.assertAlmostEqual(float(finest[0]["value"]) / 11.203, 1.0, delta=2e-3)

    def script(self, text):
        (self.folder / "ring.geo").write_text(text, encoding="utf-8")

    def test_constants_of_a_script_are_found(self):
        self.script(MAPPED_SCRIPT)
        output, rows = self.study(MAPPED)
        self.assertIn("n=3 ", output)
        self.assertNotIn("order=", output)
        freedoms = {row["setting"]: int(row["freedoms"]) for row in rows}
        self.assertGreater(freedoms["n=12"], 3 * freedoms["as given"])
        self.assertGreater(self.slope(output, "displacement", "all sizes"), 2.5)

    def test_a_mesh_that_nothing_changes_is_no_proof(self):
        self.script(MAPPED_SCRIPT.replace("n + 1", "7"))
        output, rows = self.study(MAPPED)
        self.assertIn("the mesh of ring.geo stays as it is", output)
        self.assertNotIn("elements*2", {row["setting"] for row in rows})
        self.assertNotIn(" gives 0 %", output)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_beside_it(self):
        self.script(MAPPED_SCRIPT)
        output, rows = self.study(MAPPED)
        peer = {(row["setting"], row["group"]): float(row["error"]) for row in rows
                if row["family"] == "CalculiX, same meshes"}
        self.assertEqual(len(peer), 10, output)
        self.assertLess(abs(peer["n=12, CalculiX", "displacement"]), 1e-4)
        self.assertLess(abs(peer["n=12, CalculiX", "stress"]), 0.02)
        self.assertLess(abs(peer["n=12, CalculiX", "stress"]), abs(peer["n=3, CalculiX", "stress"]))
        self.assertRegex(output, r"stress by CalculiX: n=12 gives [\d.]+ % for [\d.]+ s, the program")
        self.assertNotIn("CalculiX gives", output)  # it is no setting to choose

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_what_calculix_cannot_be_asked_is_told(self):
        output, _ = self.study(STRIP, "--vary", "density=4,5")
        self.assertIn("without CalculiX: $CRACK cannot be written as Abaqus input", output)

    def test_only_what_is_asked_for(self):
        output, rows = self.study(STRIP, "--vary", "density=3,4,6")
        self.assertEqual(sorted({row["setting"] for row in rows}),
                         ["as given", "density=3", "density=4", "density=6"])
        self.assertIn("K within 1 %", output)
        self.expect(2, "study", "test.deck", "--vary", "density")

    def test_a_deck_that_cannot_be_solved(self):
        self.deck(STRIP.replace("  CORNER\n", "  NOWHERE\n"))
        self.expect(3, "study", "test.deck")
        self.assertFalse((self.folder / "test.study").exists())
        self.assertEqual([p.name for p in self.folder.iterdir()], ["test.deck"])


class LadderTest(TableTest):
    def test_press_fit(self):
        """Closed all round, so that bonds change nothing; a rigid pin presses as Lame says."""
        self.deck(FIT)
        result = self.expect(0, "ladder", "test.deck", "--out", "out", "--quiet")
        rows = self.rows("ladder.csv")
        mean = {row["rung"]: row for row in rows if row["answer"] == "CPRESS.MEAN(C,PRESS)"}
        self.assertEqual(mean["as given"]["verdict"], "the richest")
        for rung in ("without friction", "bonded with its fits"):
            self.assertEqual(mean[rung]["verdict"], "within", result.stdout)
            self.assertLess(abs(float(mean[rung]["difference"])), 1e-4)
        self.assertEqual(mean["without interference"]["verdict"], "not within")
        # u = p (fs + fh): the shaft's flexibility falls away (ring held outside: u(30) = 0).
        shaft = 10 * (1 - 0.3)
        k = 30.0**2 / 10.0**2
        ring = 10 * (1 - 0.3**2) * (k - 1) / ((1 + 0.3) + (1 - 0.3) * k)
        self.assertAlmostEqual(float(mean["rigid pressing body"]["difference"]), shaft / ring,
                               delta=0.02 * shaft / ring)
        self.assertIn("without a crack there is no body to keep", result.stdout)
        self.expect(0, "run", "out/cheapest.deck", "--out", "cheap", "--quiet")

    def test_parts_by_symmetry(self):
        """A ring with a crack on both sides, drawn in one of its planes; then without, by its energy."""
        ring = TWICE_CRACKED_RING
        plain = re.sub(r"\$CRACK.*\n.*\n.*\n", "", ring)
        for text, answer, out in ((ring, "K1(R,LOAD)", "cracked"), (plain, "ENERGY(*,LOAD)", "plain")):
            self.deck(text)
            result = self.expect(0, "ladder", "test.deck", "--out", out, "--quiet")
            rows = self.rows("ladder.csv", out)
            quarter = [row for row in rows if row["rung"] == "quarter by symmetry" and row["answer"] == answer]
            self.assertEqual([row["verdict"] for row in quarter], ["within"], result.stdout)
            self.assertLess(abs(float(quarter[0]["difference"])), 1e-3 if "K1" in answer else 1e-9)
            deck = (self.folder / out / "cheapest.deck").read_text(encoding="utf-8")
            self.assertIn("$SYMMETRY", deck)
            self.assertNotIn("K1(L", deck)
            self.expect(0, "run", f"{out}/cheapest.deck", "--out", "cheap", "--quiet")

    def test_extremes_of_a_half_that_change_their_sign(self):
        """Of the smallest shear of a quarter the ring has the opposite, too; of direct stresses it has the same."""
        checks = "".join(f"  {word} = 1 REL 1\n" for word in
                         ("U.X.MAX(BODY,LOAD)", "S.XY.MIN(BODY,LOAD)", "S.XX.MAX(BODY,LOAD)"))
        plain = re.sub(r"\$CRACK.*\n.*\n.*\n", "", TWICE_CRACKED_RING)
        self.deck(plain.replace("$END\n", f"$CHECK\n{checks}$END\n").replace("  INNER  10", "  INNER  (10*(1+(x/10)^4))"))
        self.expect(0, "ladder", "test.deck", "--out", "out", "--quiet")
        rows = [row for row in self.rows("ladder.csv") if row["rung"] == "quarter by symmetry"]
        self.assertEqual({row["verdict"] for row in rows}, {"within"})
        self.assertEqual([row["answer"] for row in rows if row["value"] not in ("", "nan")], ["S.XX.MAX(BODY,LOAD)"])

    def test_solids_by_their_sections(self):
        """A slice between flat faces is in plane strain, a hub with free ones in plane stress, both to be round."""
        expected = {"lug_slice_crack_solid": {"plane strain": ("within", 2e-3), "plane stress": ("not within", 0.1)},
                    "hub_solid": {"axisymmetric": ("within", 1e-2), "plane strain": ("not within", 0.1),
                                  "plane stress": ("within", 1e-2)},
                    "le11_solid": {"axisymmetric": ("within", 5e-3)}}
        for deck, rungs in expected.items():
            result = self.expect(0, "ladder", TOP / "decks" / f"{deck}.deck", "--out", deck, "--quiet")
            rows = self.rows("ladder.csv", deck)
            for rung, (verdict, bound) in rungs.items():
                own = [row for row in rows if row["rung"] == rung and row["value"]]
                self.assertTrue(own, result.stdout)
                self.assertEqual({row["verdict"] for row in own}, {verdict}, result.stdout)
                self.assertLess(max(abs(float(row["difference"])) for row in own), bound, result.stdout)
            cheapest = (self.folder / deck / "cheapest.deck").read_text(encoding="utf-8")
            self.assertNotIn("SOLID", cheapest)
            self.expect(0, "run", f"{deck}/cheapest.deck", "--out", "cheap", "--quiet")


if __name__ == "__main__":
    main()
