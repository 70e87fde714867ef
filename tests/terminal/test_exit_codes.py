# SPDX-License-Identifier: GPL-3.0-or-later
"""How the program ends, and that data go to stdout and messages to stderr. Codes 5, 6 and 70 have no
deck that ends with them."""

import re

from program import TOP, ProgramTest, main, plate


class ExitCodes(ProgramTest):
    def test_0_done(self):
        result = self.expect(0, "run", self.deck(plate()))
        self.assertIn("results in test.run", result.stdout)
        self.assertEqual(result.stderr, "")
        self.assertTrue((self.folder / "test.run" / "listing.txt").exists())
        quiet = self.expect(0, "run", "test.deck", "--quiet")
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))

    def test_1_check_failed(self):
        deck = self.deck(plate("$CHECK\n  S.XX.MAX(XMAX,LOAD) = 7  REL 1e-3\n"))
        self.assertIn("check failed: S.XX.MAX", self.expect(1, "run", deck).stderr)
        self.expect(0, "check", deck)

    def test_2_usage(self):
        self.expect(2, "run")

    def test_3_deck_error(self):
        for command in ("run", "check"):
            result = self.expect(3, command, self.deck(plate("$FOO\n")))
            self.assertIn("test.deck:11:1: error E104", result.stderr)
            self.assertEqual(result.stdout, "")
            self.assertFalse((self.folder / "test.run").exists())

    def test_3_no_step(self):
        deck = self.deck(plate().split("$STEP")[0] + "$END\n")
        self.assertIn("error E405", self.expect(3, "run", deck).stderr)

    def test_4_not_solvable(self):
        deck = self.deck(plate().replace("$FREEDOM CLASS=SUPPRESSED DOF=XY\n  XMIN\n", ""))
        self.assertIn("error E510", self.expect(4, "run", deck).stderr)

    def test_7_file_trouble(self):
        self.assertIn("none.deck", self.expect(7, "run", "none.deck").stderr)
        self.expect(7, "check", self.folder)
        self.expect(7, "format", "none.deck")

    def test_a_definition_reaches_the_deck(self):
        text = plate("$CHECK\n  S.XX.MAX(XMAX,LOAD) = 50  REL 0.2\n")
        text = text.replace("$MESH", "$PARAMETER\n  s = 100\n$MESH").replace("XMAX  100", "XMAX  (s)")
        deck = self.deck(text)
        self.expect(1, "run", deck, "--quiet")
        self.expect(0, "run", deck, "--quiet", "-D", "s=50[MPa]")

    def test_the_manual_has_the_table_of_the_help(self):
        shown = re.findall(r"(?m)^  (\d+) ", self.expect(0, "--help").stdout)
        manual = (TOP / "manual" / "exit_codes.md").read_text(encoding="utf-8")
        self.assertEqual(shown, re.findall(r"(?m)^\| (\d+) \|", manual))


if __name__ == "__main__":
    main()
