# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks that take long: as they ship with SPRICKA_FULL=1, else their beginning, with the checks that it
reaches, or nothing where other tests see the same day by day.

long_deck.py PROGRAM DECK FOLDER [OPTIONS OF spricka run ..]
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77  # CTest's SKIP_RETURN_CODE
# What the beginning changes in the text, and the checks that it does not come to.
BEGINNINGS = {
    "corner_hole_life": (("AMAX=8 ", "AMAX=2.6 "), ("N(4)",)),
    "ellipse_test": (("AMAX=1.16 ", "AMAX=1.04 "), ("TEST.K(",)),
    "lug_corner_life": (("AMAX=6 ", "AMAX=1.9 "), ()),
    "surface_crack_life": (("AMAX=6 ", "AMAX=2.3 "), ("N(2.602)", "N(3.064)")),
}
# Who sees day by day what these see, or most of it.
SEEN_BY = {
    "friction_solid_life": "restart.growth runs its beginning, with its checks",
    "link_up_solid": "growth.front_growth joins fronts with K in closed form; K along a notched front is seen here alone",
    "surface_through_life": "growth.split_fronts splits fronts, stability.passages has K behind a passage",
}


def beginning_of(deck):
    (old, new), unreached = BEGINNINGS[deck.stem]
    text = deck.read_text(encoding="utf-8")
    if text.count(old) != 1:
        sys.exit(f"{deck} does not have {old!r} once")
    lines = text.replace(old, new).splitlines()
    kept = [line for line in lines if not line.strip().startswith(unreached or ("\0",))]
    if unreached and len(kept) == len(lines):
        sys.exit(f"{deck} has none of the checks {unreached}")
    if not any(re.match(r"\s+[A-Z][\w.]*\(.*\) +=", line) for line in kept[kept.index("$CHECK"):]):
        sys.exit(f"{deck}: no check is left")
    return "\n".join(kept) + "\n"


def main():
    program, deck, folder, *options = sys.argv[1:]
    deck = Path(deck)
    with tempfile.TemporaryDirectory() as short:
        if "SPRICKA_FULL" not in os.environ:
            if deck.stem in SEEN_BY:
                print(f"with SPRICKA_FULL=1; else {SEEN_BY[deck.stem]}")
                return SKIPPED
            for file in deck.parent.iterdir():
                if file.suffix != ".deck" and file.is_file():
                    (Path(short) / file.name).symlink_to(file)
            text = beginning_of(deck)
            deck = Path(short) / deck.name
            deck.write_text(text, encoding="utf-8")
        return subprocess.run([program, "run", deck, "--out", folder, "--quiet", *options], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
