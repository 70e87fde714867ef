# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of the layers finds what it is there to find."""

import tempfile
import unittest
from pathlib import Path

import check_layers


class Tree(unittest.TestCase):
    def errors(self, file, text):
        with tempfile.TemporaryDirectory() as folder:
            top = Path(folder)
            (top / "grammar").mkdir()
            (top / "src").mkdir()
            path = top / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            return check_layers.check(top)

    def broken(self, file, text):
        errors = self.errors(file, text)
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(file, errors[0])

    def test_what_the_table_allows_passes(self):
        self.assertEqual(self.errors("src/fe/a.cpp", '#include "fe/a.hpp"\n#include "base/id.hpp"\n'), [])
        self.assertEqual(self.errors("grammar/a.cpp", "#include <boost/spirit/home/x3.hpp>\n"), [])
        self.assertEqual(self.errors("src/solve/a.cpp", "#include <cholmod.h>\n"), [])
        self.assertEqual(self.errors("src/mesher/fill_gmsh.cpp", "#include <gmsh.h>\n"), [])

    def test_an_arrow_up_the_table_fails(self):
        self.broken("src/base/a.hpp", '#include "model/mesh.hpp"\n')
        self.broken("src/crack/a.cpp", '#include "contact/surface.hpp"\n')
        self.broken("src/deep/er/a.cpp", '#include "base/id.hpp"\n')

    def test_an_include_without_its_room_fails(self):
        self.broken("src/fe/a.cpp", '#include "a.hpp"\n')
        self.broken("src/fe/a.cpp", ' #  include "../base/id.hpp"\n')

    def test_a_library_outside_its_room_fails(self):
        self.broken("src/deck/a.cpp", "#include <boost/spirit/home/x3.hpp>\n")
        self.broken("src/fe/a.cpp", "#include <suitesparse/cholmod.h>\n")
        self.broken("src/fe/a.cpp", "#include <gsl/gsl_spline.h>\n")
        self.broken("src/mesh/patch.cpp", "#include <gmsh.h>\n")
        self.broken("src/mesher/gmsh_session.hpp", "#include <gmsh.h>\n")
        self.broken("src/program/a.cpp", "#include <hdf5.h>\n")

    def test_a_cycle_in_the_table_fails(self):
        self.assertEqual(check_layers.table_errors({"a": "b", "b": "c", "c": ""}), [])
        self.assertEqual(len(check_layers.table_errors({"a": "b", "b": "c", "c": "a"})), 1)

    def test_an_empty_tree_fails(self):
        self.assertEqual(len(self.errors("src/notes.txt", "")), 1)


if __name__ == "__main__":
    unittest.main()
