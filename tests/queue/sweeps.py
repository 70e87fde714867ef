# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps for tests of job arrays, and sweep folders compared to the byte."""

import os
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "restart"))

from run_folders import CRACKED, PROGRAM, RestartTest, contents, environment, keeping, main  # noqa: E402,F401

FULL = bool(os.environ.get("SPRICKA_FULL"))
POINTS = 200 if FULL else 6


def sweep_deck(points=POINTS, more=""):
    """A cracked plate under `points` loads, of which the last but one has no solution: E is not positive there."""
    loads = "  ".join(f"{100 + i}" for i in range(points))
    text = CRACKED.replace("$MESH", "$PARAMETER\n  s = 100\n$MESH").replace("YMAX  0  100", "YMAX  0  (s)")
    text = text.replace("E=210[GPa]", f"E=(210000*(1 - 2*(s == {100 + points - 2})))")
    return text.replace("$END\n", f"$OUTPUT FILE='k_end.csv' FORMAT=CSV EVERY=END\n  K C\n{more}"
                        f"$SWEEP PARAMETER=s\n  {loads}\n$END\n")


class SweepTest(RestartTest):
    def same_sweeps(self, one, other):
        """All files, but for the listings, which tell times."""
        a, b = contents(self.folder / one), contents(self.folder / other)
        self.assertEqual(sorted(a), sorted(b))
        self.assertEqual([name for name in a if a[name] != b[name]], [])
        return a

    def until(self, there, child):
        """Waits while the child runs."""
        end = time.monotonic() + 120
        while not there():
            if child.poll() is not None or time.monotonic() > end:
                child.kill()
                self.fail(f"it has not come to that: {child.communicate()}")
            time.sleep(0.002)

    def whole_sweep(self, deck):
        """The same by one process; the code of its worst point."""
        return self.expect(3, "run", deck, "--out", "whole", "--quiet")

    def in_folder(self, *words, **more):
        return subprocess.run([str(w) for w in words], cwd=self.folder, text=True, capture_output=True, timeout=900,
                              check=False, **more)
