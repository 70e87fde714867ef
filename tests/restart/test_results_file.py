# SPDX-License-Identifier: GPL-3.0-or-later
"""results.h5 as a reader meets it: h5py and pandas in three lines, and the reader of the manual."""

import csv
import re
import subprocess
import sys

import numpy as np
from run_folders import CRACKED, TOP, RestartTest, keeping, main, press_fit

PRESSED = press_fit("BUSH", 0.01, 4, 24)


def rows_of(path):
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line[0] != "#"]
    return list(csv.DictReader(lines))


class ResultsFile(RestartTest):
    def solve(self, text):
        self.expect(0, "run", self.deck(text), "--quiet")
        return self.folder / "test.run" / "results.h5"

    def reader(self, path):
        sys.path.insert(0, str(TOP / "manual"))
        from spricka_results import Results

        return Results(path)

    def test_three_lines(self):
        """Those that the manual shows."""
        page = (TOP / "manual" / "results_file.md").read_text(encoding="utf-8")
        example = re.search(r"```python\n(.*?)```", page, re.S)[1]
        self.assertLessEqual(len(example.strip().splitlines()), 3)
        self.solve(CRACKED)
        shown = subprocess.run(
            [sys.executable, "-c", example.replace("lug.run", "test.run")],
            cwd=self.folder,
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        self.assertIn("K1", shown)
        self.assertEqual(len(shown.splitlines()), 4)

    def test_k_is_that_of_the_table(self):
        results = self.reader(self.solve(CRACKED))
        table = rows_of(self.folder / "test.run" / "k.csv")
        self.assertEqual(len(table), 3)
        for row, (_, k) in zip(table, results.k.iterrows()):
            self.assertEqual((row["step"], row["crack"]), (k["step"], k["crack"]))
            for name in ("a", "K1", "K2", "G", "T", "spread", "K1_bar", "K2_raw"):
                self.assertEqual(float(row[name]), k[name], name)

    def test_a_tip_is_a_front_of_one_point(self):
        """The tables of the steps, of which `k` is the sum."""
        results = self.reader(self.solve(CRACKED))
        for number, (_, k) in zip(results.increments(), results.k.iterrows()):
            step = f"increments/{number:04d}/steps/LOAD"
            fronts, points = results.table(f"{step}/fronts"), results.table(f"{step}/fronts.points")
            self.assertEqual(list(fronts["name"]), [k["crack"]])
            self.assertEqual(list(fronts["a"]), [k["a"]])
            self.assertEqual(list(fronts["points_count"]), [1])
            self.assertEqual(list(points["number"]), [1])
            for name in ("K1", "K2", "G", "T", "spread"):
                self.assertEqual(list(points[name]), [k[name]], name)
            self.assertNotIn(f"{step}/tips", results.file)

    def test_pressure_is_that_of_the_table(self):
        results = self.reader(self.solve(PRESSED))
        table = rows_of(self.folder / "test.run" / "pressure.csv")
        self.assertEqual(len(table), len(results.pressure))
        self.assertGreater(len(table), 20)
        for row, (_, p) in zip(table, results.pressure.iterrows()):
            for name in ("x", "y", "p_lumped", "p_consistent"):
                self.assertEqual(float(row[name]), p[name], name)
        # the field: a press fit pushes the ring out and the pin in
        mesh, u = results.mesh(1), results.field("u", 1, "PRESS")
        radius = np.hypot(mesh["x"][:, 0], mesh["x"][:, 1])
        out = (mesh["x"][:, :2] * u).sum(axis=1) / radius
        ring = mesh["node_net"] == mesh["node_net"].min()
        inner = np.isclose(radius, 10.0)
        jump = out[inner & ring].mean() - out[inner & ~ring].mean()
        self.assertAlmostEqual(abs(jump), 0.01, delta=1e-4)

    def test_mesh_and_fields(self):
        results = self.reader(self.solve(CRACKED))
        self.assertEqual(results.increments(), [1, 2, 3])
        self.assertEqual(results.steps(1), ["LOAD"])
        area = 0.0
        for name, nodes in results.elements(3):
            x = results.mesh(3)["x"][nodes[:, : 4 if name.startswith("QUAM") else 3], :2]
            following = np.roll(x, -1, axis=1)
            area += 0.5 * (x[..., 0] * following[..., 1] - x[..., 1] * following[..., 0]).sum()
        self.assertAlmostEqual(area, 50.0, places=6)
        u = results.field("u", 3, "LOAD")
        self.assertEqual(u.shape, (len(results.mesh(3)["x"]), 2))
        self.assertEqual(results.field("stress", 3, "LOAD").shape[1], 6)
        self.assertIsNone(results.field("temperature", 3, "LOAD"))
        # the reactions hold 100 MPa on 10 mm of thickness 1
        self.assertAlmostEqual(results.field("reaction", 3, "LOAD")[:, 1].sum(), -1000.0, places=5)

    def test_where_it_comes_from(self):
        results = self.reader(self.solve(CRACKED))
        self.assertEqual(results.deck, {"test.deck": CRACKED})
        for name, value in (("length_unit", "mm"), ("stress_unit", "MPa"), ("title", "Plate")):
            self.assertEqual(results.attributes[name], value)
        self.assertIn("HDF5", results.attributes["libraries"])
        self.assertRegex(results.attributes["program"], "^spricka [0-9.]+$")
        self.assertRegex(results.file["deck"].attrs["hash"].decode(), "^[0-9a-f]{32}$")

    def test_an_increment_of_a_restart_file(self):
        self.solve(CRACKED.replace("$END", "$RESTART WRITE='state.rst'\n$END"))
        last = self.folder / "state.rst.d" / self.increments()[-1]
        kept, whole = self.reader(last), self.reader(self.folder / "test.run" / "results.h5")
        self.assertEqual(kept.steps(), ["LOAD"])
        self.assertTrue(np.array_equal(kept.field("u", 3, "LOAD"), whole.field("u", 3, "LOAD")))

    def test_the_same_deck_gives_the_same_bytes(self):
        path = self.solve(CRACKED)
        first = path.read_bytes()
        self.solve(CRACKED)
        self.assertEqual(path.read_bytes(), first)

    def test_one_length_of_many_is_read_alone(self):
        """Fields of one length cost a part of the file, and so do those of its restart file."""

        def bytes_read():
            with open("/proc/self/io", encoding="ascii") as counts:
                return int(next(line for line in counts if line.startswith("rchar")).split()[1])

        def cost(path, number):
            before = bytes_read()
            results = self.reader(path)
            values = [results.mesh(number)["x"], results.field("u", number, "LOAD"),
                      results.field("stress", number, "LOAD")]
            return bytes_read() - before, values

        lengths = "  ".join(f"{1 + 0.03 * i:g}" for i in range(52))
        deck = CRACKED.replace("  1  1.5  2\n", f"  {lengths}\n").replace("NX=4 NY=2", "NX=12 NY=6")
        path = self.solve(keeping(deck))
        part, values = cost(path, 40)
        self.assertLess(part, 0.05 * path.stat().st_size)
        increments = sorted((self.folder / "state.rst.d").glob("*.h5"))
        self.assertEqual(len(increments), 52)
        kept_part, kept = cost(increments[39], 40)
        self.assertLess(kept_part, 0.05 * sum(f.stat().st_size for f in increments))
        for one, other in zip(values, kept):
            self.assertTrue(np.array_equal(one, other))
        before = bytes_read()
        self.assertEqual(len(self.reader(path).k), 52)
        self.assertLess(bytes_read() - before, 0.01 * path.stat().st_size)

    def test_zeros_of_the_plane_take_no_room(self):
        """z of nodes and stresses that are zero in the plane: half of what the numbers would take."""
        import h5py

        deck = CRACKED.replace("NX=4 NY=2", "NX=40 NY=20")
        with h5py.File(self.solve(deck)) as file:
            increment = file["increments/0001"]
            for name, share in (("mesh/x", 0.6), ("steps/LOAD/stress", 0.75)):
                kept = increment[name]
                self.assertLess(kept.id.get_storage_size(), share * kept.size * 8, name)
            # Where numbers have all their digits they lie as they are: any part of them is read alone.
            self.assertIsNone(increment["steps/LOAD/u"].chunks)

    def test_the_reader_as_a_program(self):
        """The program of the module prints what a file holds."""
        path = self.solve(CRACKED)
        shown = subprocess.run(
            [sys.executable, "-B", str(TOP / "manual" / "spricka_results.py"), str(path)],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        self.assertIn("Plate", shown)
        self.assertIn("K1", shown)


if __name__ == "__main__":
    main()
