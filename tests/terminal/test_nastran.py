# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks on Nastran bulk data: constant stress in parts of every element, K of a ring with a crack, and files
that are no deck or of another format than a card says."""

import math

from program import ProgramTest, main

SMALL, LARGE, FREE = "small", "large", "free"


def real(value, width=8):
    """A number as Nastran files have it, without the E of its exponent where that saves room."""
    if width == 16:
        return f"{value:.9e}".replace("e", "D")
    text = f"{value:.4f}"
    return text if 1e-3 <= abs(value) < 1e3 or value == 0 else f"{value:.2e}".replace("e", "").replace("+0", "+").replace("-0", "-")


def entry(form, name, *fields):
    """One entry with the lines that continue it; floats are written as Nastran does."""
    width = 16 if form == LARGE else 8
    texts = [real(f, width) if isinstance(f, float) else str(f) for f in fields]
    each = 4 if form == LARGE else 8
    lines = []
    for at in range(0, len(texts), each):
        first = name if at == 0 else "" if form == SMALL else "*" if form == LARGE else "+"
        part = texts[at : at + each]
        if form == FREE:
            lines.append(",".join([first, *part]))
        else:
            star = "*" if form == LARGE and at == 0 else ""
            lines.append(f"{first + star:8}" + "".join(f"{t:>{width}}" for t in part))
    return "\n".join(lines) + "\n"


class Bulk:
    """Bulk data with one number for each point."""

    def __init__(self, form):
        self.form = form
        self.points = {}
        self.text = ""
        self.elements = 0

    def write(self, name, *fields):
        self.text += entry(self.form, name, *fields)

    def node(self, x):
        key = tuple(round(v, 4) for v in x)
        if key not in self.points:
            self.points[key] = len(self.points) + 1
            self.write("GRID", self.points[key], "", *key)
        return self.points[key]

    def element(self, name, part, corners, edges):
        """An element with its corners and the middles of these edges, which count from 1."""
        nodes = [self.node(c) for c in corners]
        nodes += [self.node([(p + q) / 2 for p, q in zip(corners[a - 1], corners[b - 1])]) for a, b in edges]
        self.elements += 1
        self.write(name, self.elements, part, *nodes)


QUAD = [(1, 2), (2, 3), (3, 4), (4, 1)]
TRIANGLE = [(1, 2), (2, 3), (3, 1)]
# Nastran has the edges along the height before those of the upper side.
HEXA = [*QUAD, (1, 5), (2, 6), (3, 7), (4, 8), (5, 6), (6, 7), (7, 8), (8, 5)]
PENTA = [*TRIANGLE, (1, 4), (2, 5), (3, 6), (4, 5), (5, 6), (6, 4)]
TETRA = [*TRIANGLE, (1, 4), (2, 4), (3, 4)]
SIDES = [(1, 2, 3, 4), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]


def cubes():
    """Eight hexahedra in a cube of side 2, the point in its middle moved."""
    for i in range(8):
        low = [i >> k & 1 for k in range(3)]
        corners = []
        for dx, dy, dz in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
            x = [low[0] + dx, low[1] + dy, low[2] + dz]
            corners.append([1.1, 0.9, 1.15] if x == [1, 1, 1] else [float(v) for v in x])
        yield corners


def on_side(corners, axis, value):
    return all(abs(c[axis] - value) < 1e-9 for c in corners)


def solid(form, kind):
    """The cube in hexahedra, pentahedra or tetrahedra, with shells on the sides that the deck needs."""
    bulk = Bulk(form)
    faces = []
    for c in cubes():
        if kind == "CHEXA":
            bulk.element("CHEXA", 1, c, HEXA)
            faces += [[c[i - 1] for i in side] for side in SIDES]
        elif kind == "CPENTA":
            for a, b, d in ((0, 1, 2), (0, 2, 3)):
                p = [c[a], c[b], c[d], c[a + 4], c[b + 4], c[d + 4]]
                bulk.element("CPENTA", 1, p, PENTA)
                faces += [[p[0], p[1], p[4], p[3]], [p[1], p[2], p[5], p[4]], [p[2], p[0], p[3], p[5]], p[:3], p[3:]]
        else:
            for t in ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)):
                p = [c[i] for i in t]
                bulk.element("CTETRA", 1, p, TETRA)
                faces += [[p[0], p[1], p[2]], [p[0], p[1], p[3]], [p[1], p[2], p[3]], [p[2], p[0], p[3]]]
    for part, axis, value in ((11, 0, 0.0), (12, 0, 2.0), (13, 1, 0.0), (14, 2, 0.0)):
        for f in faces:
            if on_side(f, axis, value):
                bulk.element("CQUAD8" if len(f) == 4 else "CTRIA6", part, f, QUAD if len(f) == 4 else TRIANGLE)
    bulk.write("PSOLID", 1, 3)
    bulk.write("MAT1", 3, 2.1e5, "", 0.25)
    return bulk.text


def plane(form, kind):
    """A square of side 2 in four quadrilaterals or eight triangles, with bars on its sides."""
    bulk = Bulk(form)
    edges = []
    for i in range(4):
        low = [i & 1, i >> 1]
        c = []
        for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1)):
            x = [low[0] + dx, low[1] + dy]
            c.append([1.1, 0.9, 0.0] if x == [1, 1] else [float(x[0]), float(x[1]), 0.0])
        if kind == "CQUAD8":
            bulk.element(kind, 1, c, QUAD)
        else:
            bulk.element(kind, 1, c[:3], TRIANGLE)
            bulk.element(kind, 1, [c[0], c[3], c[2]], TRIANGLE)  # clockwise
        edges += [[c[k], c[(k + 1) % 4]] for k in range(4)]
    for part, axis, value in ((11, 0, 0.0), (12, 0, 2.0), (13, 1, 0.0)):
        for e in edges:
            if on_side(e, axis, value):
                bulk.element("CBAR", part, e, [])
    bulk.write("PSHELL", 1, 3, 2.5)
    bulk.write("MAT1", 3, 2.1e5, "", 0.25)
    return bulk.text


def deck(dim, more=""):
    """Tension along x: s = 100, no stress across."""
    held = "XYZ"[:dim]
    freedoms = "".join(f"$FREEDOM CLASS=SUPPRESSED DOF={a}\n  S{s}\n" for a, s in zip(held, (11, 13, 14)))
    across = "".join(
        f"  S.{c}.{m}(P1,S) = 0 ABS 1e-7 SOURCE 'no stress'\n" for c in ("YY", "XY") for m in ("MIN", "MAX")
    )
    return f"""$DECK VERSION=1 LENGTH=MM FORCE=N
$IMPORT FILE='a.bdf' FORMAT=NASTRAN{more}
{freedoms}$LOAD CASE=PULL TYPE=TRACTION
  S12 100{" 0" * (dim - 1)}
$STEP NAME=S
  LOAD PULL 1
$CHECK
  S.XX.MIN(P1,S) = 100 REL 1e-9 SOURCE 'the load'
  S.XX.MAX(P1,S) = 100 REL 1e-9 SOURCE 'the load'
{across}  U.X.MAX(S12,S) = (100/210000*2) REL 1e-9 SOURCE 'bar: s L / E'
$END
"""


RING = """$DECK VERSION=1 LENGTH=MM FORCE=N
{mesh}$MATERIAL NAME=STEEL E=210000 NU=0.3
$PROPERTY ESET={part} MATERIAL=STEEL STATE=STRESS
$FREEDOM CLASS=SUPPRESSED DOF=XY
  {outer}
$LOAD CASE=PRESS TYPE=PRESSURE
  {inner} 10
$CRACK NAME=C A0=2 ANGLE=0
  10 0
$STEP NAME=S
  LOAD PRESS 1
$END
"""


def ring():
    """A ring as $MESH has it: 5 elements across, 40 around."""
    bulk = Bulk(LARGE)

    def at(i, j):
        r = 10 + 20 * i / 10
        return [r * math.cos(math.pi * j / 40), r * math.sin(math.pi * j / 40), 0.0]

    for j in range(0, 80, 2):
        for i in range(0, 10, 2):
            places = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
            bulk.elements += 1
            bulk.write("CQUAD8", bulk.elements, 1, *(bulk.node(at(i + a, j + b)) for a, b in places))
    for part, i in ((2, 0), (3, 10)):
        for j in range(0, 80, 2):
            bulk.elements += 1
            bulk.write("CBAR", bulk.elements, part, bulk.node(at(i, j)), bulk.node(at(i, j + 2)))
    return bulk.text


class Nastran(ProgramTest):
    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def test_constant_stress_in_solids(self):
        for kind in ("CHEXA", "CPENTA", "CTETRA"):
            for form in (SMALL, LARGE, FREE):
                with self.subTest(kind=kind, form=form):
                    self.write("a.bdf", "SOL 101\nCEND\nBEGIN BULK\n" + solid(form, kind) + "ENDDATA\n")
                    self.expect(0, "run", self.deck(deck(3)))

    def test_constant_stress_in_the_plane(self):
        for kind in ("CQUAD8", "CTRIA6"):
            for form in (SMALL, LARGE, FREE):
                with self.subTest(kind=kind, form=form):
                    self.write("a.bdf", plane(form, kind))
                    self.expect(0, "run", self.deck(deck(2)))

    def test_formats_give_one_mesh(self):
        meshes = set()
        for form in (SMALL, LARGE, FREE):
            self.write("a.dat", solid(form, "CHEXA"))
            self.expect(0, "convert", "a.dat", "a.msh", "--replace")
            meshes.add((self.folder / "a.msh").read_bytes())
        self.assertEqual(len(meshes), 1)

    def test_crack_in_a_ring_has_the_k_of_the_ring_by_card(self):
        self.write("a.bdf", ring())
        found = []
        for mesh, part, inner, outer in (
            ("$MESH SHAPE=RING TYPE=QUAMC8 RI=10 RO=30 NR=5 NT=40\n", "BODY", "INNER", "OUTER"),
            ("$IMPORT FILE='a.bdf' FORMAT=NASTRAN\n  S2 = BORE\n", "P1", "BORE", "S3"),
        ):
            text = RING.format(mesh=mesh, part=part, inner=inner, outer=outer)
            self.expect(0, "run", self.deck(text), "--out", "r")
            lines = (self.folder / "r" / "k.csv").read_text(encoding="utf-8").splitlines()
            rows = [line for line in lines if not line.startswith("#")]
            column = rows[0].split(",").index("K1")
            found.append(float(rows[-1].split(",")[column]))
        self.assertGreater(found[0], 1)
        self.assertAlmostEqual(found[1] / found[0], 1, delta=1e-4)  # coordinates of four decimals

    def test_loads_are_passed_over_when_asked(self):
        loads = entry(FREE, "SPC1", 1, 123, 1, "THRU", 4) + entry(FREE, "FORCE", 2, 5, "", 1.0, 1.0, 0.0, 0.0)
        self.write("a.bdf", solid(SMALL, "CHEXA") + loads)
        errors = self.expect(3, "check", self.deck(deck(3))).stderr
        self.assertIn("supports and loads are not imported: FORCE (1), SPC1 (1)", errors)
        self.assertIn("SKIP=LOADS", errors)
        errors = self.expect(0, "run", self.deck(deck(3, " SKIP=LOADS"))).stderr
        self.assertIn("W467", errors)
        self.assertIn("SPC1_123", errors)
        self.write("a.bdf", solid(SMALL, "CHEXA") + loads + "RBE2,900,1,123,2\n")
        self.assertIn("RBE2 is not imported (1 entry)", self.expect(3, "check", self.deck(deck(3, " SKIP=LOADS"))).stderr)
        self.assertIn("RBE2 (1)", self.expect(0, "run", self.deck(deck(3, " SKIP=ALL"))).stderr)

    def test_files_of_another_kind_are_named(self):
        self.write("a.bdf", solid(SMALL, "CHEXA"))
        errors = self.expect(3, "run", "a.bdf").stderr
        self.assertIn("error E337: this is Nastran bulk data, and no deck", errors)
        self.assertIn("$IMPORT FILE='a.bdf' FORMAT=NASTRAN", errors)
        self.assertEqual(errors.count("error"), 1)
        errors = self.expect(3, "check", self.deck(deck(3).replace("FORMAT=NASTRAN", "FORMAT=MSH"))).stderr
        self.assertIn("'a.bdf' is Nastran bulk data", errors)
        self.assertIn("= FORMAT=NASTRAN", errors)
        self.write("a.unv", "    -1\n  2411\n    -1\n")
        (self.folder / "a.med").write_bytes(b"\x89HDF\r\n\x1a\n\0\0\0")
        for name, remedy in (("a.unv", "gmsh a.unv -save -o a.msh"), ("a.med", "meshio convert --output-format gmsh a.med a.msh")):
            card = deck(3).replace("a.bdf", name).replace("NASTRAN", "MSH")
            for command in (("check", self.deck(card)), ("run", name), ("convert", name, "a.vtu")):
                errors = self.expect(3, *command).stderr
                self.assertIn("E337", errors)
                self.assertIn(remedy, errors)
                self.assertEqual(errors.count("error"), 1, errors)


if __name__ == "__main__":
    main()
