# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that a stranger has chosen: markup in reports, control sequences in messages, files outside
of the run folder, values whose unit is lost."""

import re
from html.parser import HTMLParser

from program import ProgramTest, main, plate

MARKUP = """<script>alert(1)</script>"><img src=x onerror=alert(1)>&lt;]]>--><!--"""


class Tags(HTMLParser):
    def __init__(self):
        super().__init__()
        self.found = set()
        self.scripts = 0

    def handle_starttag(self, tag, attrs):
        self.found.add(tag)
        self.scripts += tag == "script"
        self.found.update(name for name, _ in attrs if name.startswith("on"))


class Names(ProgramTest):
    def out_of(self, text, code=0, name="test.deck"):
        self.expect(code, "run", self.deck(text, name), "--out", "out", "--quiet")
        return self.folder / "out"

    def test_markup_in_names_stays_text(self):
        text = plate(
            f"$CHECK\n  S.XX.MAX(XMAX,LOAD) = 100 REL 0.5 SOURCE '{MARKUP}'\n"
        ).replace("TITLE='Plate'", f"TITLE='{MARKUP}'")
        out = self.out_of(text, name="a <script>alert(1)<u>.deck")
        tags = Tags()
        tags.feed((out / "report.html").read_text(encoding="utf-8"))
        self.assertIn("svg", tags.found)  # it has been parsed
        self.assertFalse(tags.found & {"img", "u", "onerror"}, tags.found)
        plain = Tags()
        self.expect(0, "run", self.deck(plate()), "--out", "plain", "--quiet")
        plain.feed((self.folder / "plain/report.html").read_text(encoding="utf-8"))
        self.assertEqual(tags.scripts, plain.scripts)  # the page's own

    def test_control_sequences_do_not_reach_the_terminal(self):
        for mistake in ("$FOO\x1b[2J\n", "$NSET NAME=A\x1b]0;x\x07\n  1\n", "! \x1b[31m\n$FOO\n"):
            self.assertNotIn("\x1b", self.expect(3, "check", self.deck(plate(mistake))).stderr)
        steering = plate("").replace("TITLE='Plate'", "TITLE='a\x1b]0;x\x07b'")
        self.assertNotIn("\x1b", self.expect(0, "check", self.deck(steering)).stdout)
        self.assertNotIn("\x1b", (self.out_of(steering) / "listing.txt").read_text(encoding="utf-8"))

    def test_output_files_stay_in_the_run_folder(self):
        more = "$OUTPUT FILE='{}' FORMAT=CSV\n  U XMAX\n"
        for path in ("../evil.csv", "/tmp/../{}/evil.csv".format(str(self.folder)[1:]), "a/b/evil.csv"):
            out = self.out_of(plate(more.format(path)))
            self.assertTrue((out / "evil.csv").exists())
            self.assertFalse((self.folder / "evil.csv").exists())

    def test_output_files_have_names_of_their_own(self):
        more = "$OUTPUT FILE='{}' FORMAT=CSV\n  U XMAX\n"
        for path in (
            "k.csv",
            "./k.csv",
            "a/../k.csv",
            "x/k.csv",
            "/k.csv",
            ".//listing.txt",
            "../report.html",
            "results.h5",
            ".spricka",
            ".spricka.owner",
            "point.json",
            "..",
            ".",
            "a/",
            "",
            "results_001_LOAD.vtu",
            "results.pvd",
            "k.csv.part",
            "x" * 300,
        ):
            errors = self.expect(3, "check", self.deck(plate(more.format(path)))).stderr
            self.assertIn("error E322", errors, path)
            self.assertIn("= another name", errors)
        twice = plate(more.format("u.csv") + more.format("./u.csv"))
        self.assertIn("another $OUTPUT", self.expect(3, "check", self.deck(twice)).stderr)

    def test_names_that_would_steer_a_terminal(self):
        name = "x\033]0;owned\007\033[2J\u009by.deck"
        self.deck(plate(), name)
        for command in (("check",), ("run", "--out", "out")):
            result = self.expect(0, command[0], name, *command[1:])
            for text in (result.stdout, result.stderr):
                self.assertNotRegex(text, "[\033\007\u009b]")
        self.assertNotIn("\033", (self.folder / "out" / "listing.txt").read_text(encoding="utf-8"))
        self.deck(plate("$FOO\n"), name)
        self.assertNotIn("\033", self.expect(3, "check", name).stderr)

    def test_a_bare_number_for_one_with_a_unit(self):
        text = plate().replace("$MESH", "$PARAMETER\n  n = 2\n  g = 0.3[kN]\n  F = 0.1[kN]\n  w = 10[mm]\n  t = 2*0.1[kN]\n$MESH", 1)
        self.deck(text)
        for define, warned in (
            ("F=80", "[kN]"),
            ("t=80", "[kN]"),
            ("F=80[kN]", ""),
            ("F=80[N]", ""),
            ("F=0", ""),
            ("F=2*n", "[kN]"),
            ("F=2*g", ""),
            ("w=12", ""),  # the deck's own unit
            ("n=3", ""),
        ):
            errors = self.expect(0, "check", "test.deck", "-D", define).stderr
            self.assertEqual("W464" in errors, bool(warned), define + errors)
            self.assertIn(warned, errors)
        self.assertIn("it is 0.08[kN]", self.expect(0, "check", "test.deck", "-D", "F=80").stderr)
        sweep = text.replace("$END", "$SWEEP PARAMETER=F\n  {}\n$END")
        for values, count in (("60 70", 2), ("60[kN] (70)[kN]", 0)):
            errors = self.expect(0, "check", self.deck(sweep.format(values))).stderr
            self.assertEqual(len(re.findall("W464", errors)), count, errors)

    def test_mixed_units(self):
        for units, warned in (
            ("LENGTH=IN FORCE=N", True),
            ("LENGTH=MM FORCE=LBF", True),
            ("LENGTH=IN FORCE=LBF", False),
            ("LENGTH=M FORCE=N", False),
        ):
            errors = self.run_program("check", self.deck(plate().replace("LENGTH=MM FORCE=N", units))).stderr
            self.assertEqual("W465" in errors, warned, units)


if __name__ == "__main__":
    main()
