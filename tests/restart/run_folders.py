# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks that keep their state, and run folders compared to the byte."""

import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "terminal"))

from program import CRACKED, PROGRAM, TOP, ProgramTest, content_without_cost, environment, main  # noqa: E402,F401

KEEP = "$RESTART WRITE='state.rst'\n"

# A corner crack in a plate of solids goes through the far face: as the front takes its shape, and held
# to an ellipse.
CORNER = """$DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=TET10 X0=0 Y0=0 Z0=-8 LX=8 LY=2 LZ=16 NX=4 NY=1 NZ=8
$MATERIAL NAME=M E=70000 NU=0.3
$PROPERTY ESET=BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  ZMIN
$CRACK NAME=C1 A={a} C={a} X0=0 Y0=0 Z0=0 NORMAL=Z
$LOAD CASE=PULL TYPE=TRACTION
  ZMAX  0 0 100
$STEP NAME=FULL
  LOAD PULL 1
$STEP NAME=ZERO
  LOAD PULL 0
$GROW LAW=PARIS SHAPE={shape} KMAX=FULL KMIN=ZERO C=1e-12 M=3 KUNIT='MPa*mm^0.5' AUNIT='mm' CYCLES={cycles}
$END
"""


def corner(shape):
    """It goes through the far face, 2 away: some thirty fronts with SPRICKA_FULL, else ten."""
    a, cycles = (1.5, 60000) if os.environ.get("SPRICKA_FULL") else (1.85, 15000)
    return CORNER.format(shape=shape, a=a, cycles=cycles)


def press_fit(contact, interference, rings, sectors, more=""):
    """A pin pressed into a ring, elements along the ring's radius and round it."""
    return f"""$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Press fit'
$NET NAME=RING
  $MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR={rings} NT={sectors}
$ENDNET
$NET NAME=PIN
  $MESH SHAPE=RING TYPE=QUAMC8 RI=3 RO=10 NR=3 NT={sectors}
$ENDNET
$MATERIAL NAME=STEEL E=210[GPa] NU=0.3
$PROPERTY ESET=RING.BODY MATERIAL=STEEL STATE=STRESS
$PROPERTY ESET=PIN.BODY MATERIAL=STEEL STATE=STRESS
$CONTACT NAME={contact} SLAVE=PIN.OUTER MASTER=RING.INNER INTERFERENCE={interference}
$FREEDOM CLASS=SUPPRESSED DOF=XY
  PIN.INNER
$STEP NAME=PRESS
  FIT {contact} 1
{more}$END
"""


def keeping(text=CRACKED, card=KEEP):
    """A deck with a card more, before its end."""
    return text.replace("$END\n", card + "$END\n")


def contents(folder):
    """Every file of a run folder by name, but for the listing, which tells times."""
    return {
        str(f.relative_to(folder)): content_without_cost(f)
        for f in sorted(folder.rglob("*"))
        if f.is_file() and f.name != "listing.txt"
    }


class RestartTest(ProgramTest):
    def same_folders(self, one, other):
        a, b = contents(one), contents(other)
        self.assertEqual(sorted(a), sorted(b))
        self.assertGreater(len(a), 4)
        for name, data in a.items():
            self.assertEqual(data, b[name], f"{name} differs")

    def start(self, *arguments, **more):
        """Starts the program and does not wait."""
        return subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            env=environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            **more,
        )

    def increments(self, name="state.rst"):
        """Files of increments that are kept."""
        return sorted(f.name for f in (self.folder / (name + ".d")).glob("*.h5"))
