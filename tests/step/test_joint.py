# SPDX-License-Identifier: GPL-3.0-or-later
"""A lug with bush and pin from a STEP file: solids, faces, meshes, and K of a corner flaw beside that of the same parts
drawn by scripts. usage: test_joint.py PROGRAM JOINT.step; SPRICKA_FULL takes smaller elements."""

import csv
import json
import math
import os
import shutil

from joint import JOINT, REST, deck_from_step, write_scripts
from program import ProgramTest, main

SIZE = 4.5 if os.environ.get("SPRICKA_FULL") else 9.0


class Joint(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copy(JOINT, self.folder / "joint.step")

    def checked(self, deck, *options):
        return json.loads(self.expect(0, "check", deck, "--json", *options).stdout)

    def largest_K(self, folder):
        with open(self.folder / folder / "k.csv", encoding="utf-8") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            return max(float(row["K1"]) for row in rows if row["step"] == "LOAD")

    def test_K_is_that_of_the_parts_from_scripts(self):
        self.expect(0, "run", self.deck(deck_from_step(SIZE)), "--out", "step", "--quiet")
        scripts = self.deck(write_scripts(self.folder, SIZE), "scripts.deck")
        self.expect(0, "run", scripts, "--out", "scripts", "--quiet")
        from_step, from_scripts = self.largest_K("step"), self.largest_K("scripts")
        print(f"K1 {from_step:.2f} from STEP, {from_scripts:.2f} from scripts")
        self.assertAlmostEqual(from_step / from_scripts, 1.0, delta=0.02)

    def test_solids_and_faces_are_told(self):
        found = self.checked(self.deck(deck_from_step(SIZE)))
        self.assertEqual([s["sets"] for s in found["solids"]], [["LUG.BODY"], ["BUSH.BODY"], ["PIN.BODY"]])
        faces = {name: face for face in found["faces"] for name in face["sets"]}
        self.assertEqual(faces["LUG.BORE"]["kind"], "cylinder, bore")
        self.assertEqual(faces["BUSH.OUTER"]["kind"], "cylinder")
        self.assertAlmostEqual(faces["BUSH.INNER"]["radius"], 12.0, places=6)
        self.assertEqual([round(x, 9) for x in faces["LUG.END"]["direction"]], [-1, 0, 0])
        self.assertAlmostEqual(faces["LUG.END"]["area"], 64 * 12, places=6)
        self.assertAlmostEqual(faces["PIN.TOP"]["centre"][2], 16.0, places=6)
        self.assertEqual(found["inside_out"], 0)

    def test_nodes_lie_on_the_round_face(self):
        deck = f"""$DECK VERSION=1 LENGTH=MM FORCE=N
$IMPORT FILE='joint.step' SOLID=LUG SIZE={SIZE}
$MATERIAL NAME=ALUMINIUM E=71[GPa] NU=0.33
$PROPERTY ESET=BODY MATERIAL=ALUMINIUM STATE=SOLID
$END
"""
        self.expect(0, "convert", self.deck(deck), "lug.msh")
        nodes = (self.folder / "lug.msh").read_text().split("$Nodes\n")[1].split("$EndNodes")[0]
        places = [[float(word) for word in line.split()] for line in nodes.splitlines() if len(line.split()) == 3]
        radii = [math.hypot(x, y) for x, y, z in places]
        self.assertGreater(len(radii), 100)
        self.assertAlmostEqual(min(radii), 15.0, places=6)  # the middle of a straight edge would lie inside

    def test_a_deck_that_is_refused_has_the_tables(self):
        deck = "$DECK VERSION=1 LENGTH=MM FORCE=N\n$IMPORT FILE='joint.step'\n$END\n"
        told = self.expect(3, "check", self.deck(deck)).stdout
        for words in ("Solids of STEP files", "LUG_F7   cylinder, bore      15", "PIN_F3"):
            self.assertIn(words, told)

    def test_lengths_are_those_of_the_deck(self):
        deck = "$DECK VERSION=1 LENGTH=IN FORCE=LBF\n$IMPORT FILE='joint.step' SIZE=0.4 SOLID=V3\n$END\n"
        told = self.expect(3, "check", self.deck(deck)).stdout
        self.assertIn("0.472441", told)  # 12 mm
        deck = deck.replace("LENGTH=IN FORCE=LBF", "LENGTH=MM FORCE=N").replace("SIZE=0.4", "SCALE=2 SIZE=10")
        told = self.expect(3, "check", self.deck(deck)).stdout
        self.assertIn("-24 -24 -8", told)

    def test_finer_makes_all_elements_smaller(self):
        def elements(text):
            return [net["elements"] for net in self.checked(self.deck(text))["nets"]]

        coarse = elements(deck_from_step(SIZE))
        fine = elements(deck_from_step(SIZE).replace("SOLID=", "FINER=1.5 SOLID="))
        for few, many in zip(coarse, fine):
            self.assertTrue(1.5 < many / few < 4.5, (few, many))

    def test_lengths_of_other_units_are_converted(self):
        text = (self.folder / "joint.step").read_text().replace(".MILLI.,.METRE.", ".CENTI.,.METRE.")
        (self.folder / "joint.step").write_text(text)
        deck = "$DECK VERSION=1 LENGTH=M FORCE=N\n$IMPORT FILE='joint.step'\n$END\n"
        self.assertIn("cylinder, bore    0.15", self.expect(3, "check", self.deck(deck)).stdout)

    def test_solids_that_touch_are_bodies_of_their_own(self):
        rest = REST.replace("LUG.BODY", "LUG").replace("BUSH.BODY", "BUSH").replace("PIN.BODY", "PIN")
        for old, new in [
            ("LUG.END", "LUG_F1"),
            ("PIN.TOP PIN.FOOT", "PIN_F2 PIN_F3"),
            ("BUSH.OUTER MASTER=LUG.BORE", "BUSH_F1 MASTER=BORE"),
            ("PIN.OUTER MASTER=BUSH.INNER", "PIN_F1 MASTER=BUSH_F4"),
        ]:
            rest = rest.replace(old, new)
        rest = rest[: rest.index("$CRACK")] + "$END\n"
        head = "$DECK VERSION=1 LENGTH=MM FORCE=N\n$IMPORT FILE='joint.step' SIZE=9\n  LUG_F7 = BORE 4\n"
        self.assertEqual(len(self.checked(self.deck(head + rest))["bodies"]), 3)


main()
