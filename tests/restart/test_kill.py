# SPDX-License-Identifier: GPL-3.0-or-later
"""A growth that is killed at any moment goes on to the same bits: the lug's, and fronts in space that go
through a surface."""

import os
import random
import shutil
import time

from run_folders import TOP, RestartTest, corner, keeping, main

FULL = bool(os.environ.get("SPRICKA_FULL"))
KILLS = 100 if FULL else 4
KILLS_IN_SPACE = 15 if FULL else 1  # of each shape
SEED = 20261


class Kill(RestartTest):
    def lug(self):
        for name in ("lug_model.inc", "lug_parts.inc", "lug.geo", "sleeve.geo", "shaft.geo"):
            if (TOP / "decks" / name).exists():
                shutil.copy(TOP / "decks" / name, self.folder)
        text = (TOP / "decks" / "lug_single.deck").read_text(encoding="utf-8")
        return self.deck(text.replace("$CHECK", "$RESTART WRITE='lug.rst'\n$CHECK", 1), "lug.deck")

    def test_same_bits_after_a_kill(self):
        self.check(self.lug(), "lug.rst", KILLS)

    def test_same_bits_inside_zones_of_overloads(self):
        text = (TOP / "decks" / "edge_crack_overloads.deck").read_text(encoding="utf-8")
        deck = self.deck(text.replace("$CHECK", "$RESTART WRITE='overloads.rst'\n$CHECK", 1), "overloads.deck")
        self.check(deck, "overloads.rst", KILLS)

    def test_same_bits_in_space(self):
        for shape in ("FREE", "ELLIPSE") if FULL else ("ELLIPSE",):  # the other one: test_growth.py
            with self.subTest(shape):
                deck = self.deck(keeping(corner(shape)), f"{shape}.deck")
                self.check(deck, "state.rst", KILLS_IN_SPACE)

    def check(self, deck, kept, kills):
        begin = time.monotonic()
        self.expect(0, "run", deck, "--out", "whole.run", "--quiet")
        whole = time.monotonic() - begin
        dice = random.Random(SEED)
        gone_on = 0
        for attempt in range(kills):
            for name in os.listdir(self.folder):
                if name.startswith(kept):
                    path = self.folder / name
                    shutil.rmtree(path) if path.is_dir() else path.unlink()
            for _ in range(1 + attempt % 2):  # some die twice
                child = self.start("run", deck, "--out", "killed.run", "--quiet", "--restart")
                time.sleep(dice.uniform(0.0, whole))
                child.kill()
                child.communicate()
            gone_on += (self.folder / kept).exists()
            self.expect(0, "run", deck, "--out", "killed.run", "--quiet", "--restart")
            self.same_folders(self.folder / "whole.run", self.folder / "killed.run")
        self.assertGreater(gone_on, 0, "no kill left a state: nothing was tested")


if __name__ == "__main__":
    main()
