# SPDX-License-Identifier: GPL-3.0-or-later
"""Help, version, and what was probably meant by a misspelt word."""

import json
import re

from program import ProgramTest, main

COMMANDS = ["run", "check", "shell", "help", "format", "schema", "editor", "completion", "man"]


class Help(ProgramTest):
    def test_overview_names_the_cards_by_group(self):
        out = self.expect(0, "help").stdout
        for word in ("$DECK", "$CONTACT", "crack: ", "requests: "):
            self.assertIn(word, out)

    def test_card_in_any_spelling_of_its_name(self):
        first = self.expect(0, "help", "CONTACT").stdout
        self.assertIn("DIAMETRAL", first)
        self.assertIn("Example:\n  $CONTACT NAME=", first)
        self.assertIn("At most one of INTERFERENCE, DIAMETRAL and GAP", first)
        for name in ("contact", "$contact", "$CONTACT", "Contact"):
            self.assertEqual(self.expect(0, "help", name).stdout, first)

    def test_every_card_of_the_schema_has_help(self):
        schema = json.loads(self.expect(0, "schema").stdout)
        self.assertGreater(len(schema["cards"]), 25)
        for card in schema["cards"]:
            out = self.expect(0, "help", card["name"]).stdout
            for key in card["keys"]:
                self.assertRegex(out, rf"(?m)^  {key['name']} ")

    def test_lists(self):
        self.assertIn("CPRESS.AT(contact, step, theta", self.expect(0, "help", "quantities").stdout)
        self.assertIn("atan2(y, x)", self.expect(0, "help", "functions").stdout)
        self.assertRegex(self.expect(0, "help", "units").stdout, r"GPa\s+stress\s+1000000000")
        self.assertIn("U.X.AT(x, y", self.expect(0, "help", "u.x.at").stdout)

    def test_growth_laws_that_ship(self):
        out = self.expect(0, "help", "materials").stdout
        for word in ("AL2024_T3_SHEET_LT  NASGRO", "L-T", "DOT/FAA/AR-05/15", "not stated", "KC 81.6"):
            self.assertIn(word, out)
        self.assertIn("MATERIAL=", self.expect(0, "help", "law").stdout)

    def test_keys_and_words(self):
        self.assertIn("$CONTACT DIAMETRAL", self.expect(0, "help", "diametral").stdout)
        out = self.expect(0, "help", "QUAMC8").stdout
        self.assertIn("$MESH TYPE=QUAMC8", out)
        self.assertIn("$ELEMENT TYPE=QUAMC8", out)
        self.assertIn("atan2(y, x)", self.expect(0, "help", "atan2").stdout)

    def test_every_error_code_is_explained(self):
        codes = re.findall(r"(?m)^  ([EW]\d{3})", self.expect(0, "help", "codes").stdout)
        self.assertGreater(len(codes), 60)
        for code in ("E108", "e108", "E429", "W501"):
            self.assertTrue(self.expect(0, "help", code).stdout.startswith(code.upper() + ": "))

    def test_unknown_topic(self):
        result = self.expect(2, "help", "contakt")
        self.assertEqual(result.stdout, "")
        self.assertIn("did you mean 'CONTACT'?", result.stderr)
        self.assertIn("spricka help", self.expect(2, "help", "qwertyuiop").stderr)
        self.assertIn("did you mean 'retardation'?", self.expect(2, "help", "retartadion").stderr)

    def test_words_of_the_field_lead_on(self):
        """What an engineer asks for, and a card, result or page that the answer names."""
        for word, *named in (
            ("flaw", "$CRACK", "cracks.md"),
            ("bushing", "$CONTACT", "DIAMETRAL", "howto/interference.md"),
            ("bush", "$CONTACT", "howto/interference.md"),
            ("beta", "beta.csv", "howto/beta_tables.md"),
            ("geometry factor", "beta.csv"),
            ("damage tolerance", "$GROW", "growth.md"),
            ("retardation", "$INTERACTION", "interaction.md"),
            ("inspection", "N(a)", "LIFE()", "growth.md"),
            ("lug", "$MESH SHAPE=LUG", "lug.md"),
            ("fit", "$CONTACT", "DIAMETRAL", "howto/interference.md"),
            ("life", "LIFE()", "$GROW", "growth.md"),
            ("residual strength", "KC", "SFLOW"),
            ("load transfer", "SUM", "BEARING"),
        ):
            out = self.expect(0, "help", word).stdout
            for name in named:
                self.assertIn(name, out, word)
            self.assertEqual(self.expect(0, "help", *word.upper().split()).stdout, out)

    def test_words_of_the_field_are_listed(self):
        out = self.expect(0, "help", "words").stdout
        for word in re.findall(r"(?m)^  (\w[\w -]*?)  ", out):
            self.assertIn("Manual: ", self.expect(0, "help", word).stdout, word)
        self.assertRegex(out, r"(?m)^  bushing +bush, ")
        self.assertIn("spricka help words", self.expect(0, "help").stdout)

    def test_every_command_has_examples(self):
        out = self.expect(0, "--help").stdout
        self.assertIn("Exit codes:", out)
        for command in COMMANDS:
            self.assertRegex(out, rf"(?m)^  {command} ")
            text = self.expect(0, command, "--help").stdout
            self.assertIn(f"Examples:\n  ", text)
            self.assertIn(f"spricka {command}", text)


class Usage(ProgramTest):
    def refused(self, hint, *arguments):
        result = self.expect(2, *arguments)
        self.assertEqual(result.stdout, "")
        self.assertIn(hint, result.stderr)
        self.assertIn("--help", result.stderr)

    def test_nothing_given(self):
        self.refused("one of: run, check", *[])

    def test_misspelt_command(self):
        self.refused("did you mean 'check'?", "chekc", "a.deck")

    def test_command_left_out(self):
        self.refused("did you mean spricka run lug.deck?", "lug.deck")

    def test_misspelt_option(self):
        self.refused("did you mean '--threads'?", "run", "--theads", "4", "a.deck")
        self.refused("did you mean '--version'?", "--verson")

    def test_wrong_values(self):
        self.refused("not 'many'", "run", "--threads", "many", "a.deck")
        self.refused("did you mean 'json'?", "check", "--log-format", "jsn", "a.deck")
        self.refused("write -D NAME=expression", "run", "a.deck", "-D", "R")
        self.refused("one of: vim, vscode", "editor", "emacs")

    def test_too_few_and_too_many(self):
        self.refused("DECK is required", "run")
        self.refused("'b.deck' is one argument too many", "run", "a.deck", "b.deck")
        self.refused("excludes", "format", "--check", "--in-place", "a.deck")


class Version(ProgramTest):
    def test_names_the_libraries(self):
        out = self.expect(0, "--version").stdout
        self.assertRegex(out.splitlines()[0], r"^spricka \d+\.\d+\.\d+$")
        for library in ("gmsh", "CHOLMOD", "SuiteSparse", "Eigen", "Boost", "fmt", "CLI11", "zlib",
                        "xxHash", "OpenBLAS", "nlohmann-json"):
            self.assertRegex(out, rf"(?m)^  {library} .*\d+\.\d+")


if __name__ == "__main__":
    main()
