# SPDX-License-Identifier: GPL-3.0-or-later
"""Which changes of a deck a state survives, and from where a run goes on."""

from run_folders import CRACKED, RestartTest, keeping, main, press_fit

READ = "$RESTART READ='state.rst'\n"
STEPS = CRACKED.replace(
    "$CRACK", "$STEP NAME=MORE\n  LOAD PULL 2\n$STEP NAME=LESS\n  LOAD PULL 0.5\n$CRACK", 1
)


class Decks(RestartTest):
    def keep(self, text=CRACKED):
        self.expect(0, "run", self.deck(keeping(text), "first.deck"), "--quiet")

    def go_on(self, code, text, card=READ, **more):
        deck = self.deck(keeping(text, card), "second.deck")
        return self.expect(code, "run", deck, "--quiet", **more)

    def table(self, folder, name="k.csv"):
        return (self.folder / folder / name).read_bytes()

    def like_new(self, text):
        """What the deck gives from the start."""
        self.expect(0, "run", self.deck(text, "new.deck"), "--quiet")
        self.assertEqual(self.table("second.run"), self.table("new.run"))
        for picture in (self.folder / "new.run").glob("*.vtu"):
            self.assertEqual(picture.read_bytes(), self.table("second.run", picture.name))

    def test_a_changed_card_is_named(self):
        self.keep()
        for old, new, place, words in (
            ("E=210[GPa]", "E=211[GPa]", "3:1", "$MATERIAL is not what the earlier deck has"),
            ("NX=4", "NX=6", "2:1", "$MESH is not"),
            ("YMAX  0  100", "YMAX  0  101", "7:1", "$LOAD is not"),
            ("  0  2.5\n", "  0  2.4\n", "11:1", "$CRACK is not"),
            ("$STEP", "$NSET NAME=A\n  1\n$STEP", "9:1", "$NSET was not in the earlier deck"),
            (
                "$LOAD CASE=PULL TYPE=TRACTION\n  YMAX  0  100\n",
                "$LOAD CASE=PULL TYPE=TRACTION\n  YMAX  0  50\n"
                "$LOAD CASE=PULL TYPE=TRACTION\n  YMAX  0  50\n",
                "7:1",
                "$LOAD",
            ),
        ):
            self.assertIn(old, CRACKED)
            result = self.go_on(3, CRACKED.replace(old, new, 1))
            self.assertIn(f"second.deck:{place}: error E561", result.stderr)
            self.assertIn(words, result.stderr)

    def test_a_missing_card_is_named(self):
        self.keep(CRACKED.replace("$STEP", "$NSET NAME=A\n  1\n$STEP", 1))
        result = self.go_on(3, CRACKED)
        self.assertIn("a $NSET is missing here, line 9 of the earlier first.deck", result.stderr)

    def test_layout_does_not_matter(self):
        self.keep()
        text = "! a comment\n" + CRACKED.replace(
            "E=210[GPa] NU=0.3", "   e = 210[GPa]   ! steel\n  & NU=0.3"
        ).replace("  YMIN\n", "\n   ymin  ! below\n\n")
        result = self.go_on(0, text)
        self.assertEqual(result.stderr, "")

    def test_parameters_count_where_they_are_used(self):
        text = CRACKED.replace("$MESH", "$PARAMETER\n  s = 100\n  wanted = 3\n$MESH", 1).replace(
            "0  100", "0  (s)"
        )
        check = "$CHECK\n  G.MAX(C,LOAD) = (wanted) ABS 1e9\n" if False else ""
        self.keep(text + check)
        self.go_on(0, text.replace("wanted = 3", "wanted = 4"))
        result = self.go_on(3, text.replace("s = 100", "s = 101"))
        self.assertIn("$LOAD uses s = 101; the earlier run had s = 100", result.stderr)
        deck = self.deck(keeping(text, READ), "second.deck")
        result = self.expect(3, "run", deck, "-D", "s=102", "--quiet")
        self.assertIn("$LOAD uses s = 102", result.stderr)

    def test_an_included_file_counts(self):
        line = "$MATERIAL NAME=STEEL E=210[GPa] NU=0.3\n"
        text = CRACKED.replace(line, "$INCLUDE FILE='steel.inc'\n")
        self.deck(line, "steel.inc")
        self.keep(text)
        self.go_on(0, text)
        self.go_on(0, CRACKED)
        self.deck(line.replace("0.3", "0.29"), "steel.inc")
        self.assertIn("steel.inc:1:1: error E561", self.go_on(3, text).stderr)

    def test_an_imported_file_counts(self):
        square = (
            "Point(1) = {0, 0, 0, 1};\nPoint(2) = {10, 0, 0, 1};\nPoint(3) = {10, 5, 0, 1};\n"
            "Point(4) = {0, 5, 0, 1};\nLine(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\n"
            "Line(4) = {4, 1};\nLine Loop(1) = {1, 2, 3, 4};\nPlane Surface(1) = {1};\n"
            'Physical Line("YMIN") = {1};\nPhysical Line("YMAX") = {3};\n'
            'Physical Surface("BODY") = {1};\n'
        )
        self.deck(square, "plate.geo")
        text = CRACKED.replace(
            "$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=4 NY=2",
            "$IMPORT FILE='plate.geo' FORMAT=GEO TYPE=QUADRATIC",
        )
        self.keep(text)
        self.go_on(0, text)
        self.deck(square.replace("{10, 5, 0, 1}", "{10, 5, 0, 0.9}"), "plate.geo")
        self.assertIn("$IMPORT is not what", self.go_on(3, text).stderr)

    def test_more_lengths(self):
        self.keep()
        text = CRACKED.replace("1  1.5  2\n", "1  1.5  2  2.25\n")
        self.assertEqual(self.go_on(0, text).stderr, "")
        self.like_new(text)

    def test_other_lengths(self):
        self.keep()
        text = CRACKED.replace("1  1.5  2\n", "1  1.4  2\n")
        result = self.go_on(0, text)
        self.assertIn("warning W561", result.stderr)
        self.assertIn("2 increments are from number 2 on solved anew", result.stderr)
        listing = self.table("second.run", "listing.txt").decode("utf-8")
        self.assertIn("$GROW asks for length 1.4 there, it was 1.5", listing)
        self.like_new(text)

    def test_fewer_lengths(self):
        self.keep()
        text = CRACKED.replace("1  1.5  2\n", "1  1.5\n")
        self.go_on(0, text)
        self.like_new(text)

    def test_other_rules_of_growth(self):
        self.keep()
        result = self.go_on(3, CRACKED.replace("KMAX=LOAD", "KMAX=LOAD MOUNTED=FIRST"))
        self.assertIn("its cracks grew by other rules", result.stderr)

    def test_steps_that_are_gone(self):
        self.keep(STEPS)
        text = STEPS.replace("$STEP NAME=LESS\n  LOAD PULL 0.5\n", "")
        result = self.go_on(0, text)
        self.assertIn("the last 1 of 3 steps are gone", result.stderr)
        self.like_new(text)

    def test_other_steps(self):
        self.keep(STEPS)
        result = self.go_on(3, STEPS.replace("PULL 2", "PULL 3"))
        self.assertIn("its increments were solved with other steps: $STEP is not", result.stderr)
        self.assertIn("second.deck:11:1: error E561", result.stderr)
        more = STEPS.replace("$CRACK", "$STEP NAME=ONE\n  LOAD PULL 1\n$CRACK", 1)
        self.assertIn("$STEP was not in the earlier deck", self.go_on(3, more).stderr)

    def test_new_outputs(self):
        self.keep(STEPS)
        text = STEPS.replace("$END", "$OUTPUT FILE='u.csv' FORMAT=CSV EVERY=INCREMENT\n  U YMAX\n$END")
        self.assertEqual(self.go_on(0, text).stderr, "")
        self.like_new(text)
        self.assertEqual(self.table("second.run", "u.csv"), self.table("new.run", "u.csv"))
        text = STEPS.replace("$END", "$OUTPUT FILE='all.vtu' FORMAT=VTU\n  U YMAX\n$END")
        result = self.go_on(0, text)
        self.assertIn("asks for stresses that were not kept", result.stderr)
        self.like_new(text)

    def test_at(self):
        self.keep()
        for at in range(4):
            self.go_on(0, CRACKED, f"$RESTART READ='state.rst' AT={at}\n")
            listing = self.table("second.run", "listing.txt").decode("utf-8")
            told = f"{at} of 3 increments taken over from"
            self.assertEqual(told in listing, at > 0)
            self.assertEqual(self.table("first.run"), self.table("second.run"))
        result = self.go_on(3, CRACKED, "$RESTART READ='state.rst' AT=4\n")
        self.assertIn("second.deck:15:1: error E562", result.stderr)
        self.assertIn("holds 3 increments", result.stderr)

    def test_read_and_write(self):
        self.keep()
        card = "$RESTART READ='state.rst' WRITE='other.rst' AT=2\n"
        self.go_on(0, CRACKED, card)
        self.assertEqual(self.increments("other.rst"), self.increments("state.rst"))
        (self.folder / "state.rst").unlink()
        (self.folder / "state.rst.1").unlink()
        self.go_on(0, CRACKED, "$RESTART READ='other.rst'\n")
        self.go_on(0, CRACKED, "$RESTART READ='other.rst' WRITE='other.rst' AT=1\n")
        self.assertEqual(self.table("first.run"), self.table("second.run"))

    def test_files_lie_beside_the_deck(self):
        (self.folder / "decks").mkdir()
        self.deck(keeping(), "decks/test.deck")
        self.expect(0, "run", "decks/test.deck", "--quiet")
        self.assertTrue((self.folder / "decks" / "state.rst").exists())

    def test_a_sweep_does_not_read(self):
        text = CRACKED.replace("$MESH", "$PARAMETER\n  s = 100\n$MESH").replace("0  100", "0  (s)")
        self.assertIn("error E110", self.go_on(3, text, "$SWEEP PARAMETER=s\n  1 2\n" + READ).stderr)

    def test_what_was_mounted_first(self):
        """MOUNTED=FIRST keeps the offsets of the first length: they are in the state."""
        text = press_fit(
            "FIT",
            0.01,
            6,
            32,
            "$CRACK NAME=C NET=RING ANGLE=0 A0=1\n  10  0\n"
            "$GROW LAW=INCREMENT KMAX=PRESS MOUNTED=FIRST\n  1  2  3\n",
        )
        deck = self.deck(keeping(text), "press.deck")
        self.expect(0, "run", deck, "--out", "whole.run", "--quiet")
        for f in self.folder.glob("state.rst*"):
            f.is_file() and f.unlink()
        result = None
        while result is None or result.returncode == 6:
            result = self.run_program("run", deck, "--restart", "--time", "0.001", "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.same_folders(self.folder / "whole.run", self.folder / "press.run")


if __name__ == "__main__":
    main()
