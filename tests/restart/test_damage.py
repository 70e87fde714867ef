# SPDX-License-Identifier: GPL-3.0-or-later
"""Restart files damaged by chance, and signals at any moment: never other numbers, never a crash.
SPRICKA_FULL: as many as make a difference; SPRICKA_SEED: others."""

import os
import random
import shutil
import signal
import time

from run_folders import CRACKED, RestartTest, contents, keeping, main

FULL = bool(os.environ.get("SPRICKA_FULL"))
SEED = int(os.environ.get("SPRICKA_SEED", "20261"))
DAMAGES = 500 if FULL else 30
SIGNALS = 50 if FULL else 8


class Damage(RestartTest):
    def setUp(self):
        super().setUp()
        self.dice = random.Random(SEED)
        self.expect(0, "run", self.deck(keeping()), "--out", "whole.run", "--quiet")
        self.whole = contents(self.folder / "whole.run")

    def same(self, folder, where):
        """As the whole run; a comparison of so many bytes line by line would take for ever."""
        found = contents(folder)
        differ = [name for name in found.keys() | self.whole.keys() if found.get(name) != self.whole.get(name)]
        self.assertEqual(differ, [], (SEED, where))

    def keep(self):
        for f in self.folder.glob("state.rst*"):
            copy = self.folder / ("kept." + f.name)
            shutil.copytree(f, copy) if f.is_dir() else shutil.copy(f, copy)

    def restore(self):
        for f in self.folder.glob("state.rst*"):
            shutil.rmtree(f) if f.is_dir() else f.unlink()
        for f in self.folder.glob("kept.state.rst*"):
            to = self.folder / f.name.removeprefix("kept.")
            shutil.copytree(f, to) if f.is_dir() else shutil.copy(f, to)

    def damaged(self, data, others):
        kind = self.dice.random()
        at = self.dice.randrange(max(1, len(data)))
        if kind < 0.6:
            data[at] ^= 1 << self.dice.randrange(8)
        elif kind < 0.75:
            del data[at:]
        elif kind < 0.9:
            data[at : at + 64] = self.dice.randbytes(64)
        elif kind < 0.95:
            data = bytearray(self.dice.choice(others).read_bytes())
        else:
            data = bytearray()
        return data

    def test_damaged_states(self):
        self.keep()
        files = [f for f in self.folder.rglob("*") if f.is_file() and str(f.relative_to(self.folder)).startswith("state.rst")]
        self.assertGreater(len(files), 3)
        outcomes = set()
        for number in range(DAMAGES):
            self.restore()
            for _ in range(self.dice.choice((1, 1, 1, 3))):
                file = self.dice.choice(files)
                file.write_bytes(self.damaged(bytearray(file.read_bytes()), files))
            result = self.run_program("run", "test.deck", "--restart", "--out", "out", "--quiet")
            outcomes.add(result.returncode)
            self.assertIn(result.returncode, (0, 7), (SEED, number, result.stderr))
            if result.returncode == 0:
                self.same(self.folder / "out", number)
        self.assertEqual(outcomes, {0, 7})

    def test_signals_at_any_moment(self):
        for number in range(SIGNALS):
            for f in self.folder.glob("state.rst*"):
                shutil.rmtree(f) if f.is_dir() else f.unlink()
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            sign = self.dice.choice(
                (signal.SIGTERM, signal.SIGINT, signal.SIGKILL, signal.SIGHUP, signal.SIGPIPE)
            )
            child = self.start("run", "test.deck", "--out", "out", "--quiet")
            time.sleep(self.dice.uniform(0.0, 0.5))
            child.send_signal(sign)
            _, errors = child.communicate(timeout=60)
            self.assertIn(child.returncode, (0, 6, -sign, 128 + sign), (SEED, number, errors))
            if (self.folder / "out").exists():  # whole, or not there
                self.same(self.folder / "out", number)
            # dead at once, before anything could be put in order, or by SIGKILL: the next run tidies up
            self.expect(0, "run", "test.deck", "--out", "out", "--quiet", "--restart")
            self.same(self.folder / "out", (number, sign))
            self.assertFalse((self.folder / "out.part").exists())


if __name__ == "__main__":
    main()
