# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged scripts, mesh files, STEP files and input files: a mesh or words, never a crash and never without
end. usage: test_fuzz.py PROGRAM; SPRICKA_SEED looks elsewhere, SPRICKA_FULL longer."""

import os
import random
import re

from meshes import MeshTest
from program import TOP, main

SCRIPTS = ["strip_hole", "lug", "square_lug", "cook", "hertz_sphere", "interface_crack", "le11"]
NUMBER = re.compile(rb"(?<![A-Za-z_])[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
VALUES = [b"0", b"-1", b"1e308", b"1e9", b"99999999", b"-0.5", b"nan", b"1e-300", b"4294967297"]


def damaged(text, chance):
    for _ in range(chance.choice([1, 1, 2, 3])):
        numbers = list(NUMBER.finditer(text))
        lines = text.splitlines(True)
        kind = chance.random()
        if kind < 0.5 and numbers:
            at = chance.choice(numbers)
            text = text[: at.start()] + chance.choice(VALUES) + text[at.end() :]
        elif kind < 0.65 and len(lines) > 1:
            del lines[chance.randrange(len(lines))]
            text = b"".join(lines)
        elif kind < 0.8 and lines:
            lines.insert(chance.randrange(len(lines)), chance.choice(lines))
            text = b"".join(lines)
        elif kind < 0.95 and text:
            i = chance.randrange(len(text))
            text = text[:i] + bytes([chance.randrange(256)]) + text[i + 1 :]
        else:
            text = text[: chance.randrange(len(text) + 1)]
    return text


class Damaged(MeshTest):
    def test_files(self):
        chance = random.Random(int(os.environ.get("SPRICKA_SEED", "20261")))
        files = [("geo", (TOP / "decks" / f"{name}.geo").read_bytes()) for name in SCRIPTS]
        self.expect(0, "convert", TOP / "decks" / "strip_hole.geo", "whole.msh")
        files.append(("msh", (self.folder / "whole.msh").read_bytes()))
        files.append(("step", (TOP / "decks" / "lug_joint.step").read_bytes()))
        for i in range(900 if "SPRICKA_FULL" in os.environ else 30):
            kind, text = chance.choice(files)
            text = damaged(text, chance)
            (self.folder / f"x.{kind}").write_bytes(text)
            deck = self.deck(
                "$DECK VERSION=1 LENGTH=MM FORCE=N\n"
                f"$IMPORT FILE='x.{kind}' FORMAT={kind.upper()}\n$END\n"
            )
            result = self.run_program(
                "check", deck, "--mesh-time", "4", "--mesh-memory", "1", stdin=""
            )
            self.assertIn(result.returncode, (0, 3, 4), (i, result.stderr, text[:3000]))


main()
