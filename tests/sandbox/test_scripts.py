# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts that want more than a mesh. usage: test_scripts.py PROGRAM"""

import time
import unittest

from meshes import SQUARE, MeshTest
from program import SANITIZED, main


class Outside(MeshTest):
    def test_the_square_itself(self):
        self.expect(0, "check", self.square())

    def test_commands_and_files_are_refused_by_name(self):
        for statement, name in [
            ('SystemCall "touch made";', "SystemCall"),
            ('NonBlockingSystemCall "touch made";', "NonBlockingSystemCall"),
            ('OnelabRun("foo", "touch made ");', "OnelabRun"),
            ('Merge "other.geo";', "Merge"),
            ('Include "other.geo";', "Include"),
            ('a = GetEnv("HOME");', "GetEnv"),
            ('Field[1] = ExternalProcess;', "ExternalProcess"),
            ('Plugin(Skin).Run;', "Plugin"),
            ("Exit;", "Exit"),
            ("Abort;", "Abort"),
        ]:
            with self.subTest(statement):
                deck = self.square(statement)
                before = self.files()
                self.assertIn(f"x.geo:7: {name} ", self.refused("E480", name, deck))
                self.assertEqual(self.files(), before)

    def test_what_only_writes_is_passed_over(self):
        for statement, name in [
            ('Mesh 2;\nSave "made";', "8: Save"),
            ('If (1)\nPrint "made.png"; EndIf', "8: Print"),
            ('CreateDir "made";', "7: CreateDir"),
            ("Mesh.SaveAll = 1;", "7: Mesh.SaveAll"),
        ]:
            with self.subTest(statement):
                deck = self.square(statement)
                before = self.files()
                told = self.expect(0, "check", deck).stderr
                self.assertIn(f"warning W482: x.geo:{name} ", told)
                self.assertEqual(self.files(), before)

    def test_a_text_is_printed_to_no_file(self):
        for arrow in (">", ">>"):
            deck = self.square(f'Printf("x") {arrow} "made";')
            before = self.files()
            self.refused("E331", "Unable to open file 'made'", deck)
            self.assertEqual(self.files(), before)

    def test_libraries_that_start_threads_start_none(self):
        # The distance from a surface is one of the places where OpenCASCADE works in parallel.
        bored_block = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 4, 1}; Cylinder(2) = {2, 2, -1, 0, 0, 3, 1};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
bore() = Surface In BoundingBox{0.9, 0.9, -0.1, 3.1, 3.1, 1.1};
foot() = Surface In BoundingBox{-0.1, -0.1, -0.1, 4.1, 4.1, 0.1};
Field[1] = Distance; Field[1].SurfacesList = {bore()};
Field[2] = Threshold; Field[2].InField = 1; Field[2].SizeMin = 0.7; Field[2].SizeMax = 2;
Field[2].DistMin = 0.5; Field[2].DistMax = 3; Background Field = 2;
Physical Volume("BODY") = {3}; Physical Surface("LOW") = {foot()}; Physical Surface("TOP") = {bore()};
Mesh.ElementOrder = 2;
"""
        deck = self.square()
        (self.folder / "x.geo").write_text(bored_block)
        text = deck.read_text().replace("STATE=STRESS", "STATE=SOLID").replace("DOF=XY", "DOF=XYZ")
        deck.write_text(text.replace("TOP  0  100", "TOP  0  100  0"))
        self.expect(0, "check", deck)

    def test_words_in_comments_and_texts_are_nothing(self):
        harmless = '// Exit;\n/* SystemCall "touch made"; */ a = Sprintf("Merge");\nSaved = 1;\n'
        self.expect(0, "check", self.square(harmless))

    def test_a_mesh_file_that_is_a_script(self):
        frame = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n$EndNodes\n$Elements\n$EndElements\n"
        for disguise in ("/*\n" + frame + "*/\n", " ", "//" + frame.replace("\n", "\n//") + "\n"):
            deck = self.square('SystemCall "touch made";', disguise, "x.msh", "MSH")
            self.refused("E331", "no gmsh mesh", deck)
            self.assertNotIn("made", self.files())

    def test_quotes_in_a_file_name_are_letters(self):
        name = 'x";SystemCall "touch made";Printf("hi.geo'
        self.expect(0, "check", self.square(name=name))
        self.assertNotIn("made", self.files())

    def test_no_temporary_file_is_needed_or_left(self):
        self.expect(0, "check", self.square(), TMPDIR="/nonexistent")
        self.expect(0, "check", self.square(), TMPDIR=str(self.folder))
        self.assertEqual(self.files(), ["test.deck", "x.geo"])


class Limits(MeshTest):
    def test_thirty_mistakes_are_named(self):
        mistakes = "".join(f"Point({i}) = {{zz{i}, 0, 0}};\n" for i in range(30, 60))
        self.refused("E331", "line 7: Unknown variable 'zz30'", self.square(mistakes))

    def test_endless_loop(self):
        begin = time.monotonic()
        deck = self.square("For i In {0:1e12}\n a = i;\nEndFor\n")
        self.refused("E481", "reading took more than", deck, "--mesh-time", "2")
        self.assertLess(time.monotonic() - begin, 30.0)

    def test_too_fine_a_mesh(self):
        deck = self.square("MeshSize{:} = 1e-4;\n")
        self.refused("E481", "meshing took more than 2 s", deck, "--mesh-time", "2")

    @unittest.skipIf(SANITIZED, "under the sanitizer: its shadow is larger than any limit")
    def test_too_much_memory(self):
        deck = self.square('Physical Curve("B") = {10:4294967297};')
        self.refused("E482", "memory", deck, "--mesh-memory", "0.2")

    def test_deep_nesting(self):
        for text in ("(" * 100000, "a = " + "-" * 200000 + "1;", "If(1)\n" * 50000):
            with self.subTest(text[:6]):
                result = self.run_program("check", self.square(text))
                self.assertEqual(result.returncode, 3, result.stderr)

    def test_bytes_of_any_kind(self):
        deck = self.square("a = 1;")
        (self.folder / "x.geo").write_bytes(SQUARE.encode() + bytes(range(256)) * 4)
        self.expect(3, "check", deck)


main()
