# SPDX-License-Identifier: GPL-3.0-or-later
"""CPU seconds, wall seconds and peak memory of a child process on one thread."""
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
