# SPDX-License-Identifier: GPL-3.0-or-later
"""CPU seconds, wall seconds and peak memory of a child process on one thread."""
import csv
import functools
import math
import os
import subprocess
import time
from dataclasses import dataclass


@dataclass
class Cost:
    code: int      # exit code, -9 when it took too long
    cpu: float     # user + system [s]
    wall: float    # [s]
    memory: float  # high water mark of the resident set [MiB]


def peak(pid):
    """VmHWM [MiB]. The ru_maxrss of a child would count the memory of this script before exec."""
    try:
        with open(f"/proc/{pid}/status") as status:
            for line in status:
                if line.startswith("VmHWM"):
                    return float(line.split()[1]) / 1024.0
    except OSError:
        pass
    return 0.0


def run(command, folder, log, limit=1800.0):
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                       CCX_NPROC_RESULTS="1")
    start = time.time()
    memory, late = 0.0, False
    with open(os.path.join(folder, log), "w") as out:
        child = subprocess.Popen(command, cwd=folder, stdout=out, stderr=subprocess.STDOUT,
                                 env=environment)
        while True:
            pid, status, usage = os.wait4(child.pid, os.WNOHANG)
            if pid != 0:
                break
            memory = max(memory, peak(child.pid))
            if time.time() - start > limit and not late:
                child.kill()
                late = True
            time.sleep(0.002)
    child.returncode = os.waitstatus_to_exitcode(status)
    return Cost(child.returncode, usage.ru_utime + usage.ru_stime, time.time() - start, memory)


@functools.cache
def dgemm_rate():
    """Flops in a CPU second of a product of two dense matrices on one thread; the best of five.
    Python3-numpy takes the same OpenBLAS as the program."""
    code = ("import numpy, time; A = numpy.ones((1500, 1500))\n"
            "def once():\n    start = time.process_time(); A @ A\n"
            "    return time.process_time() - start\n"
            "print(2.0 * 1500.0**3 / min(once() for _ in range(5)))")
    return float(subprocess.run(
        ["/usr/bin/python3", "-c", code], env=dict(os.environ, OPENBLAS_NUM_THREADS="1"), check=True,
        capture_output=True, text=True).stdout)


def floor_flops(run):
    """Of one plain factorisation, out of the profile of a run folder; NaN: it has none."""
    with open(os.path.join(run, "profile.csv"), encoding="utf-8") as table:
        for row in csv.DictReader(line for line in table if not line.startswith("#")):
            if row["kind"] == "floor":
                return float(row["flops"] or math.nan)
    return math.nan
