# SPDX-License-Identifier: GPL-3.0-or-later
"""Cracks in solids: what must not matter to K along a front (threads, which side has the pressures, units, place),
and K from the interaction integrals against G from the solution alone, at every point."""

import csv
import math

from program import TOP, ProgramTest, main


def corner(scale=1.0, shift=0.0, ratio=2.0):
    """A corner crack in a block under tension and shear; x -> scale * (x + shift)."""
    at = lambda x: f"{scale * x:.17g}"  # noqa: E731
    text = "$DECK VERSION=1 LENGTH=MM FORCE=N\n$NET NAME=B\n"
    text += f"  $MESH SHAPE=BLOCK TYPE=TET10 X0={at(shift)} Y0={at(shift)} Z0={at(shift)} LX={at(4)} LY={at(4)} LZ={at(8)}"
    text += " NX=3 NY=3 NZ=5\n$ENDNET\n$MATERIAL NAME=M E=1000 NU=0.3\n$PROPERTY ESET=B.BODY MATERIAL=M STATE=SOLID\n"
    text += "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  B.ZMIN\n"
    text += f"$CRACK NAME=C NET=B A={at(1)} C={at(1 / ratio)} X0={at(shift)} Y0={at(shift)} Z0={at(shift + 4)} NORMAL=Z\n"
    text += f"$LOAD CASE=L TYPE=TRACTION\n  B.ZMAX 0.3 0.2 1\n$STEP NAME=S\n  LOAD L 1\n$END\n"
    return text


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
        # Moved nodes are rounded elsewhere: another choice of elements, as good.
        for change, allowed in (({"scale": 1024.0}, 1e-6), ({"scale": 1e-3}, 1e-6), ({"shift": 16.0}, 1e-3)):
            other = self.points(self.run_deck(corner(**change)))
            root = math.sqrt(change.get("scale", 1.0))
            self.assertEqual(len(one), len(other))
            for a, b in zip(one, other):
                for key in ("K1", "K2", "K3"):
                    self.assertLess(abs(float(b[key]) / root - float(a[key])), allowed * float(one[1]["K1"]), (change, key))

    # A slender ellipse: its curvature changes most between the ends of its axes, where edges of the mesh pass it.
    def test_K_and_G_agree(self):
        for ratio in (0.4, 2.0):
            for row in self.points(self.run_deck(corner(ratio=ratio))):
                if row["at_surface"] == "0":
                    self.assertLess(abs(float(row["G_from_K"]) / float(row["G"]) - 1), 0.03, (ratio, row["phi"]))


if __name__ == "__main__":
    main()
