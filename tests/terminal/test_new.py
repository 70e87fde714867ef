# SPDX-License-Identifier: GPL-3.0-or-later
"""`spricka new`: decks from the dimensions of a drawing, against references, and what it refuses and in which words.
SPRICKA_FULL: all templates are solved, those of solids as well."""

import csv
import math
import os

from program import ProgramTest, main

FULL = bool(os.environ.get("SPRICKA_FULL"))
SOLIDS = ["bushed-lug-3d", "corner-crack-at-hole", "pin-joint", "surface-crack"]
PLANE = ["bushed-lug", "hole-in-plate", "lug", "press-fit-hub"]

# K1 under LOAD (PRESS of the hub) from meshes with fine=4; of solids at angles of the front, from fine=2 with $TIPNET
# FINER=1.6, hosts of hexahedra and of tetrahedra, which agree to 0.07 %.
REFERENCE = {
    "bushed-lug": 674.43,
    "hole-in-plate": 479.217,
    "lug": 762.81,
    "press-fit-hub": 472.544,
    "bushed-lug-3d": {9.0: 431.27, 22.5: 419.29, 45.0: 425.16, 67.5: 450.34, 81.0: 471.14},
    "corner-crack-at-hole": {9.0: 318.43, 22.5: 314.45, 45.0: 328.64, 67.5: 366.15, 81.0: 405.39},
    "pin-joint": {9.0: 234.18, 22.5: 236.10, 45.0: 255.74, 67.5: 294.08, 81.0: 329.72},
    "surface-crack": {25.4: 186.62, 53.5: 213.15, 90.0: 228.66, 126.5: 213.14, 154.6: 186.61},
}

# What contradicts itself, and the words of the drawing it is refused in.
REFUSED = [
    ("lug", ["pin=41"], "the pin is larger than the bore: pin = 41, d = 40"),
    ("lug", ["e=15"], "the bore cuts the edge"),
    ("lug", ["e=-5"], "the bore cuts the edge"),
    ("lug", ["a=30"], "the crack is longer than the ligament"),
    ("lug", ["w=38"], "the lug is no wider than its bore"),
    ("lug", ["t=0"], "a size of the drawing is zero or negative"),
    ("bushed-lug", ["db=42"], "the bush has no wall"),
    ("bushed-lug", ["pin=33"], "the pin is larger than the bush"),
    ("bushed-lug-3d", ["a=12"], "the corner crack is deeper than the lug is thick"),
    ("bushed-lug-3d", ["fit=2"], "the interference is more than two per cent of the diameter"),
    ("hole-in-plate", ["b=4"], "the hole cuts the left edge of the plate"),
    ("hole-in-plate", ["a=50"], "the crack is longer than the ligament"),
    ("corner-crack-at-hole", ["a=6"], "deeper than the plate is thick"),
    ("surface-crack", ["c=31"], "the crack is longer than the plate is wide"),
    ("pin-joint", ["pin=20.1"], "the pin is larger than the bores"),
    ("pin-joint", ["e=9"], "the bore cuts the end of the plate"),
    ("press-fit-hub", ["fit=-0.01"], "it is no press fit"),
    ("press-fit-hub", ["dh=60"], "the hub has no wall"),
]


class New(ProgramTest):
    def new(self, code, *arguments, **more):
        return self.expect(code, "new", *arguments, **more)

    def front(self, folder, step):
        """{phi: (K1, bar)} of a front, {None: ..} of a tip."""
        with open(self.folder / folder / "k.csv", encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(line for line in file if not line.startswith("#"))
                    if row["step"] == step and row["K1_bar"]]
        return {float(row["phi"]) if row.get("phi") else None: (float(row["K1"]), float(row["K1_bar"]))
                for row in rows}

    def at(self, points, phi):
        """K1 and bar at an angle, linear between points; angles count on across 180 degrees."""
        near = sorted(points, key=lambda p: abs((p - phi + 180.0) % 360.0 - 180.0))
        off = [(p - phi + 180.0) % 360.0 - 180.0 for p in near]
        first = 0
        other = next((i for i in range(1, len(near)) if off[i] * off[0] <= 0.0), 1)
        part = 0.0 if off[first] == off[other] else off[first] / (off[first] - off[other])
        return [a + part * (b - a) for a, b in zip(points[near[first]], points[near[other]])]

    def solve(self, name):
        self.new(0, name, "--defaults")
        done = self.expect(0, "run", f"{name}.deck")
        self.assertNotIn("warning", done.stderr)
        points = self.front(f"{name}.run", "PRESS" if name == "press-fit-hub" else "LOAD")
        reference = REFERENCE[name]
        for phi, K in (reference.items() if isinstance(reference, dict) else [(None, reference)]):
            own, bar = points[None] if phi is None else self.at(points, phi)
            with self.subTest(name, phi=phi, K=own, bar=bar):
                self.assertLess(abs(own / K - 1.0), 0.01)
                self.assertLess(abs(own - K), bar + 2e-3 * K)  # that reference and reading have

    def test_templates_meet_their_references(self):
        for name in PLANE + (SOLIDS if FULL else SOLIDS[1:2]):
            self.solve(name)

    def test_every_template_is_listed_and_checks_in_both_units(self):
        listed = self.new(0).stdout
        for name in PLANE + SOLIDS:
            self.assertIn(f"  {name} ", listed)
            for units in ("mm", "in"):
                written = self.new(0, name, f"{name}_{units}", "--units", units, "--defaults").stdout
                self.assertIn(f"Run it with: spricka run {name}_{units}.deck", written)
                text = (self.folder / f"{name}_{units}.deck").read_text(encoding="utf-8")
                self.assertIn(f"LENGTH={units} FORCE={'N' if units == 'mm' else 'lbf'}", text)
                self.assertNotIn("|", text.split("$PARAMETER")[1].split("$")[0])
        self.expect(0, "check", "lug_in.deck")

    def test_a_small_crack_at_a_hole_in_a_wide_plate_is_bowies(self):
        self.new(0, "hole-in-plate", "-D", "w=1000", "-D", "h=1000", "-D", "a=5", "--defaults")
        self.expect(0, "run", "hole-in-plate.deck")
        K, _ = self.front("hole-in-plate.run", "LOAD")[None]
        self.assertAlmostEqual(K / (1.306097 * 100.0 * math.sqrt(math.pi * 5.0)), 1.0, delta=1e-3)

    def test_the_pressure_of_a_hub_is_lames(self):
        self.new(0, "press-fit-hub", "-D", "a=0.2", "-D", "dh=120", "-D", "d=60", "-D", "fit=0.06", "--defaults")
        deck = self.folder / "press-fit-hub.deck"
        p = 205e3 / (1.0 - 0.09) * 0.06 / 60.0 * (120.0 ** 2 - 60.0 ** 2) / (2.0 * 120.0 ** 2)
        check = f"$CHECK\n  CPRESS.MEAN(FIT,PRESS) = {p} REL 2e-3 SOURCE 'Lame'\n$END\n"
        deck.write_text(deck.read_text(encoding="utf-8").replace("$END\n", check), encoding="utf-8")
        self.expect(0, "run", "press-fit-hub.deck")

    def test_contradictions_are_refused_in_the_words_of_the_drawing(self):
        for name, defines, words in REFUSED:
            with self.subTest(name, defines=defines):
                arguments = [word for define in defines for word in ("-D", define)]
                result = self.new(3, name, "refused", "--defaults", *arguments)
                self.assertIn("E123", result.stderr)
                self.assertIn(words, result.stderr)
                self.assertFalse((self.folder / "refused.deck").exists())
        # The deck itself refuses them as well.
        self.new(0, "lug", "--defaults")
        result = self.expect(3, "check", "lug.deck", "-D", "pin=41")
        self.assertIn("the pin is larger than the bore", result.stderr)

    def test_answers(self):
        # A slip is asked again; so is what contradicts another answer.
        answers = "36\n\n80\n1+\n\n\n\n\n\n\n200\n\n\n\n" + "\n\n\n\n\n\n\n\n\n5\n\n\n\n"
        result = self.new(0, "lug", "mine.deck", "--ask", stdin=answers)
        self.assertIn("diameter of the bore, d [40 mm]", result.stdout)
        self.assertIn("E101", result.stderr)
        self.assertIn("the crack is longer than the ligament between bore and edge", result.stderr)
        text = (self.folder / "mine.deck").read_text(encoding="utf-8")
        self.assertRegex(text, r"d +\= 36 +! diameter of the bore \[mm\]")
        self.assertRegex(text, r"a +\= 5 ")
        self.expect(0, "run", "mine.deck")
        # Answers that end early leave nothing.
        result = self.new(2, "lug", "other", "--ask", stdin="36\n")
        self.assertIn("nothing is written", result.stderr)
        self.assertFalse((self.folder / "other.deck").exists())

    def test_what_is_mistyped(self):
        self.assertIn("did you mean 'bushed-lug'?", self.new(2, "bushed-lag").stderr)
        self.assertIn("it has d, pin, w", self.new(2, "lug", "-D", "bore=3").stderr)
        self.new(0, "lug", "--defaults")
        self.assertIn("E464", self.new(7, "lug", "--defaults").stderr)
        self.new(0, "lug", "--defaults", "--replace")


if __name__ == "__main__":
    main()
