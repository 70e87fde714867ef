# SPDX-License-Identifier: GPL-3.0-or-later
"""Cracks in solids: what must not matter to K along a front (threads, which side has the pressures, units, place),
and K from the interaction integrals against G from the solution alone, at every point.
SPRICKA_FULL: more units and places, solids of hexahedra through nodes."""

import csv
import math
import os

from program import TOP, ProgramTest, main


def corner(scale=1.0, shift=0.0, ratio=2.0, kind="TET10", across=3, layers=5, height=4.0):
    """A corner crack in a block under tension and shear; x -> scale * (x + shift)."""
    at = lambda x: f"{scale * x:.17g}"  # noqa: E731
    text = "$DECK VERSION=1 LENGTH=MM FORCE=N\n$NET NAME=B\n"
    text += f"  $MESH SHAPE=BLOCK TYPE={kind} X0={at(shift)} Y0={at(shift)} Z0={at(shift)} LX={at(4)} LY={at(4)} LZ={at(8)}"
    text += f" NX={across} NY={across} NZ={layers}\n$ENDNET\n$MATERIAL NAME=M E=1000 NU=0.3\n$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID\n"
    text += "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  B.ZMIN\n"
    text += f"$CRACK NAME=C NET=B A={at(1)} C={at(1 / ratio)} X0={at(shift)} Y0={at(shift)} Z0={at(shift + height)} NORMAL=Z\n"
    text += f"$LOAD CASE=L TYPE=TRACTION\n  B.ZMAX 0.3 0.2 1\n$STEP NAME=S\n  LOAD L 1\n$END\n"
    return text


FULL = bool(os.environ.get("SPRICKA_FULL"))


class Fronts(ProgramTest):
    def run_deck(self, text, *more):
        for name in ("lug_solid.geo", "sleeve_solid.geo", "shaft_solid.geo", "strip_bore_solid.geo", "plug_solid.geo"):
            (self.folder / name).write_text((TOP / "decks" / name).read_text(encoding="utf-8"), encoding="utf-8")
        self.deck(text)
        self.expect(0, "run", "test.deck", "--out", "out", "--quiet", *more)
        return (self.folder / "out" / "k.csv").read_text(encoding="utf-8")

    @staticmethod
    def points(text, step=None):
        rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
        return [row for row in rows if step in (None, row["step"])]

    def test_threads(self):
        text = (TOP / "decks" / "lug_slice_crack_solid.deck").read_text(encoding="utf-8")
        self.assertEqual(self.run_deck(text, "--threads", "1"), self.run_deck(text, "--threads", "2"))

    def test_side_of_the_pressures(self):
        text = (TOP / "decks" / "pin_corner_crack_solid.deck").read_text(encoding="utf-8")
        text = text[: text.index("$CHECK")] + "$END\n"
        one = self.points(self.run_deck(text))
        other = self.points(self.run_deck(text.replace("SLAVE=STRIP.BORE MASTER=PIN.BACK", "SLAVE=PIN.BACK MASTER=STRIP.BORE")))
        for a, b in zip(one, other):
            if abs(float(a["phi"])) < 80 and a["at_surface"] == "0":
                self.assertLess(abs(float(b["K1"]) / float(a["K1"]) - 1), 1.5e-3, (a["step"], a["phi"]))

    def test_units_and_place(self):
        one = self.points(self.run_deck(corner()))
        # A patch is meshed in the crack's own frame, by rounded coordinates of which zeros have no sign.
        allowed = 1e-6
        each = ({"scale": 3.7}, {"shift": 7.3}, {"scale": 1024.0}, {"scale": 1e-3}, {"shift": 16.0})
        for change in each if FULL else ({"scale": 3.7, "shift": 7.3},):
            other = self.points(self.run_deck(corner(**change)))
            root = math.sqrt(change.get("scale", 1.0))
            self.assertEqual(len(one), len(other))
            for a, b in zip(one, other):
                for key in ("K1", "K2", "K3"):
                    self.assertLess(abs(float(b[key]) / root - float(a[key])), allowed * float(one[1]["K1"]), (change, key))

    # Plane, centre and ends of the front in nodes of the host: no other K than a little beside them.
    def test_cracks_through_nodes(self):
        for kind in ("TET10", "HEXEC20") if FULL else ("TET10",):
            at_nodes = [self.points(self.run_deck(corner(ratio=1.0, kind=kind, across=4, layers=8, height=h))) for h in (4.0, 4.01)]
            self.assertEqual(*(len(rows) for rows in at_nodes))
            for a, b in zip(*at_nodes):
                if a["at_surface"] == "0":
                    self.assertLess(abs(float(b["K1"]) / float(a["K1"]) - 1), 3e-3, (kind, a["phi"]))

    # A body held at three nodes bears nothing there: K is the same wherever they are, on edges that the patch takes
    # too. A group that nothing uses may lie as it will.
    def test_supports_on_edges_of_the_patch(self):
        text = corner(ratio=1.0, across=4, layers=8, height=1.1)
        text = text.replace("B.ZMAX 0.3 0.2 1\n", "B.ZMAX 0 0 1\n  B.ZMIN 0 0 -1\n")
        found = []
        for places in (((0, 0, 0), (1, 0, 0), (0, 1, 0)), ((4, 4, 8), (0, 4, 8), (4, 0, 8))):
            cards = "$NSET NAME=IDLE WHERE=(x < 1e-6 and z > 1 - 1e-6)\n"
            for k, (x, y, z) in enumerate(places):
                cards += f"$NSET NAME=P{k} WHERE=(abs(x - {x}) < 1e-6 and abs(y - {y}) < 1e-6 and abs(z - {z}) < 1e-6)\n"
            for k, dof in enumerate(("XYZ", "YZ", "Z")):
                cards += f"$FREEDOM CLASS=SUPPRESSED DOF={dof}\n  P{k}\n"
            found.append(self.points(self.run_deck(text.replace("$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  B.ZMIN\n", cards))))
        self.assertEqual(*(len(rows) for rows in found))
        for a, b in zip(*found):
            if a["at_surface"] == "0":
                self.assertLess(abs(float(b["K1"]) / float(a["K1"]) - 1), 1.5e-3, a["phi"])

    # A crack all round a bore, which is a hole inside the circle that is drawn: K about an axis.
    def test_crack_round_a_bore(self):
        common = "$MATERIAL NAME=M E=1000 NU=0.3\n$LOAD CASE=L TYPE=TRACTION\n  {} {} 1\n$STEP NAME=S\n  LOAD L 1\n"
        axial = "$DECK VERSION=1 LENGTH=MM FORCE=N\n$MESH SHAPE=BLOCK TYPE=QUAMC8 X0=2 Y0=-6 LX=6 LY=12 NX=24 NY=48\n"
        axial += "$PROPERTY ESET=BODY MATERIAL=M STATE=AXI\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  YMIN\n"
        axial += "$CRACK NAME=C\n  2 0.3\n  3.5 0.3\n" + common.format("YMAX", "0") + "$END\n"
        solid = "$DECK VERSION=1 LENGTH=MM FORCE=N\n$PARAMETER\n  R=8\n  ri=2\n  t=6\n  nz=4\n  both=1\n  fine=2\n"
        solid += "$NET NAME=B\n  $IMPORT FILE='sleeve_solid.geo' FORMAT=GEO\n$ENDNET\n$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID\n"
        for name, where in (("FOOT", ""), ("P1", " and abs(x - 8) < 1e-6 and abs(y) < 1e-6"), ("P2", " and abs(x + 8) < 1e-6 and abs(y) < 1e-6")):
            solid += f"$NSET NAME={name} WHERE=(abs(z + 6) < 1e-6{where})\n"
        solid += "$FREEDOM CLASS=SUPPRESSED DOF=Z\n  FOOT\n$FREEDOM CLASS=SUPPRESSED DOF=XY\n  P1\n$FREEDOM CLASS=SUPPRESSED DOF=Y\n  P2\n"
        solid += "$CRACK NAME=C NET=B A=3.5 X0=0 Y0=0 Z0=0.3 NORMAL=Z\n" + common.format("B.ZMAX", "0 0") + "$END\n"
        exact = float(self.points(self.run_deck(axial))[0]["K1"])
        front = self.points(self.run_deck(solid))
        self.assertGreater(len(front), 40)
        for row in front:
            self.assertLess(abs(float(row["K1"]) / exact - 1), 0.006, row["phi"])

    # A slender ellipse: its curvature changes most between the ends of its axes, where edges of the mesh pass it.
    def test_K_and_G_agree(self):
        for ratio in (0.4, 2.0):
            for row in self.points(self.run_deck(corner(ratio=ratio))):
                if row["at_surface"] == "0":
                    self.assertLess(abs(float(row["G_from_K"]) / float(row["G"]) - 1), 0.03, (ratio, row["phi"]))


if __name__ == "__main__":
    main()
