# SPDX-License-Identifier: GPL-3.0-or-later
"""The process that meshes: it comes when needed and goes with the program. usage: test_process.py
PROGRAM"""

import os
import signal
import subprocess
import time
from pathlib import Path

from meshes import MeshTest
from program import PROGRAM, main, plate

SLOW = "For i In {0:1e12}\n a = i;\nEndFor\n"


def children(pid):
    """Processes whose parent is this one, by their names."""
    found = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            text = (folder / "stat").read_text()
        except OSError:
            continue
        name, rest = text[text.index("(") + 1 : text.rindex(")")], text[text.rindex(")") + 2 :]
        if int(rest.split()[1]) == pid:
            found[int(folder.name)] = name
    return found


class Process(MeshTest):
    def start(self, deck, *options):
        child = subprocess.Popen(
            [PROGRAM, "check", str(deck), *options],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.stderr.close)
        return child

    def mesher_of(self, child):
        for _ in range(400):
            for pid, name in children(child.pid).items():
                if name == "spricka-mesher":
                    return pid
            time.sleep(0.02)
        self.fail("no mesher was started")

    def expect_gone(self, pid):
        for _ in range(300):
            state = Path(f"/proc/{pid}/stat")
            try:
                if state.read_text().rpartition(")")[2].split()[0] == "Z":
                    return  # it has ended; whoever took it over has not looked yet
            except OSError:
                return
            time.sleep(0.02)
        self.fail("the mesher is still there")

    def test_a_deck_without_gmsh_starts_none(self):
        maps = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, check=True).stdout
        self.assertNotIn("gmsh", maps)
        self.expect(0, "check", self.deck(plate()), PATH="/nonexistent")

    def test_it_goes_when_the_program_is_killed(self):
        child = self.start(self.square(SLOW), "--mesh-time", "400")
        mesher = self.mesher_of(child)
        child.kill()
        child.wait()
        self.expect_gone(mesher)

    def test_interrupt_of_the_terminal(self):
        child = self.start(self.square(SLOW), "--mesh-time", "400")
        mesher = self.mesher_of(child)
        os.killpg(child.pid, signal.SIGINT)
        self.assertNotEqual(child.wait(timeout=30), 0)
        self.expect_gone(mesher)

    def test_a_mesher_that_is_killed_is_replaced_once(self):
        child = self.start(self.square(SLOW), "--mesh-time", "400")
        first = self.mesher_of(child)
        os.kill(first, signal.SIGKILL)
        self.expect_gone(first)
        second = self.mesher_of(child)
        os.kill(second, signal.SIGKILL)
        _, words = child.communicate(timeout=30)
        self.assertEqual(child.returncode, 3)
        self.assertIn("gmsh crashed (Killed)", words)

    def test_it_sees_nothing_of_the_environment(self):
        child = self.start(self.square(SLOW), "--mesh-time", "400")
        mesher = self.mesher_of(child)
        for _ in range(400):  # it is being loaded
            status = Path(f"/proc/{mesher}/status").read_text()
            if "Seccomp:\t2" in status:
                break
            time.sleep(0.02)
        names = {v.split(b"=")[0] for v in Path(f"/proc/{mesher}/environ").read_bytes().split(b"\0")}
        self.assertFalse(names & {b"HOME", b"PATH", b"USER"})
        self.assertIn("Seccomp:\t2", status)
        self.assertIn("NoNewPrivs:\t1", status)


main()
