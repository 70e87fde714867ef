# SPDX-License-Identifier: GPL-3.0-or-later
"""Colour on a terminal, and messages as JSON."""

import json

from program import CRACKED, ProgramTest, main, plate

WRONG = plate("$STEP NAME=MORE\n  LOAD PULLL 1\n$CONTROL THRAEDS=1\n")


class Colour(ProgramTest):
    def test_only_on_a_terminal(self):
        deck = self.deck(WRONG)
        seen = self.on_terminal("check", deck)
        self.assertIn("\033[1;31merror E301:\033[0m there is no load case", seen)
        self.assertIn("\033[1;32m", seen)  # carets
        self.assertNotIn("\033", self.expect(3, "check", deck).stderr)

    def test_words_are_those_without_colour(self):
        deck = self.deck(WRONG)
        seen = self.on_terminal("check", deck)
        for sequence in ("\033[1m", "\033[1;31m", "\033[1;32m", "\033[0m"):
            seen = seen.replace(sequence, "")
        self.assertEqual(seen, self.expect(3, "check", deck).stderr)

    def test_can_be_declined(self):
        deck = self.deck(WRONG)
        plain = self.expect(3, "check", deck).stderr
        self.assertEqual(self.on_terminal("check", deck, NO_COLOR="1"), plain)
        self.assertEqual(self.on_terminal("check", deck, TERM="dumb"), plain)
        self.assertIn("\033", self.on_terminal("check", deck, NO_COLOR=""))  # empty: not set


class Json(ProgramTest):
    def records(self, code, *arguments):
        result = self.expect(code, *arguments, "--log-format", "json")
        return [json.loads(line) for line in result.stderr.splitlines()]

    def test_places_are_those_of_the_deck(self):
        deck = self.deck(WRONG)
        records = self.records(3, "check", deck)
        self.assertEqual([r["code"] for r in records], ["E301", "E105"])
        lines = WRONG.splitlines()
        for record, word in zip(records, ("PULLL", "THRAEDS")):
            self.assertEqual(record["type"], "diagnostic")
            self.assertEqual(record["severity"], "error")
            self.assertEqual(record["file"], str(deck))
            self.assertEqual(record["line"], record["end_line"])
            found = lines[record["line"] - 1][record["column"] - 1 : record["end_column"] - 1]
            self.assertEqual(found, word)
            self.assertIn("did you mean", record["hint"])

    def test_all_errors_not_only_twenty(self):
        deck = self.deck(plate("".join(f"$NOCARD{i}\n" for i in range(30))))
        self.assertEqual(len(self.records(3, "check", deck)), 30)

    def test_warnings_have_their_severity(self):
        text = plate().replace("NU=0.3", "NU=0.4999").replace("STATE=STRESS", "STATE=STRAIN")
        text = text.replace("QUAMC8", "TRIM3")
        records = self.records(0, "check", self.deck(text))
        self.assertEqual([(r["severity"], r["code"]) for r in records], [("warning", "W501")])

    def test_bytes_that_are_no_text(self):
        deck = self.folder / "latin.deck"
        deck.write_bytes(plate("$STRA\xdfE\n").encode("latin-1"))
        self.assertTrue(self.records(3, "check", deck))

    def test_trouble_with_the_file(self):
        (record,) = self.records(7, "check", "none.deck")
        self.assertEqual(record["code"], "E530")
        self.assertIn("none.deck", record["text"])

    def test_progress(self):
        records = self.records(0, "run", self.deck(CRACKED))
        steps = [(r["increment"], r["of"]) for r in records if r["type"] == "progress"]
        self.assertEqual(steps, [(1, 3), (2, 3), (3, 3)])
        self.assertEqual(self.records(0, "run", "test.deck", "--quiet"), [])

    def test_failed_check(self):
        deck = self.deck(plate("$CHECK\n  S.XX.MAX(XMAX,LOAD) = 7  REL 1e-3\n"))
        (check,) = [r for r in self.records(1, "run", deck) if r["type"] == "check"]
        self.assertFalse(check["passed"])
        self.assertEqual(check["wanted"], 7)
        self.assertGreater(check["error"], check["tolerance"])


if __name__ == "__main__":
    main()
