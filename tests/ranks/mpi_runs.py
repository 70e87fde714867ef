# SPDX-License-Identifier: GPL-3.0-or-later
"""The program started by mpirun, where that is installed and the program has the module for it."""

import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "restart"))

from run_folders import (  # noqa: E402,F401
    CRACKED,
    KEEP,
    PROGRAM,
    TOP,
    RestartTest,
    contents,
    corner,
    environment,
    keeping,
    main,
    press_fit,
)

PATIENCE = 300
MEMORY = re.compile(r"at most (\d+) MB of memory, forecast (\d+) MB")
MPIRUN = shutil.which("mpirun")
MODULE = Path(PROGRAM).resolve().parents[1] / "libexec/spricka/spricka-mumps-mpi.so"
MISSING = "" if MPIRUN and MODULE.exists() else "mpirun or the module for MPI is not there"
# In a container the user is root; threads of the dense kernels would only be in each other's way.
SETTINGS = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OPENBLAS_NUM_THREADS": "1",
}


class RankTest(RestartTest):
    def start_ranks(self, count, *arguments):
        """Starts that many ranks and does not wait."""
        return subprocess.Popen(
            [MPIRUN, "-n", str(count), PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            env=environment(**SETTINGS),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def run_ranks(self, code, count, *arguments):
        """Output and messages of a run that must end with the code."""
        child = self.start_ranks(count, *arguments)
        try:
            output, errors = child.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            child.kill()
            raise
        self.assertEqual(child.returncode, code, output + errors)
        return output, errors

    def process_of_rank(self, mpirun, rank):
        """The number of the process that mpirun has started as this rank; it may still be starting."""
        for _ in range(600):
            for children in Path(f"/proc/{mpirun.pid}/task").glob("*/children"):
                for pid in children.read_text().split():
                    try:
                        words = Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
                    except OSError:  # it has ended
                        continue
                    if f"OMPI_COMM_WORLD_RANK={rank}".encode() in words:
                        return int(pid)
            time.sleep(0.05)
        return self.fail(f"mpirun has started no rank {rank}")

    def wait_for_increments(self, count):
        for _ in range(1200):
            if len(self.increments()) >= count and (self.folder / "state.rst").exists():
                return
            time.sleep(0.05)
        self.fail("no state was written")

    def lines_of_ranks(self, folder):
        """RANK n: of the processor log."""
        listing = (self.folder / folder / "listing.txt").read_text(encoding="utf-8")
        return [line for line in listing.splitlines() if line.strip().startswith("RANK ")]

    def check_memory_of_ranks(self, folder):
        """The largest memory of every rank within 30 % of the forecast."""
        lines = self.lines_of_ranks(folder)
        self.assertTrue(lines)
        for line in lines:
            peak, forecast = map(int, MEMORY.search(line).groups())
            self.assertLess(abs(peak - forecast), 0.3 * forecast, line)

    def copy_deck(self, name):
        for file in [f"{name}.deck", *(f.name for f in (TOP / "decks").glob("*.inc")),
                     *(f.name for f in (TOP / "decks").glob("*.geo"))]:
            shutil.copy(TOP / "decks" / file, self.folder)
        return self.folder / f"{name}.deck"
