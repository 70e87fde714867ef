# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of the house finds what it is there to find: faults planted one by one in a sound tree."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import architecture
import check_layers
import wording
from cpp_text import read_declarations

# Eight rooms of like size, each using the one below: no room holds 15 % of the lines.
CHAIN = ["base", "model", "mesh", "mesh/cut", "solve", "life", "results", "mesher"]


def cmake(room, uses, sources):
    return f"# What {room} is for.\nspricka_room({room}\n  SOURCES {sources}\n  USES {uses})\n"


def sound_tree(top):
    """Eight rooms in src, and the deck language, which has its own place."""
    below = ""
    for room in CHAIN:
        name = room.replace("/", "_")
        put(top, f"src/{room}/CMakeLists.txt", cmake(room, below, f"{name}.cpp"))
        put(top, f"src/{room}/{name}.hpp", "#pragma once\n" + "// more\n" * 27)
        used = f'#include "{below}/{below.replace("/", "_")}.hpp"\n' if below else "// ground\n"
        put(top, f"src/{room}/{name}.cpp", f'#include "{room}/{name}.hpp"\n{used}')
        below = room
    put(top, "grammar/CMakeLists.txt", cmake("grammar", "base", "card.cpp"))
    put(top, "grammar/card.cpp", '#include "base/base.hpp"\n#include <boost/spirit/home/x3.hpp>\n')
    put(top, architecture.PAGE, f"# House\n\n{architecture.BEGIN}\n{architecture.END}\nprose\n")


def put(top, file, text):
    path = top / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def add(top, file, text):
    path = top / file
    put(top, file, (path.read_text(encoding="utf-8") if path.exists() else "") + text)


def run(top, *arguments):
    """(exit code, what is printed) of the program."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        code = check_layers.main([str(top), *arguments])
    return code, out.getvalue()


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = Path(folder.name)
        sound_tree(self.top)

    def refused(self, *words):
        """There is one fault, and its message has all the words."""
        errors = check_layers.check(self.top)
        self.assertEqual(len(errors), 1, errors)
        for word in words:
            self.assertIn(word, errors[0])
        self.assertEqual(run(self.top)[0], 1)


class SoundTree(Tree):
    def test_passes_once_its_page_is_written(self):
        self.assertEqual(check_layers.check(self.top), [])
        self.assertEqual(run(self.top, "--write")[0], 0)
        self.assertEqual(run(self.top), (0, "the house keeps its rules\n"))

    def test_libraries_in_their_rooms_pass(self):
        add(self.top, "src/solve/solve.cpp", "#include <suitesparse/cholmod.h>\n")
        add(self.top, "src/life/life.cpp", "#include <gsl/gsl_spline.h>\n")
        add(self.top, "src/mesher/mesher.cpp", "#include <gmsh.h>\n")
        add(self.top, "src/results/results.cpp", "#include <hdf5.h>\n")
        self.assertEqual(check_layers.check(self.top), [])


class Includes(Tree):
    def test_a_room_that_uses_does_not_name_is_refused(self):
        add(self.top, "src/solve/solve.cpp", '#include "base/base.hpp"\n')
        self.refused("src/solve/solve.cpp:3", "base/base.hpp", "src/solve/CMakeLists.txt")

    def test_a_sub_room_is_not_its_room(self):
        add(self.top, "src/solve/solve.cpp", '#include "mesh/mesh.hpp"\n')
        self.refused("src/solve/solve.cpp:3", "room mesh,")

    def test_what_is_not_there_is_refused(self):
        add(self.top, "src/solve/solve.cpp", ' #  include "solve.hpp"\n')
        self.refused("src/solve/solve.cpp:3", '"solve.hpp"')

    def test_a_way_round_the_names_is_refused(self):
        add(self.top, "src/solve/solve.cpp", '#include "../solve/solve.hpp"\n')
        self.refused("src/solve/solve.cpp:3", '"../solve/solve.hpp"')

    def test_an_idle_use_is_refused(self):
        put(self.top, "src/solve/CMakeLists.txt", cmake("solve", "mesh/cut base", "solve.cpp"))
        self.refused("src/solve/CMakeLists.txt", "USES base", "solve")

    def test_a_use_of_no_room_is_refused(self):
        put(self.top, "src/solve/CMakeLists.txt", cmake("solve", "mesh/cut cellar", "solve.cpp"))
        self.refused("src/solve/CMakeLists.txt", "cellar")

    def test_libraries_elsewhere_are_refused(self):
        for file, header in [("src/model/model.cpp", "boost/spirit/home/x3.hpp"),
                             ("src/model/model.cpp", "suitesparse/cholmod.h"),
                             ("src/solve/solve.cpp", "gsl/gsl_spline.h"),
                             ("src/mesh/cut/mesh_cut.cpp", "gmsh.h"),
                             ("src/mesher/mesher.hpp", "gmsh.h"),
                             ("grammar/card.cpp", "hdf5.h")]:
            with self.subTest(header), tempfile.TemporaryDirectory() as folder:
                self.top = Path(folder)
                sound_tree(self.top)
                add(self.top, file, f"#include <{header}>\n")
                self.refused(file, header, "may be included in")


class Circles(Tree):
    def test_of_rooms(self):
        put(self.top, "src/model/CMakeLists.txt", cmake("model", "base solve", "model.cpp"))
        put(self.top, "src/model/late.hpp", '#include "solve/solve.hpp"\n')
        self.refused("circle of rooms: mesh, mesh/cut, model, solve",
                     'src/model/late.hpp:1 includes "solve/solve.hpp"',
                     'src/solve/solve.cpp:2 includes "mesh/cut/mesh_cut.hpp"')

    def test_of_components(self):
        put(self.top, "src/solve/path.hpp", '#include "solve/walk.hpp"\n')
        put(self.top, "src/solve/walk.hpp", "#pragma once\n")
        put(self.top, "src/solve/walk.cpp", '#include "solve/walk.hpp"\n#include "solve/path.hpp"\n')
        put(self.top, "src/solve/CMakeLists.txt",
            cmake("solve", "mesh/cut", "solve.cpp walk.cpp"))
        self.refused("circle of components: solve/path, solve/walk",
                     'src/solve/path.hpp:1 includes "solve/walk.hpp"',
                     'src/solve/walk.cpp:2 includes "solve/path.hpp"')

    def test_a_source_with_its_own_header_is_none(self):
        self.assertEqual(check_layers.circles({"a": ["b"], "b": ["c"], "c": []}), [])

    def test_two_circles_are_two(self):
        graph = {"a": ["b"], "b": ["a", "c"], "c": ["d"], "d": ["e"], "e": ["c"], "f": ["a"]}
        self.assertEqual(check_layers.circles(graph), [["a", "b"], ["c", "d", "e"]])


class Rooms(Tree):
    def test_two_headers_of_one_name_are_refused(self):
        put(self.top, "src/solve/life.hpp", "")
        self.refused("headers of one name", "src/life/life.hpp", "src/solve/life.hpp")

    def test_a_room_that_is_too_big_is_refused(self):
        add(self.top, "src/solve/solve.cpp", "// one more line\n" * 13)
        self.refused("src/solve/CMakeLists.txt", "43 of 255 lines", "15%")

    def test_a_folder_that_is_no_room_is_refused(self):
        put(self.top, "src/solve/deep/er.hpp", "")
        self.refused("src/solve/deep/er.hpp", "in no room")

    def test_a_room_of_another_name_is_refused(self):
        put(self.top, "src/solve/CMakeLists.txt", cmake("solver", "mesh/cut", "solve.cpp"))
        self.refused("src/solve/CMakeLists.txt", "spricka_room(solve ..)")

    def test_a_room_without_a_purpose_is_refused(self):
        text = cmake("solve", "mesh/cut", "solve.cpp").split("\n", 1)[1]
        put(self.top, "src/solve/CMakeLists.txt", text)
        self.refused("src/solve/CMakeLists.txt", "purpose")

    def test_a_source_that_is_not_compiled_is_refused(self):
        put(self.top, "src/solve/idle.cpp", "")
        self.refused("src/solve/idle.cpp", "src/solve/CMakeLists.txt")

    def test_an_empty_tree_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(len(check_layers.check(Path(folder))), 1)


class Page(Tree):
    def setUp(self):
        super().setUp()
        run(self.top, "--write")

    def aged(self, *words):
        code, text = run(self.top)
        self.assertEqual((code, text.count("\n")), (1, len(words)), text)
        for word in words:
            self.assertIn(word, text)
        self.assertEqual(run(self.top, "--write")[0], 0)
        self.assertEqual(run(self.top)[0], 0)

    def test_the_prose_stays(self):
        text = (self.top / architecture.PAGE).read_text(encoding="utf-8")
        self.assertTrue(text.startswith("# House\n") and text.endswith("prose\n"), text)
        self.assertIn("| `mesh/cut` | What mesh/cut is for. | 30 | mesh |", text)

    def test_a_new_purpose_ages_the_table_and_the_picture(self):
        text = cmake("solve", "mesh/cut", "solve.cpp").replace("What", "All that")
        put(self.top, "src/solve/CMakeLists.txt", text)
        self.aged(architecture.PAGE, architecture.PICTURE)

    def test_a_new_arrow_ages_the_table(self):
        add(self.top, "src/solve/solve.cpp", '#include "base/base.hpp"\n')
        put(self.top, "src/solve/CMakeLists.txt", cmake("solve", "mesh/cut base", "solve.cpp"))
        self.aged(architecture.PAGE)

    def test_a_tenth_more_lines_do_not_age_it(self):
        add(self.top, "src/solve/solve.cpp", "//\n" * 3)
        self.assertEqual(run(self.top)[0], 0)
        add(self.top, "src/solve/solve.cpp", "//\n")
        self.aged(architecture.PAGE)

    def test_a_picture_that_is_gone_is_missed(self):
        (self.top / architecture.PICTURE).unlink()
        self.aged(architecture.PICTURE)

    def test_a_file_that_a_page_names_is_missed(self):
        put(self.top, "manual/glossary.md", "In `solve/solve.cpp` and\n`mesh/cut`, `grammar/card.cpp`,"
            " `src/base/base.hpp`, `deck/no_*.cpp`.\n")
        self.assertEqual(run(self.top)[0], 0)
        (self.top / "build/dev").mkdir(parents=True, exist_ok=True)
        add(self.top, "manual/glossary.md", "Not `solve/gone.cpp`, `mesh/gone`, `build/dev`.\n")
        code, text = run(self.top)
        self.assertEqual(code, 1)
        self.assertIn("manual/glossary.md:3: there is no solve/gone.cpp", text)
        self.assertIn("manual/glossary.md:3: there is no mesh/gone", text)
        self.assertIn("manual/glossary.md:3: there is no build/dev", text)

    def test_what_a_comment_cites_is_missed(self):
        put(self.top, "manual/theory/mesh.md", "$$ x = 1 \\tag{mesh.1} $$ and (mesh.2)\n")
        add(self.top, "src/solve/solve.cpp", "int i; // mesh.1 to 2 of mesh/mesh.hpp (life.hpp)\n")
        self.assertEqual(run(self.top)[0], 0)
        add(self.top, "src/solve/solve.cpp", "// mesh.3, path/mesh.hpp, moon.3\n")
        code, text = run(self.top)
        self.assertEqual((code, text.count("\n")), (1, 2), text)
        self.assertIn("src/solve/solve.cpp:4: there is no mesh.3", text)
        self.assertIn("src/solve/solve.cpp:4: there is no path/mesh.hpp", text)

    def test_a_page_without_its_marks_is_refused(self):
        put(self.top, architecture.PAGE, "# House\n")
        code, text = run(self.top)
        self.assertEqual(code, 1)
        self.assertIn(architecture.BEGIN, text)


class Words(Tree):
    def test_a_denied_word_in_a_name_is_refused(self):
        add(self.top, "src/life/life.cpp", "int stepsLeapt; // what a leap is, comments may say\n")
        self.refused("src/life/life.cpp:3", "stepsLeapt", "breakthrough")

    def test_two_types_of_one_name_are_refused(self):
        add(self.top, "src/life/life.cpp", "template <class T> struct Place { int x = 0; };\n")
        add(self.top, "src/mesh/mesh.cpp", "namespace m {\nclass Place final : Base {\n};\nstruct Host::Place;\n}\n")
        self.refused("Place", "src/life/life.cpp:3", "src/mesh/mesh.cpp:4")

    def test_more_branches_on_the_dimension_are_refused(self):
        add(self.top, "src/life/life.cpp", "bool a() { return model.dim == 3; }\n" * 2)
        with mock.patch.object(wording, "BRANCHES", 1):
            self.refused("2 lines in 1 files")

    def test_functions_are_read_with_their_comments(self):
        found = read_declarations("""/// How far two points are apart [length].
template <int dim>
[[nodiscard]] double distance(const Vec<dim>& a, const Vec<dim>& b = {1, 2});
class Net {
public:
  Net(int n);
  void add_node(int n); ///< behind the others
private:
  void hidden();
};
double Net::size(int a) {
  return a;
}
""")
        self.assertEqual([(f.owner, f.name, f.line) for f in found.functions], [("", "distance", 3), ("Net", "add_node", 7)])
        self.assertIn("apart", found.functions[0].comment)
        self.assertIn("behind", found.functions[1].comment)
        self.assertEqual([(t.name, t.line, t.last) for t in found.types], [("Net", 4, 10)])
        self.assertEqual(found.members, [("Net", 11, 13)])


if __name__ == "__main__":
    unittest.main()
