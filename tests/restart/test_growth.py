# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth by a law, stopped after every length, goes on to the same bits: straight and curved cracks,
constant load and spectra, K to a tolerance, slip carried from length to length; and further than it
was asked to at first."""

import csv
import os

from run_folders import TOP, RestartTest, corner, keeping, main

FULL = bool(os.environ.get("SPRICKA_FULL"))
PLATE = """$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Growth'
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=20 LY=40 NX=8 NY=16
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=BODY MATERIAL=STEEL STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  YMIN
$LOAD CASE=PULL TYPE=TRACTION
  YMAX  {shear}  100
$STEP NAME=LOW
  LOAD PULL 0.1
$STEP NAME=HIGH
  LOAD PULL 1
$LOADPATH NAME=UP FROM=LOW TO=HIGH
$CRACK NAME=C ANGLE=0 A0=2
  0  20
{more}
$END
"""
LAW = "$GROW LAW=PARIS C=1e-13 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX={amax} DA=0.5 "
STEPS = LAW + "KMAX=HIGH KMIN=LOW"
SPECTRUM = """$SPECTRUM NAME=FLIGHT PATH=UP TYPE=SEQUENCE
  0 0.5 0.2 1 0.1 0.8 0
"""

# A strip with a crack hangs on a block that only friction holds: what it has stretched the strip by
# stays from length to length.
CLAMPED = """$DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=50 LY=10 NX=20 NY=4
$ESET NAME=STRIP WHERE=(x < 40)
$ESET NAME=BLOCKS WHERE=(x > 40)
$NSET NAME=LINE WHERE=(abs(x) < 1e-9) ORDER=(y)
$NSET NAME=MIDDLE WHERE=(abs(y) < 1e-9)
$NSET NAME=CLAMPED WHERE=(abs(y-10) < 1e-9 and x > 39.999)
$MATERIAL NAME=SOFT  E=2000 NU=0
$MATERIAL NAME=STIFF E=2e8 NU=0
$PROPERTY ESET=STRIP  MATERIAL=SOFT  STATE=STRAIN
$PROPERTY ESET=BLOCKS MATERIAL=STIFF STATE=STRAIN
$FREEDOM CLASS=SUPPRESSED DOF=X
  LINE
$FREEDOM CLASS=SUPPRESSED DOF=Y
  MIDDLE
$RIGID NAME=CLAMP SHAPE=LINE X0=60 Y0=10 X1=0 Y1=10
$CONTACT NAME=GRIP SLAVE=CLAMPED MASTER=CLAMP INTERFERENCE=2.5e-6 MU=0.2
$CRACK NAME=C1 PATH=LINE A0=2
$LOAD CASE=PULL TYPE=TRACTION
  XMAX 50 0
$LOAD CASE=INSIDE TYPE=FACES
  C1 10
$STEP NAME=FULL SUBSTEPS=2
  LOAD PULL 1
$STEP NAME=BACK SUBSTEPS=2
  LOAD PULL 0.7
$STEP NAME=OPEN
  LOAD INSIDE 1
$STEP NAME=SHUT
  LOAD INSIDE 0
$GROW LAW=PARIS KMAX=OPEN KMIN=SHUT C=1e-11 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=4 HISTORY=CONTINUE
$END
"""


class Growth(RestartTest):
    def check(self, more, shear=0, sessions=3):
        self.check_deck(PLATE.format(shear=shear, more=more), sessions)

    def check_deck(self, text, sessions=3):
        deck = self.deck(keeping(text))
        self.expect(0, "run", deck, "--out", "whole.run", "--quiet")
        for f in self.folder.glob("state.rst*"):
            f.is_file() and f.unlink()
        stops = 0
        while True:
            result = self.run_program("run", deck, "--restart", "--time", "0.001", "--quiet")
            if result.returncode != 6:
                break
            stops += 1
            self.assertLess(stops, 100)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreaterEqual(stops, sessions)
        self.same_folders(self.folder / "whole.run", self.folder / "test.run")

    def test_fronts(self):
        for shape in ("FREE", "ELLIPSE") if FULL else ("FREE",):  # the other one: test_kill.py
            with self.subTest(shape):
                self.check_deck(corner(shape))

    def test_a_front_that_turns(self):
        text = (TOP / "decks" / "inclined_life.deck").read_text(encoding="utf-8")
        self.assertIn("AMAX=(b + 4)", text)
        text = text[: text.index("$CHECK")].replace("AMAX=(b + 4)", f"AMAX=(b + {1.5 if FULL else 0.8})") + "$END\n"
        self.check_deck(text, sessions=2)

    def test_straight(self):
        self.check(STEPS.format(amax=5))

    def test_curved(self):
        self.check(STEPS.format(amax=4) + " DIRECTION=HOOP", shear=40)

    def test_spectrum(self):
        self.check(SPECTRUM + LAW.format(amax=4) + "SPECTRUM=FLIGHT")

    def test_cycles_that_act_on_each_other(self):
        """Stopped inside the zones of overloads."""
        overloads = """$SPECTRUM NAME=FLIGHT PATH=UP TYPE=BLOCKS
  0 1 1
  0 0.6 300
$INTERACTION NAME=WH TYPE=WHEELER W=1.4 ZONE=IRWIN2 YIELD=300
"""
        self.check(overloads + LAW.format(amax=4) + "SPECTRUM=FLIGHT INTERACTION=WH,NONE")

    def test_to_a_tolerance(self):
        self.check("$TIPNET CRACK=C TOL=0.0001\n" + STEPS.format(amax=4), sessions=6)
        listing = (self.folder / "whole.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertRegex(listing, r"\n +2 +\d+ .* inside\n")  # a second round: something was refined

    def test_slip_is_carried(self):
        self.check_deck(CLAMPED)

    def test_slip_is_carried_along_a_front(self):
        """A penny behind a clamp that slips: its life is checked against Sneddon's K behind a play."""
        text = (TOP / "decks" / "friction_solid_life.deck").read_text(encoding="utf-8")
        for old, new in (("a1 = 0.9", "a1 = 0.66"), ("AMAX=(a1)", "AMAX=(a1) HISTORY=CONTINUE")):
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.check_deck(text, sessions=1)

    def test_rest_of_a_lug(self):
        """In space the region near a crack and the rest of its body, contact on both, are factorised apart:
        the same bits from a restart, the K of the undivided body."""
        text = (TOP / "decks" / "lug_corner_life.deck").read_text(encoding="utf-8")
        for old, new in (("FILE='", f"FILE='{TOP}/decks/"), ("fine = 0.5", "fine = 0.6"), ("AMAX=6", "AMAX=1.4")):
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.check_deck(text, sessions=1)
        listing = (self.folder / "whole.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertRegex(listing, r"region chosen: \d+ of \d+ elements")
        alone = self.deck(text[: text.index("$LOADPATH")] + "$END\n", "alone.deck")
        self.expect(0, "run", alone, "--quiet")
        divided, whole = (self.k_of_first_front(run) for run in ("whole.run", "alone.run"))
        self.assertEqual(len(divided), len(whole))
        largest = max(abs(k) for k in whole)
        for a, b in zip(divided, whole):
            self.assertAlmostEqual(a, b, delta=1e-9 * largest)

    def k_of_first_front(self, run):
        """K1, K2, K3 of all steps and points."""
        rows = csv.DictReader(
            line
            for line in (self.folder / run / "k.csv").read_text(encoding="utf-8").splitlines()
            if not line.startswith("#")
        )
        return [float(row[k]) for row in rows if row["increment"] == "1" for k in ("K1", "K2", "K3")]

    def test_further(self):
        deck = PLATE.format(shear=0, more=STEPS.format(amax=4))
        self.expect(0, "run", self.deck(keeping(deck)), "--quiet")
        further = self.deck(keeping(deck.replace("AMAX=4", "AMAX=5")), "further.deck")
        kept = len(self.increments())
        self.expect(0, "run", further, "--restart", "--quiet")
        listing = (self.folder / "further.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertIn(f"{kept} of {len(self.increments())} increments taken over", listing)
        self.assertGreater(len(self.increments()), kept)
        self.expect(0, "run", further, "--out", "new.run", "--quiet")
        # cycles to the end, from stations of two plans: to the tolerance of $GROW
        end = [
            [float(v) for v in (self.folder / run / "life_curve.csv").read_text().split()[-1].split(",")]
            for run in ("further.run", "new.run")
        ]
        self.assertEqual(len(end[0]), len(end[1]))
        for a, b in zip(*end):
            self.assertAlmostEqual(a, b, delta=2e-3 * abs(b))

    def test_other_rules_are_refused(self):
        deck = PLATE.format(shear=0, more=STEPS.format(amax=4) + " SFLOW=1000")
        self.expect(0, "run", self.deck(keeping(deck)), "--quiet")
        for old, new, why in (
            ("M=3", "M=3.1", "other rules: .*; with SFLOW it hangs on stresses"),
            ("DA=0.5", "DA=0.6", "grew by other rules"),
            ("AMAX=4", "AMAX=3", "AMAX is 3, which it had as 4"),
        ):
            other = self.deck(keeping(deck.replace(old, new)), "other.deck")
            result = self.expect(3, "run", other, "--restart", "--quiet")
            self.assertIn("error E561", result.stderr)
            self.assertRegex(result.stderr, why)

    def life(self, run):
        """Length and cycles at the end."""
        return [float(v) for v in (self.folder / run / "life_curve.csv").read_text().split()[-1].split(",")]

    def check_another_law(self, before, other_law, tolerance=2e-3, shear=0):
        """The fronts of one growth serve another law or spectrum: none is solved anew, the life is that
        of a run from the start, and what is kept then is of that law."""
        self.expect(0, "run", self.deck(keeping(PLATE.format(shear=shear, more=before))), "--quiet")
        kept = len(self.increments())
        other = self.deck(keeping(PLATE.format(shear=shear, more=other_law)), "other.deck")
        self.expect(0, "run", other, "--restart", "--out", "again.run", "--quiet")
        listing = (self.folder / "again.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertIn(f"{kept} of {kept} increments taken over", listing)
        self.expect(0, "run", other, "--restart", "--out", "third.run", "--quiet")
        self.same_folders(self.folder / "again.run", self.folder / "third.run")
        card = f"$RESTART READ='state.rst' AT={kept - 1} WRITE='last.rst'\n"  # rates kept there are of before
        last = self.deck(keeping(PLATE.format(shear=shear, more=other_law), card), "last.deck")
        self.expect(0, "run", last, "--quiet")
        listing = (self.folder / "last.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertIn(f"{kept - 1} of {kept} increments taken over", listing)
        self.expect(0, "run", self.deck(PLATE.format(shear=shear, more=other_law), "new.deck"), "--quiet")
        again, last, new = (self.life(f"{name}.run") for name in ("again", "last", "new"))
        self.assertEqual(len(again), len(new))
        for a, b, c in zip(again, last, new):
            self.assertAlmostEqual(a, b, delta=1e-6 * abs(b))
            self.assertAlmostEqual(a, c, delta=tolerance * abs(c))

    def test_another_law_over_the_same_fronts(self):
        law = STEPS.format(amax=4)
        self.check_another_law(law, law.replace("C=1e-13 M=3", "C=5e-14 M=3.2"))

    def test_another_law_of_a_tip_that_turns(self):
        law = STEPS.format(amax=4) + " DIRECTION=HOOP"
        self.check_another_law(law, law.replace("C=1e-13 M=3", "C=5e-14 M=3.2"), shear=40)

    def test_a_scatter_factor_leaves_fronts_where_they_are(self):
        """Through the far face, too."""
        for shape in ("FREE", "ELLIPSE"):
            with self.subTest(shape):
                # the ellipse breaks the body at 50700
                cycles = (60000 if shape == "FREE" else 50000) if FULL else 15000
                deck = corner(shape).replace("CYCLES=60000", f"CYCLES={cycles}")
                self.expect(0, "run", self.deck(keeping(deck)), "--quiet")
                kept = len(self.increments())
                other = deck.replace("C=1e-12", "C=2e-12").replace(f"CYCLES={cycles}", f"CYCLES={cycles // 2}")
                self.expect(0, "run", self.deck(keeping(other), "other.deck"), "--restart", "--quiet")
                listing = (self.folder / "other.run" / "listing.txt").read_text(encoding="utf-8")
                self.assertIn(f"{kept} of {kept} increments taken over", listing)
                for a, b in zip(self.life("other.run")[1:], self.life("test.run")[1:]):
                    self.assertAlmostEqual(a, b, delta=1e-9 * abs(b))
                for f in self.folder.glob("state.rst*"):
                    f.is_file() and f.unlink()

    def test_a_law_over_given_ellipses(self):
        """A penny stays one by any law: its sizes serve them all."""
        penny = """$DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=TET10 X0=-4 Y0=-4 Z0=-4 LX=8 LY=8 LZ=8 NX=4 NY=4 NZ=4
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  ZMIN
$CRACK NAME=C1 A=0.5 C=0.5 X0=0 Y0=0 Z0=0 NORMAL=Z
$LOAD CASE=PULL TYPE=TRACTION
  ZMAX  0 0 100
$STEP NAME=FULL
  LOAD PULL 1
$STEP NAME=ZERO
  LOAD PULL 0
$GROW LAW=INCREMENT SHAPE=ELLIPSE KMAX=FULL
  0.5 0.6 0.75
$END
"""
        self.expect(0, "run", self.deck(keeping(penny)), "--quiet")
        law = "LAW=PARIS SHAPE=ELLIPSE KMAX=FULL KMIN=ZERO C=1e-12 M=4 KUNIT='MPa*mm^0.5' AUNIT='mm' AMAX=0.75"
        other = penny.replace("LAW=INCREMENT SHAPE=ELLIPSE KMAX=FULL\n  0.5 0.6 0.75", law)
        self.expect(0, "run", self.deck(keeping(other), "other.deck"), "--restart", "--quiet")
        listing = (self.folder / "other.run" / "listing.txt").read_text(encoding="utf-8")
        self.assertIn("3 of 3 increments taken over", listing)
        self.expect(0, "run", self.deck(other, "new.deck"), "--quiet")
        again, new = (self.life(f"{name}.run")[0] for name in ("other", "new"))
        self.assertAlmostEqual(again, new, delta=0.02 * new)

    def test_another_law_ends_elsewhere(self):
        """Before the last front that was kept, and behind it: only what lies behind is solved."""
        law = STEPS.format(amax=4).replace("M=3", "M=3.2")
        for other_law, taken in (
            (law + " KC=420", "5 of 5"),
            (STEPS.format(amax=3.3), r"(\d) of \1"),
            (law.replace("AMAX=4", "AMAX=5"), "6 of [78]"),
        ):
            self.expect(0, "run", self.deck(keeping(PLATE.format(shear=0, more=STEPS.format(amax=4)))), "--quiet")
            other = self.deck(keeping(PLATE.format(shear=0, more=other_law)), "other.deck")
            self.expect(0, "run", other, "--restart", "--quiet")
            listing = (self.folder / "other.run" / "listing.txt").read_text(encoding="utf-8")
            self.assertRegex(listing, f"{taken} increments taken over")
            self.expect(0, "run", self.deck(PLATE.format(shear=0, more=other_law), "new.deck"), "--quiet")
            for a, b in zip(self.life("other.run"), self.life("new.run")):
                self.assertAlmostEqual(a, b, delta=2e-3 * abs(b))

    def test_a_law_that_asks_for_more_than_was_kept(self):
        """Walker's goes on below K = 0, with faces that overlap: no front of Paris' law has that."""
        plate = PLATE.format(shear=0, more=STEPS.format(amax=3)).replace("PULL 0.1", "PULL -0.5")
        self.expect(0, "run", self.deck(keeping(plate)), "--quiet")
        walker = plate.replace("LAW=PARIS", "LAW=WALKER P=0.6")
        result = self.expect(0, "run", self.deck(keeping(walker), "other.deck"), "--restart", "--quiet")
        self.assertRegex(result.stderr, "W561: .* from number 1 on solved anew: .*K with faces that overlap")
        self.expect(0, "run", self.deck(walker, "new.deck"), "--quiet")
        self.assertEqual(self.life("other.run"), self.life("new.run"))

    def test_a_spectrum_over_the_same_fronts(self):
        flight = SPECTRUM + LAW.format(amax=4) + "SPECTRUM=FLIGHT"
        self.check_another_law(flight, flight.replace("0.2 1 0.1", "0.3 0.9 0.2"))

    def test_a_law_over_given_lengths(self):
        given = "$GROW LAW=INCREMENT KMAX=HIGH\n  2  2.3  2.7  3.1  3.5  4"
        self.check_another_law(given, STEPS.format(amax=4).replace("DA=0.5", ""))


if __name__ == "__main__":
    main()
