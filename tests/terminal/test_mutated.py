# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks with something changed by chance: the program ends soon, with one of its own exit codes, and a
run that is called good has results that are numbers. SPRICKA_FULL: many more; SPRICKA_SEED: others."""

import os
import random
import re
import shutil
import subprocess

from program import PROGRAM, SANITIZED, TOP, ProgramTest, environment, main

FULL = bool(os.environ.get("SPRICKA_FULL"))
COUNT = 40 if not FULL else 200 if SANITIZED else 2000
DECKS = ("edge_crack", "contact_patch", "cantilever", "patch_test", "thick_cylinder", "curved_beam")
NUMBER = re.compile(r"(?<![A-Za-z_$.\d])[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
WORD = re.compile(r"[A-Za-z_$.][A-Za-z_0-9.]*")
ODD = "0 -1 1e308 -1e308 1e-308 1e9 1e-9 nan inf 1e400 (1/0) (sqrt(-1)) 90[deg] 1[MPa] (x) -0 7".split()


class Mutator:
    def __init__(self, texts, seed):
        self.dice = random.Random(seed)
        self.words = [w for t in texts for w in WORD.findall(t)]
        self.cards = [
            c
            for t in texts
            for c in re.split(r"(?m)^(?=\$)", t)
            if c.startswith("$") and not c.startswith(("$DECK", "$END"))
        ]

    def one(self, text):
        return self.dice.choice((self.number, self.number, self.word, self.line, self.card, self.byte))(text)

    def number(self, text):
        found = list(NUMBER.finditer(text))
        if not found:
            return text
        at = self.dice.choice(found)
        value = float(at.group()) * self.dice.choice((0.1, 0.5, 0.9, 1.1, 2, -1, 1e3, 1e-3))
        new = self.dice.choice((self.dice.choice(ODD), f"{value:.12g}"))
        return text[: at.start()] + new + text[at.end() :]

    def word(self, text):
        at = self.dice.choice(list(WORD.finditer(text)))
        return text[: at.start()] + self.dice.choice(self.words) + text[at.end() :]

    def line(self, text):
        lines = text.splitlines(True)
        at = self.dice.randrange(len(lines))
        if self.dice.random() < 0.5:
            del lines[at]
        else:
            lines.insert(self.dice.randrange(len(lines)), lines[at])
        return "".join(lines)

    def card(self, text):
        parts = re.split(r"(?m)^(?=\$)", text)
        parts.insert(self.dice.randrange(1, len(parts)), self.dice.choice(self.cards))
        return "".join(parts)

    def byte(self, text):
        at = self.dice.randrange(len(text))
        return text[:at] + self.dice.choice("\0\r'()&!${:/*^-,;@\u202eé") + text[at + 1 :]


class Mutated(ProgramTest):
    def call(self, *arguments):
        return subprocess.run(
            [PROGRAM, *arguments, "--threads", "1"],
            cwd=self.folder,
            env=environment(OPENBLAS_NUM_THREADS="1"),
            capture_output=True,
            timeout=1000 if SANITIZED else 100,
            check=False,
        )

    def test_mutated_decks(self):
        texts = [(TOP / "decks" / f"{name}.deck").read_text(encoding="utf-8") for name in DECKS]
        for f in (TOP / "decks").iterdir():
            if f.suffix in (".inc", ".geo", ".msh", ".inp"):
                shutil.copy(f, self.folder)
        seed = int(os.environ.get("SPRICKA_SEED", "20261"))
        mutator = Mutator(texts, seed)
        for number in range(COUNT):
            text = mutator.dice.choice(texts)
            for _ in range(mutator.dice.choice((1, 1, 2, 3))):
                text = mutator.one(text)
            self.deck(text, "m.deck")
            checked = self.call("check", "m.deck")
            self.assertIn(checked.returncode, range(8), (seed, number, text, checked.stderr[-500:]))
            if checked.returncode != 0:
                continue
            run = self.call("run", "m.deck", "--out", "out", "--quiet")
            self.assertIn(run.returncode, range(8), (seed, number, text, run.stderr[-500:]))
            self.assertNotEqual(run.returncode, 3, ("check passed it", seed, number, text))
            if run.returncode == 0 and (self.folder / "out" / "k.csv").exists():
                for table in ("k.csv", "pressure.csv"):
                    rows = (self.folder / "out" / table).read_text(encoding="utf-8")
                    self.assertIsNone(re.search(r"(?m)(^|,)-?(nan|inf)(,|$)", rows), (seed, number, text))
            shutil.rmtree(self.folder / "out", ignore_errors=True)


if __name__ == "__main__":
    main()
