# SPDX-License-Identifier: GPL-3.0-or-later
"""A rank that is lost ends the run, and its state is whole; a signal to mpirun reaches the run."""

import os
import signal
import unittest

from mpi_runs import CRACKED, MISSING, RankTest, keeping, main

LENGTHS = "  ".join(f"{1 + 0.05 * i:g}" for i in range(24))
# Slow enough to be met at work; parts of a body, so that each rank has some.
LONG = keeping(CRACKED.replace("  1  1.5  2\n", f"  {LENGTHS}\n").replace("NX=4 NY=2", "NX=40 NY=20"))


@unittest.skipIf(MISSING, MISSING)
class LostRank(RankTest):
    def goes_on_alone(self, deck):
        """Without mpirun, to the bits of a run that nothing stopped."""
        result = self.expect(0, "run", deck, "--restart")
        self.expect(0, "run", deck, "--out", "whole.run", "--quiet")
        self.same_folders(self.folder / "whole.run", self.folder / "test.run")
        return result

    def test_a_rank_is_killed(self):
        deck = self.deck(LONG)
        for rank in (1, 0):
            with self.subTest(rank):
                mpirun = self.start_ranks(2, "run", deck, "--quiet", "--restart")
                self.wait_for_increments(len(self.increments()) + 2)
                os.kill(self.process_of_rank(mpirun, rank), signal.SIGKILL)
                _, errors = mpirun.communicate(timeout=60)
                self.assertEqual(mpirun.returncode, 128 + signal.SIGKILL, errors)
                self.assertFalse((self.folder / "test.run").exists())
        self.goes_on_alone(deck)

    def test_a_signal_to_mpirun(self):
        deck = self.deck(LONG)
        mpirun = self.start_ranks(2, "run", deck, "--quiet")
        self.wait_for_increments(2)
        mpirun.send_signal(signal.SIGTERM)
        _, errors = mpirun.communicate(timeout=60)
        self.assertNotEqual(mpirun.returncode, 0, errors)
        self.assertRegex(errors, "stopped by SIGTERM: [0-9]+ increments are kept in .*state.rst")
        self.goes_on_alone(deck)


if __name__ == "__main__":
    main()
