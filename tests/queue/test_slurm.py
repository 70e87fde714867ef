# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep as a job array of Slurm, which the test starts on this machine: one task is killed, found by the collector and
submitted again; the files are those of one process."""

import os
import signal
import time
import unittest
from pathlib import Path

from one_node_slurm import OneNodeSlurm, is_installed
from sweeps import FULL, POINTS, PROGRAM, SweepTest, main, sweep_deck

TASKS = 10 if FULL else 3

JOB = """#!/bin/bash
#SBATCH --ntasks=1 --cpus-per-task=1
export OPENBLAS_NUM_THREADS=1
exec {program} sweep {deck} --out shared --array slurm --quiet
"""
COLLECT = """#!/bin/bash
exec {program} sweep {deck} --out shared --collect --quiet
"""


@unittest.skipUnless(is_installed(), "slurm-wlm and munge are not installed, or we are not root")
class Slurm(SweepTest):
    def job(self, text, name, deck):
        path = self.folder / name
        path.write_text(text.format(program=PROGRAM, deck=deck))
        return path

    def killed(self, slurm, job):
        """Kills, as a machine that fails would, whatever task is at its second point."""
        end = time.monotonic() + 120
        while time.monotonic() < end:
            for part in self.folder.glob("shared/0*.part/.spricka.owner"):
                try:
                    number, pid = int(part.parent.name[:3]), int(part.read_text().split()[1])
                except (OSError, ValueError, IndexError):
                    continue
                if number > TASKS and self.is_ours(pid):
                    os.kill(pid, signal.SIGKILL)
                    return (number - 1) % TASKS + 1
            time.sleep(0.002)
        self.fail(slurm.say("squeue").stdout)
        return 0

    @staticmethod
    def is_ours(pid):
        try:
            return b"sweep" in Path(f"/proc/{pid}/cmdline").read_bytes()
        except OSError:
            return False

    def test_an_array_with_a_task_that_is_killed(self):
        deck = self.deck(sweep_deck().replace("NX=4 NY=2", "NX=30 NY=15"))
        array, collect = self.job(JOB, "array.sh", deck), self.job(COLLECT, "collect.sh", deck)
        with OneNodeSlurm(self.folder / "slurm") as slurm:
            first = slurm.submit(array, f"--array=1-{TASKS}", cwd=self.folder)
            number = self.killed(slurm, first)
            slurm.wait_for(first)
            short = slurm.submit(collect, cwd=self.folder)
            slurm.wait_for(short)
            self.assertEqual(slurm.exit_code(short), ["6:0"], self.outputs())
            self.assertIn("missing in shared", self.outputs())
            missing = [n for n in range(1, POINTS + 1) if not (self.folder / f"shared/{n:03}").exists()
                       and not (self.folder / f"shared/{n:03}.failed").exists()]
            self.assertTrue(missing)
            self.assertEqual({(n - 1) % TASKS + 1 for n in missing}, {number})
            # The whole array once more: what is finished is passed over. The collector comes after it.
            again = slurm.submit(array, f"--array=1-{TASKS}", cwd=self.folder)
            last = slurm.submit(collect, f"--dependency=afterany:{again}", cwd=self.folder)
            slurm.wait_for(again)
            slurm.wait_for(last)
            self.assertEqual(slurm.exit_code(last), ["3:0"], self.outputs())  # the point without a solution
        self.whole_sweep(deck)
        self.same_sweeps("whole", "shared")

    @unittest.skipUnless(FULL, "SPRICKA_FULL is not set")
    def test_a_task_that_slurm_stops_goes_on(self):
        """What scancel --signal=TERM, or the end of a job's time, does: lengths are kept, exit code 6."""
        deck = self.deck(sweep_deck(3, "$RESTART WRITE='state.rst'\n").replace("NX=4 NY=2", "NX=60 NY=30"))
        job = self.job(JOB.replace("--quiet", "--quiet --restart"), "array.sh", deck)
        state = self.folder / "shared/003.restart/state.rst"
        with OneNodeSlurm(self.folder / "slurm") as slurm:
            first = slurm.submit(job, "--array=1-3", cwd=self.folder)
            end = time.monotonic() + 120
            while not state.exists():
                self.assertLess(time.monotonic(), end, self.outputs())
                time.sleep(0.002)
            slurm.say("scancel", "--batch", "--signal=TERM", f"{first}_3")
            slurm.wait_for(first)
            self.assertIn("6:0", slurm.exit_code(first), self.outputs())
            again = slurm.submit(job, "--array=3", cwd=self.folder)  # one task alone: all that is missing
            slurm.wait_for(again)
        self.assertIn("taken over", (self.folder / "shared/003/listing.txt").read_text())
        self.expect(3, "sweep", deck, "--out", "whole", "--quiet")
        for name in ("k.csv", "results.h5"):
            self.assertEqual((self.folder / "shared/003" / name).read_bytes(),
                             (self.folder / "whole/003" / name).read_bytes())

    def outputs(self):
        return "\n".join(f.read_text(errors="replace") for f in sorted(self.folder.glob("slurm-*.out")))


if __name__ == "__main__":
    main()
