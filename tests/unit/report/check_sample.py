# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the sample's VTU and PVD with VTK, compares them with its formulas, parses its drawings."""

import re
import sys
import xml.etree.ElementTree as tree
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

BORE, RIM, INNER = 36.0, 80.0, 30.0


def read(file):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def near(found, wanted, what, tolerance=0.0):
    worst = np.abs(np.asarray(found) - np.asarray(wanted)).max()
    assert worst <= tolerance, f"{what}: off by {worst}"


def check_mid_nodes(grid, x):
    """Every edge's third node lies near the middle of its ends: the nodes are in VTK's order."""
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        for e in range(cell.GetNumberOfEdges()):
            ids = cell.GetEdge(e).GetPointIds()
            a, b, mid = (x[ids.GetId(i)] for i in range(3))
            length = np.linalg.norm(b - a)
            assert np.linalg.norm(mid - 0.5 * (a + b)) < 0.05 * length, (c, e)


def area(grid, x):
    """Area inside the curved edges, element by element (Simpson is exact for parabolas)."""
    total = 0.0
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        for e in range(cell.GetNumberOfEdges()):
            ids = cell.GetEdge(e).GetPointIds()
            a, b, m = (x[ids.GetId(i)] for i in range(3))
            ta, tm, tb = -3 * a + 4 * m - b, b - a, a - 4 * m + 3 * b
            for weight, p, t in ((1 / 6, a, ta), (4 / 6, m, tm), (1 / 6, b, tb)):
                total += 0.5 * weight * (p[0] * t[1] - p[1] * t[0])
    return total


def check(file):
    grid = read(file)
    types = set(vtk_to_numpy(grid.GetCellTypesArray()).tolist())
    assert types == {22, 23, 28}, types
    x = vtk_to_numpy(grid.GetPoints().GetData())
    assert np.hypot(x[:, 0], x[:, 1]).max() < RIM + 1e-9, "a node of no element was written"
    check_mid_nodes(grid, x)
    exact = np.pi * (RIM**2 - INNER**2)
    assert abs(area(grid, x) / exact - 1.0) < 1e-5

    data = grid.GetPointData()
    u = vtk_to_numpy(data.GetArray("displacement"))
    assert u.dtype == np.float64
    near(u[:, 0], 1e-3 * x[:, 0] + 2e-5 * x[:, 0] * x[:, 1], "ux", 1e-15)
    near(u[:, 1], -5e-4 * x[:, 1] + 1e-5 * x[:, 0] ** 2, "uy", 1e-15)
    near(u[:, 2], 0.0, "uz")
    stress = vtk_to_numpy(data.GetArray("stress"))
    assert stress.shape[1] == 6
    near(stress[:, 0], x[:, 0], "sxx")
    near(stress[:, 1], x[:, 1], "syy")
    near(stress[:, 3], 0.1 * x[:, 0] * x[:, 1], "sxy", 1e-12)
    near(stress[:, [2, 4, 5]], 0.0, "szz syz szx")
    xx, yy, xy = stress[:, 0], stress[:, 1], stress[:, 3]
    mises = np.sqrt(xx**2 + yy**2 - xx * yy + 3 * xy**2)
    near(vtk_to_numpy(data.GetArray("von_mises")), mises, "von Mises", 1e-10)

    net = vtk_to_numpy(grid.GetCellData().GetArray("net"))
    for c in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(c).GetPointIds()
        centre = np.mean([x[ids.GetId(i)] for i in range(ids.GetNumberOfIds())], axis=0)
        assert net[c] == (0 if np.hypot(*centre[:2]) > BORE else 1)


def check_solids(file):
    """Mid-edge and mid-face nodes of solids stand where VTK expects them."""
    grid = read(file)
    x = vtk_to_numpy(grid.GetPoints().GetData())
    assert vtk_to_numpy(grid.GetCellTypesArray()).tolist() == [24, 26, 25, 29]
    assert grid.GetPointData().GetArray("displacement") is None
    check_mid_nodes(grid, x)
    cube = grid.GetCell(3)
    for f in range(cube.GetNumberOfFaces()):
        ids = cube.GetFace(f).GetPointIds()
        p = np.array([x[ids.GetId(i)] for i in range(9)])
        near(p[8], p[:4].mean(axis=0), "centre of a face", 1e-14)
    p = np.array([x[cube.GetPointId(i)] for i in range(27)])
    near(p[26], p[:8].mean(axis=0), "centre of the cube", 1e-14)


def check_quarter_points(file):
    """Quarter points stand at the first corner, and VTK finds every element the right way round."""
    grid = read(file)
    x = vtk_to_numpy(grid.GetPoints().GetData())
    assert vtk_to_numpy(grid.GetCellTypesArray()).tolist() == [22, 23, 28, 24, 26, 25, 29]
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        tip = cell.GetPointId(0)
        for e in range(cell.GetNumberOfEdges()):
            ids = cell.GetEdge(e).GetPointIds()
            a, b, mid = (ids.GetId(i) for i in range(3))
            t = {a: 0.25, b: 0.75}.get(tip, 0.5)
            near(x[mid], (1 - t) * x[a] + t * x[b], f"cell {c}, edge {e}", 1e-14)
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    data = sizes.GetOutput().GetCellData()
    area, volume = (vtk_to_numpy(data.GetArray(name)) for name in ("Area", "Volume"))
    near(area[:3], [0.5, 1.0, 1.0], "areas", 1e-6)
    # VTK cuts the curved shapes into tetrahedra; the last one's size VTK 9.1 cannot tell.
    near(volume[3:6], [1 / 6, 0.5, 1.0], "volumes", 1e-6)


def check_drawings(page):
    """Each inline drawing is well-formed XML of its own."""
    drawings = re.findall(r"<svg.*?</svg>", page.read_text(encoding="utf-8"), re.S)
    assert len(drawings) == 14, len(drawings)
    for drawing in drawings:
        root = tree.fromstring(drawing)
        assert root.get("aria-label") and len(root) > 1
        assert "nan" not in drawing and "inf" not in drawing


def main():
    folder = Path(sys.argv[1])
    entries = tree.parse(folder / "sample.pvd").getroot().findall("./Collection/DataSet")
    assert [float(e.get("timestep")) for e in entries] == [6.0, 18.0]
    for entry in entries:
        check(folder / entry.get("file"))
    check_solids(folder / "solids.vtu")
    check_quarter_points(folder / "quarter.vtu")
    check_drawings(folder / "report.html")


main()
