# SPDX-License-Identifier: GPL-3.0-or-later
"""An .inp with contact, friction, a tie, supports, loads and steps becomes a deck, which runs to what statics tells."""

from program import ProgramTest, main


def block(first_node, first_element, corner, size, n):
    """Nodes and C3D8 of a box with n elements along each edge: lines of text, and the elements of its lower and
    upper layer."""
    nodes, elements = [], []
    at = lambda i, j, k: first_node + i + (n + 1) * (j + (n + 1) * k)
    for k in range(n + 1):
        for j in range(n + 1):
            for i in range(n + 1):
                x = [c + s * m / n for c, s, m in zip(corner, size, (i, j, k))]
                nodes.append(f"{at(i, j, k)}, {x[0]}, {x[1]}, {x[2]}")
    for k in range(n):
        for j in range(n):
            for i in range(n):
                lower = [at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)]
                upper = [m + (n + 1) ** 2 for m in lower]
                elements.append(f"{first_element + len(elements)}, " + ", ".join(map(str, lower + upper)))
    layer = n * n
    low = range(first_element, first_element + layer)
    high = range(first_element + n**3 - layer, first_element + n**3)
    return nodes, elements, low, high


def joint():
    """A foot that is held, a block that stands on it with friction, a cap that is tied to the block."""
    text, surfaces = "*HEADING\n Block on a foot, it's held by friction\n", ""
    parts = [("Foot-1", 0, 0.0, 2), ("Block-1", 100, 10.0, 3), ("Cap-1", 300, 20.0, 2)]
    for name, number, z, n in parts:
        nodes, elements, low, high = block(number + 1, number + 1, (0.0, 0.0, z), (10.0, 10.0, 10.0), n)
        text += f"*NODE, NSET={name}\n" + "\n".join(nodes) + "\n"
        text += f"*ELEMENT, TYPE=C3D8, ELSET={name}\n" + "\n".join(elements) + "\n"
        for where, side, of in (("LOW", 1, low), ("HIGH", 2, high)):
            surfaces += f"*SURFACE, NAME={name}_{where}\n" + "".join(f"{e}, S{side}\n" for e in of)
    return text + surfaces + """*NSET, NSET=HELD, GENERATE
 1, 9
*MATERIAL, NAME=SOFT
*ELASTIC
 1000., 0., 293.
*PLASTIC
 100., 0.
{sections}*SURFACE INTERACTION, NAME=RUB
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
 1e6, 0.1
*FRICTION
 {friction}, 1e5
*CONTACT PAIR, INTERACTION=RUB, TYPE=SURFACE TO SURFACE, ADJUST=0.01
 Block-1_LOW, Foot-1_HIGH
*TIE, NAME=GLUE
 Cap-1_LOW, Block-1_HIGH
*BOUNDARY
 HELD, 1, 3
*STEP
*STATIC
*DLOAD
 Cap-1, P2, 0.
*DSLOAD
 Cap-1_HIGH, P, 10.
*END STEP
*STEP
*STATIC
*CLOAD
 319, 1, 20.
 320, 1, 20.
 321, 1, 20.
 322, 1, 40.
*END STEP
*STEP
*FREQUENCY
 3
*END STEP
"""


SECTIONS = "".join(f"*SOLID SECTION, ELSET={n}, MATERIAL=SOFT\n" for n in ("Foot-1", "Block-1", "Cap-1"))
CHECKS = """$CHECK
  SUM(CONTACT_1,STEP_1,Z) = 1000 REL 1e-6 SOURCE 'pressure times area'
  S.ZZ.MIN(CAP_1.CAP_1,STEP_1) = -10 REL 1e-6 SOURCE 'uniform pressure passes contact and tie'
  S.ZZ.MAX(FOOT_1.FOOT_1,STEP_1) = -10 REL 1e-6 SOURCE 'uniform pressure passes contact and tie'
  U.Z.MIN(CAP_1.CAP_1_HIGH,STEP_1) = (-10*30/1000) REL 1e-6 SOURCE 'p H / E'
  SUM(CONTACT_1,STEP_2,X) = -100 REL 1e-6 SOURCE 'friction holds the sum of the forces'
  SUM(GLUE,STEP_2,X) = -100 REL 1e-6 SOURCE 'the tie passes them on'
$END
"""


class InpDecks(ProgramTest):
    def convert(self, friction):
        text = joint().format(friction=friction, sections=SECTIONS)
        (self.folder / "joint.inp").write_text(text, encoding="utf-8")
        words = self.expect(0, "convert", "--replace", "joint.inp", "joint.deck").stderr
        return words, (self.folder / "joint.deck").read_text(encoding="utf-8")

    def test_contact_friction_and_tie_run_as_the_file_says(self):
        words, deck = self.convert(0.3)
        self.assertIn("W468", words)  # *PLASTIC
        self.assertNotIn("*TIE", words)
        self.assertIn("the step of *FREQUENCY is left out", words)
        self.assertIn("by MOUNT in a $STEP", words)
        self.assertIn("! - units are guessed as mm and N", deck)
        for card in (
            "$NET NAME=BLOCK_1\n  $IMPORT FILE='joint.inp' FORMAT=INP SKIP=ALL ESET='BLOCK_1'\n",
            "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n  FOOT_1.HELD\n",
            "SLAVE=BLOCK_1.BLOCK_1_LOW MASTER=FOOT_1.FOOT_1_HIGH GAP=0 MU=0.3\n",
            "$CONTACT NAME=GLUE SLAVE=CAP_1.CAP_1_LOW MASTER=BLOCK_1.BLOCK_1_HIGH TYPE=BONDED GAP=0\n",
        ):
            self.assertIn(card, deck)
        errors = self.expect(0, "run", self.deck(deck.replace("$END\n", CHECKS), "checked.deck")).stderr
        self.assertEqual(errors.count("W467"), 1)  # the file is imported thrice

    def test_friction_that_is_too_small_does_not_hold(self):
        _, deck = self.convert(0.05)
        self.assertIn("slides", self.expect(4, "run", self.deck(deck, "loose.deck")).stderr)

    def test_a_deck_is_made_of_an_inp_only(self):
        self.deck("$DECK VERSION=1 LENGTH=MM FORCE=N\n$END\n")
        self.assertIn(".inp", self.expect(2, "convert", "test.deck", "other.deck").stderr)


if __name__ == "__main__":
    main()
