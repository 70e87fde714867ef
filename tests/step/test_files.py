# SPDX-License-Identifier: GPL-3.0-or-later
"""STEP files that are damaged, huge, of another kind or of strangers, and lines of $IMPORT that choose no face: one
message, no crash, no file touched. usage: test_files.py PROGRAM JOINT.step"""

from joint import JOINT
from program import SANITIZED, ProgramTest, main

FRAME = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n{}\nENDSEC;\nEND-ISO-10303-21;\n"


class Files(ProgramTest):
    def refused(self, code, words, text, keys="", rows="", options=()):
        (self.folder / "x.step").write_bytes(text)
        deck = self.deck(f"$DECK VERSION=1 LENGTH=MM FORCE=N\n$IMPORT FILE='x.step' {keys}\n{rows}$END\n")
        result = self.expect(3, "check", deck, *options)
        self.assertIn(f"error {code}: ", result.stderr)
        self.assertIn(words, result.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["test.deck", "x.step"])
        return result

    def setUp(self):
        super().setUp()
        self.joint = JOINT.read_bytes()

    def test_damaged_files(self):
        half = self.joint[: len(self.joint) // 2]
        noise = bytes((i * i * 7919 >> 3) % 256 for i in range(20000)).decode("latin-1")
        for code, words, text in [
            ("E331", "it is empty", b""),
            ("E331", "is it truncated?", half),
            ("E331", "Could not read file", half + b"\nENDSEC;\nEND-ISO-10303-21;\n"),
            ("E331", "gmsh", FRAME.format(noise).encode("latin-1")),
            ("E331", "it is no STEP file", b"solid cube\n"),
            ("E331", "it is an IGES file", (b" " * 72 + b"S      1\n") * 3),
            ("E331", "IFC2X3 describes buildings", self.joint.replace(b"AUTOMOTIVE_DESIGN", b"IFC2X3")),
            ("E333", "it holds no solid", FRAME.format("").encode()),
        ]:
            with self.subTest(words):
                told = self.refused(code, words, text).stderr
                self.assertEqual(told.count("error "), 1, told)

    def test_a_schema_of_another_name_is_no_matter(self):
        told = self.refused("E305", "", self.joint.replace(b"AUTOMOTIVE_DESIGN {", b"SOME_DESIGN {"), "SIZE=20").stdout
        self.assertIn("LUG_F7", told)

    def test_a_solid_that_is_lost_is_told(self):
        text = self.joint.decode()
        shell = text[text.index("MANIFOLD_SOLID_BREP('',#") :].split("#")[1].split(")")[0]
        damaged = text.replace(f"#{shell} = CLOSED_SHELL", f"#{shell} = CLOSED_SHEL")
        told = self.refused("E305", "", damaged.encode(), "SIZE=20").stderr
        self.assertIn("W485", told)

    def test_other_files_are_not_read(self):
        named = FRAME.format("#1=DOCUMENT_FILE('/etc/passwd','','',#2,$,$);").encode()
        self.refused("E333", "names files that do: /etc/passwd", named)
        held = self.joint.replace(b"DATA;\n", b"DATA;\n#9999=DOCUMENT_FILE('other.stp','','',#2,$,$);\n", 1)
        told = self.refused("E305", "", held, "SIZE=20").stderr
        self.assertIn("W483", told)
        self.assertIn("other.stp", told)

    def test_limits_of_time_and_memory(self):
        self.refused("E481", "meshing took more than 1 s", self.joint, "SIZE=0.1", options=("--mesh-time", "1"))
        if not SANITIZED:
            told = self.refused("E482", "more memory", self.joint, "SIZE=1", options=("--mesh-memory", "0.05"))
            self.assertEqual(told.stderr.count("error "), 1, told.stderr)
            huge = self.joint.replace(b"DATA;\n", b"DATA;\n/*" + b" " * (60 << 20) + b"*/", 1)
            self.refused("E482", "are too long", huge, options=("--mesh-memory", "0.2"))

    def test_what_the_file_does_not_have(self):
        for code, words, keys, rows in [
            ("E332", "no solid LUGG", "SOLID=LUGG", ""),
            ("E332", "no face is so", "SOLID=LUG", "  CYLINDER 14 = BORE\n"),
            ("E332", "there are radii 15, 32", "SOLID=LUG", "  CYLINDER 14 = BORE\n"),
            ("E332", "there is no face F70", "SOLID=LUG", "  F70 = BORE\n"),
            ("E332", "no face is so", "SOLID=LUG", "  (z > 100) = TOP\n"),
            ("E115", "a line is 'faces = NAME [size]'", "SOLID=LUG", "  F7 BORE\n"),
            ("E115", "chooses no faces", "SOLID=LUG", "  PLANE 3 = BORE\n"),
            ("E109", "a size is above 0", "SOLID=LUG", "  F7 = BORE 0\n"),
            ("E302", "there is a set BODY already", "SOLID=LUG", "  F7 = BODY\n"),
            ("E109", "FINER: 0 is out of range", "FINER=0", ""),
            ("E337", "is a STEP file", "FORMAT=GEO SIZE=3", ""),
        ]:
            with self.subTest(words):
                self.assertEqual(self.refused(code, words, self.joint, keys, rows).stderr.count("error"), 1)
        mesh = b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
        self.refused("E110", "SIZE is for FORMAT=STEP", mesh, "FORMAT=MSH SIZE=3")


class Content(ProgramTest):
    def test_a_file_is_known_by_what_it_holds(self):
        (self.folder / "part.txt").write_bytes(JOINT.read_bytes())
        (self.folder / "other.txt").write_text("nothing")
        for file, words in (("part.txt", "E305"), ("other.txt", "FORMAT=GEO|MSH|INP|NASTRAN|STEP")):
            deck = self.deck(f"$DECK VERSION=1 LENGTH=MM FORCE=N\n$IMPORT FILE='{file}'\n$END\n")
            self.assertIn(words, self.expect(3, "check", deck).stderr)

    def test_a_step_file_becomes_another_mesh(self):
        (self.folder / "part.stp").write_bytes(JOINT.read_bytes())
        self.expect(0, "convert", "part.stp", "part.msh")
        self.assertIn('"LUG_F7"', (self.folder / "part.msh").read_text())



main()
