# SPDX-License-Identifier: GPL-3.0-or-later
"""The formatter as a command: files, links, permissions, filters."""

import os
import stat

from program import ProgramTest, main, plate

UGLY = plate().replace("$STEP NAME=LOAD", "$step  name = LOAD   ! on")
NEAT = plate().replace("$STEP NAME=LOAD", "$STEP NAME=LOAD      ! on")


class Format(ProgramTest):
    def test_writes_to_stdout_and_leaves_the_file(self):
        deck = self.deck(UGLY)
        self.assertEqual(self.expect(0, "format", deck).stdout, NEAT)
        self.assertEqual(deck.read_text(), UGLY)

    def test_is_a_filter(self):
        self.assertEqual(self.expect(0, "format", "-", stdin=UGLY).stdout, NEAT)
        self.expect(1, "format", "--check", "-", stdin=UGLY)

    def test_check(self):
        deck = self.deck(UGLY)
        result = self.expect(1, "format", "--check", deck)
        self.assertEqual(result.stdout, "")
        self.assertIn("would change", result.stderr)
        self.assertEqual(deck.read_text(), UGLY)
        self.expect(0, "format", "--check", self.deck(NEAT))

    def test_in_place_keeps_links_and_permissions(self):
        deck = self.deck(UGLY, "real.deck")
        deck.chmod(0o640)
        link = self.folder / "link.deck"
        link.symlink_to("real.deck")
        self.assertEqual(self.expect(0, "format", "--in-place", link).stdout, "")
        self.assertTrue(link.is_symlink())
        self.assertEqual(deck.read_text(), NEAT)
        self.assertEqual(stat.S_IMODE(deck.stat().st_mode), 0o640)
        self.assertEqual(sorted(os.listdir(self.folder)), ["link.deck", "real.deck"])

    def test_in_place_does_not_touch_what_is_neat(self):
        deck = self.deck(NEAT)
        before = deck.stat().st_ino
        self.expect(0, "format", "--in-place", deck)
        self.assertEqual(deck.stat().st_ino, before)

    def test_syntax_errors_are_refused(self):
        text = plate("$STEP NAME=\n")
        deck = self.deck(text)
        for options in ([], ["--check"], ["--in-place"]):
            result = self.expect(3, "format", *options, deck)
            self.assertEqual(result.stdout, "")
            self.assertIn("error E101", result.stderr)
        self.assertEqual(deck.read_text(), text)


if __name__ == "__main__":
    main()
