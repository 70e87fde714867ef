# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual's first deck: what a new user types must run, and print what the page says."""

import re

from program import TOP, ProgramTest, main

PAGE = (TOP / "manual" / "first_deck.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```\n(.*?)^```", PAGE, re.S | re.M)


def deck_of_the_page(growth=False):
    cards = [b for b in BLOCKS if b.startswith("$")]
    grow = [b for b in cards if "$GROW" in b]
    text = "".join(b for b in cards if b not in grow)
    if growth:
        text = text.replace("$CHECK", grow[0] + "$CHECK").replace("PULL)", "PULL,20)")
    return text


class FirstDeck(ProgramTest):
    def test_the_deck_runs_and_prints_what_the_page_shows(self):
        printed = self.expect(0, "run", self.deck(deck_of_the_page())).stdout
        shown = next(b for b in BLOCKS if b.startswith("PULL"))
        for line in shown.splitlines():
            self.assertIn(line, printed)

    def test_the_growing_crack_runs(self):
        printed = self.expect(0, "run", self.deck(deck_of_the_page(growth=True))).stdout
        self.assertEqual(printed.count("PULL "), 6)


if __name__ == "__main__":
    main()
