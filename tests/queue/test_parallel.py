# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep shared by GNU parallel: as many tasks as points, two at a time; the files are those of one process."""

import shutil
import unittest

from sweeps import FULL, POINTS, PROGRAM, SweepTest, environment, main, sweep_deck

TASKS = 40 if FULL else POINTS


@unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
class Parallel(SweepTest):
    def test_tasks_by_parallel(self):
        deck = self.deck(sweep_deck())
        done = self.in_folder("parallel", "--will-cite", "--jobs", 2, PROGRAM, "sweep", deck, "--out", "shared", "--quiet",
                              "--array", f"{{}}/{TASKS}", ":::", *range(1, TASKS + 1),
                              env=environment(OPENBLAS_NUM_THREADS="1", HOME=str(self.folder)))
        self.assertEqual(done.returncode, 1, done.stderr)  # parallel counts the tasks that fail: one
        self.expect(3, "sweep", deck, "--out", "shared", "--collect", "--quiet")
        self.whole_sweep(deck)
        self.same_sweeps("whole", "shared")


if __name__ == "__main__":
    main()
