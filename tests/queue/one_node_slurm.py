# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of one node for a test: own munge key and socket, own ports, no cgroups, no database, no systemd. It runs as
root in a container, and leaves nothing behind."""

import os
import pwd
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

NEEDED = ("setpriv", "munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "sinfo")
SBIN = "/usr/sbin:/sbin"

CONF = """ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmdPort={other_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmctldParameters=enable_configless
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_min_interval=100000
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MinJobAge=300
KillWait=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
"""


def is_installed():
    """Whether all of it is there, and we may start daemons with our own key."""
    return os.geteuid() == 0 and all(shutil.which(n, path=os.environ["PATH"] + ":" + SBIN) for n in NEEDED)


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class OneNodeSlurm:
    def __init__(self, folder):
        self.folder = Path(folder)
        self.daemons = []
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"),
                                PATH=os.environ["PATH"] + ":" + SBIN)

    def __enter__(self):
        try:
            self._start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *trouble):
        self.stop()

    def _daemon(self, *words):
        log = open(self.folder / (words[0] + ".out"), "ab")  # noqa: SIM115
        # They end with us, even if the test is killed.
        words = ("setpriv", "--pdeathsig", "TERM", *words)
        self.daemons.append(subprocess.Popen(words, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                                             stdout=log, stderr=log, start_new_session=True))
        log.close()

    def _start(self):
        # Munge refuses a socket in a folder that others may write, and a path to it that they may change.
        self.folder.mkdir(mode=0o755)
        for name in ("state", "spool"):
            (self.folder / name).mkdir(mode=0o755)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        host = socket.gethostname().split(".")[0]
        (self.folder / "slurm.conf").write_text(CONF.format(
            host=host, port=free_port(), other_port=free_port(), folder=self.folder,
            user=pwd.getpwuid(os.geteuid()).pw_name, cpus=os.cpu_count()))
        self._daemon("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                     f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log",
                     f"--seed-file={self.folder}/munged.seed")
        self._wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
        self._daemon("slurmctld", "-D", "-i")
        self._daemon("slurmd", "-D", "-N", host)
        self._wait_for(lambda: "idle" in self.say("sinfo", "-h", "-o", "%T").stdout, "slurmd")

    def _wait_for(self, there, what, seconds=60):
        end = time.monotonic() + seconds
        while not there():
            if time.monotonic() > end or any(d.poll() is not None for d in self.daemons):
                logs = "\n".join(f"{f.name}:\n{f.read_text(errors='replace')[-2000:]}"
                                 for f in self.folder.glob("*.*") if f.suffix in (".log", ".out"))
                raise RuntimeError(f"{what} does not come up\n{logs}")
            time.sleep(0.05)

    def say(self, *words, cwd=None, timeout=900):
        return subprocess.run([str(w) for w in words], env=self.environment, cwd=cwd, text=True, capture_output=True,
                              timeout=timeout, check=False)

    def submit(self, script, *options, cwd):
        """The number of a job."""
        done = self.say("sbatch", "--parsable", *options, script, cwd=cwd)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        return int(done.stdout.split(";")[0])

    def wait_for(self, job, seconds=900):
        """Until no task of it is left in the queue."""
        end = time.monotonic() + seconds
        while self.say("squeue", "-h", "-j", job, "-t", "PD,R,CG,CF,S,RQ").stdout.strip():
            if time.monotonic() > end:
                raise RuntimeError(f"job {job} does not end: " + self.say("squeue").stdout)
            time.sleep(0.3)  # asking takes as much of the machine as a small point does

    def exit_code(self, job):
        """Of a job that has ended, as 'code:signal'."""
        text = self.say("scontrol", "-o", "show", "job", job).stdout
        return [word.removeprefix("ExitCode=") for word in text.split() if word.startswith("ExitCode=")]

    def stop(self):
        if self.daemons:
            self.say("scancel", "--user", str(os.geteuid()), timeout=20)
        for daemon in reversed(self.daemons):
            if daemon.poll() is None:
                daemon.send_signal(signal.SIGTERM)
        for daemon in self.daemons:
            try:
                daemon.wait(timeout=15)
            except subprocess.TimeoutExpired:
                os.killpg(daemon.pid, signal.SIGKILL)
                daemon.wait()
        # Job steps are children of slurmstepd, in sessions of their own.
        for entry in Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    variables = (entry / "environ").read_bytes()
                except OSError:
                    continue
                if f"SLURM_CONF={self.folder}/slurm.conf".encode() in variables.split(b"\0") \
                        and int(entry.name) != os.getpid():
                    try:
                        os.kill(int(entry.name), signal.SIGKILL)
                    except OSError:
                        pass
