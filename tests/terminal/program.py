# SPDX-License-Identifier: GPL-3.0-or-later
"""The program under test, and decks to give it. Each test file is called with the program's path."""

import os
import pty
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
PROGRAM = str(Path(sys.argv.pop(1)).resolve())
# tests/run sets it for that preset: all takes ten times as long, and no limit of memory binds.
SANITIZED = "ASAN_OPTIONS" in os.environ
# Seconds by the clock until a run counts as hung: decks of full size take minutes, more on a busy machine.
PATIENCE = 1800 if os.environ.get("SPRICKA_FULL") else 120

# A plate under tension: solved in no time. What tests add stands before $END.
PLATE = """$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Plate'
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=5 NX=4 NY=2
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=BODY MATERIAL=STEEL STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  XMIN
$LOAD CASE=PULL TYPE=TRACTION
  XMAX  100  0
$STEP NAME=LOAD
  LOAD PULL 1
{more}$END
"""

# Three lengths of an edge crack.
CRACKED = PLATE.replace("XMIN", "YMIN").replace("XMAX  100  0", "YMAX  0  100").format(
    more="""$CRACK NAME=C ANGLE=0 A0=1
  0  2.5
$GROW LAW=INCREMENT KMAX=LOAD
  1  1.5  2
"""
)


def plate(more=""):
    return PLATE.format(more=more)


def environment(**changes):
    """The environment of the tests, with colour allowed unless a change says otherwise."""
    result = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "COLUMNS")}
    result["TERM"] = "xterm"
    result.update(changes)
    return result


def content_without_cost(file):
    """The bytes of a file of a run folder, of the report without the line that tells times and memory."""
    return re.sub(rb"<dt>Cost</dt><dd>.*?</dd>", b"", file.read_bytes())


class ProgramTest(unittest.TestCase):
    """Runs the program in a folder of its own."""

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def deck(self, text, name="test.deck"):
        path = self.folder / name
        path.write_bytes(text.encode("utf-8"))
        return path

    def run_program(self, *arguments, stdin=None, **env):
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            input=stdin,
            env=environment(**env),
            text=True,
            capture_output=True,
            timeout=PATIENCE,
            check=False,
        )

    def expect(self, code, *arguments, **more):
        result = self.run_program(*arguments, **more)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def on_terminal(self, *arguments, **env):
        """What the program writes to a terminal as its stderr."""
        ours, theirs = pty.openpty()
        child = subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            env=environment(**env),
            stdout=subprocess.DEVNULL,
            stderr=theirs,
        )
        os.close(theirs)
        parts = []
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            parts.append(part)
        os.close(ours)
        child.wait(timeout=PATIENCE)
        return b"".join(parts).decode("utf-8").replace("\r\n", "\n")


def main():
    unittest.main(argv=[sys.argv[0], "-v"] + sys.argv[1:])
