# SPDX-License-Identifier: GPL-3.0-or-later
"""Every element type through every form of file, judged by others.

Usage: check_convert.py SPRICKA FOLDER (of write_blocks). VTK integrates the volume of every .vtu
(the cells' own shape functions), CalculiX does the patch test on every .inp: a linear displacement
on the rim of a distorted block gives the same stress everywhere, for nodes in the right order only.
"""

import shutil
import struct
import subprocess
import sys
from pathlib import Path

import vtk

E, NU = 210000.0, 0.3
GRADIENT = {
    2: [[1, 0.4, 0], [0.2, -0.5, 0], [0, 0, 0]],
    3: [[1, 0.4, -0.3], [0.2, -0.5, 0.6], [0.1, 0.7, 0.8]],
}
NO_INP = {"QUAMC9", "HEXEC27"}


def convert(spricka, source, target):
    done = subprocess.run([spricka, "convert", "--replace", source, target], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{source} -> {target}: {done.returncode}\n{done.stderr}")


def stress(dim):
    """XX YY ZZ XY YZ ZX of the linear field, Hooke's law."""
    g = [[1e-3 * v for v in row] for row in GRADIENT[dim]]
    e = [[0.5 * (g[i][j] + g[j][i]) for j in range(3)] for i in range(3)]
    if dim == 2:  # plane stress
        e[2][2] = -NU / (1 - NU) * (e[0][0] + e[1][1])
    shear = E / (2 * (1 + NU))
    mean = E * NU / ((1 + NU) * (1 - 2 * NU)) * (e[0][0] + e[1][1] + e[2][2])
    pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]
    return [2 * shear * e[i][j] + (mean if i == j else 0.0) for i, j in pairs]


def grid_of(file):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


# Gauss points of the parametric unit cells that VTK has, exact for what these blocks need.
G = [(0.5 - 0.5 * 0.6**0.5, 5 / 18), (0.5, 8 / 18), (0.5 + 0.5 * 0.6**0.5, 5 / 18)]
G4 = [
    (0.5 - 0.5 * 0.8611363115940526, 0.5 * 0.34785484513745385),
    (0.5 - 0.5 * 0.3399810435848563, 0.5 * 0.6521451548625461),
    (0.5 + 0.5 * 0.3399810435848563, 0.5 * 0.6521451548625461),
    (0.5 + 0.5 * 0.8611363115940526, 0.5 * 0.34785484513745385),
]


def points_of(cell_type):
    """(r, s, t, weight) on VTK's parametric domain; triangles and tetrahedra by collapsed squares."""
    quads = {vtk.VTK_QUAD, vtk.VTK_QUADRATIC_QUAD, vtk.VTK_BIQUADRATIC_QUAD}
    triangles = {vtk.VTK_TRIANGLE, vtk.VTK_QUADRATIC_TRIANGLE}
    tets = {vtk.VTK_TETRA, vtk.VTK_QUADRATIC_TETRA}
    wedges = {vtk.VTK_WEDGE, vtk.VTK_QUADRATIC_WEDGE}
    flat = [(r, s, v * w) for r, v in G4 for s, w in G4]
    triangle = [(r * (1 - s), s, w * (1 - s)) for r, s, w in flat]
    if cell_type in quads:
        return [(r, s, 0.0, w) for r, s, w in flat]
    if cell_type in triangles:
        return [(r, s, 0.0, w) for r, s, w in triangle]
    if cell_type in wedges:
        return [(r, s, t, v * w) for r, s, v in triangle for t, w in G4]
    if cell_type in tets:
        return [
            (r * (1 - t), s * (1 - t), t, v * w * (1 - t) ** 2)
            for r, s, v in triangle
            for t, w in G4
        ]
    return [(r, s, t, v * w) for r, s, v in flat for t, w in G4]


def volume_by_vtk(grid):
    """Integral of the Jacobian with VTK's own interpolation derivatives.

    The sign is that of VTK's faces and sizes; on wedges its interpolation has the other one.
    """
    total = 0.0
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        n = cell.GetNumberOfPoints()
        dim = cell.GetCellDimension()
        x = [cell.GetPoints().GetPoint(i) for i in range(n)]
        for r, s, t, w in points_of(cell.GetCellType()):
            d = [0.0] * (n * dim)
            cell.InterpolateDerivs([r, s, t], d)
            J = [[sum(d[k * n + i] * x[i][j] for i in range(n)) for j in range(3)] for k in range(dim)]
            if cell.GetCellType() in (vtk.VTK_WEDGE, vtk.VTK_QUADRATIC_WEDGE):
                w = -w
            if dim == 2:
                total += w * (J[0][0] * J[1][1] - J[0][1] * J[1][0])
            else:
                total += w * (
                    J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1])
                    - J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0])
                    + J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0])
                )
    return total


def coordinates_of(deck):
    """Points of the $COOR table, as bits."""
    points, inside = [], False
    for line in deck.read_text().splitlines():
        if line.startswith("$"):
            inside = line.startswith("$COOR")
        elif inside:
            row = [float(v) for v in line.split()[1:]]
            points.append(struct.pack("3d", *(row + [0.0] * (3 - len(row)))))
    return sorted(points)


def check_vtu(file, deck, dim, volume):
    grid = grid_of(file)
    points = sorted(struct.pack("3d", *grid.GetPoint(i)) for i in range(grid.GetNumberOfPoints()))
    assert points == coordinates_of(deck), f"{file}: coordinates are not those of the deck"
    found = volume_by_vtk(grid)
    assert abs(found - volume) < 1e-12, f"{file}: volume {found}, not {volume}"
    if grid.GetCellType(0) != vtk.VTK_TRIQUADRATIC_HEXAHEDRON:  # whose size VTK 9.1 cannot tell
        sizes = vtk.vtkCellSizeFilter()
        sizes.SetInputData(grid)
        sizes.Update()
        size = sizes.GetOutput().GetCellData().GetArray("Volume" if dim == 3 else "Area")
        cells = range(grid.GetNumberOfCells())
        assert all(size.GetValue(i) > 0 for i in cells), f"{file}: turned over"
    body = grid.GetCellData().GetArray("BODY")
    assert all(body.GetValue(i) == 1 for i in range(grid.GetNumberOfCells())), file
    assert grid.GetPointData().GetArray("RIM") is not None, file
    assert grid.GetPointData().GetArray("SKIN") is not None, file


def stresses_of_frd(file):
    """Nodal stresses of a result file of CalculiX: SXX SYY SZZ SXY SYZ SZX."""
    rows, inside = [], False
    for line in file.read_text().splitlines():
        if line.startswith(" -4"):
            inside = line.split()[1] == "STRESS"
        elif inside and line.startswith(" -1"):
            rows.append([float(line[13 + 12 * i : 25 + 12 * i]) for i in range(6)])
    return rows


def check_ccx(ccx, file, dim):
    done = subprocess.run(
        [ccx, "-i", file.stem], cwd=file.parent, capture_output=True, text=True, timeout=300
    )
    frd = file.with_suffix(".frd")
    rows = stresses_of_frd(frd) if frd.exists() else []
    assert rows, f"{file}: ccx made no stresses\n{done.stdout[-2000:]}"
    wanted = stress(dim)
    size = max(abs(s) for s in wanted)
    worst = max(abs(a - b) / size for row in rows for a, b in zip(row, wanted))
    # its linear quadrilaterals and hexahedra (B-bar) keep to 1e-4, the others to its six digits
    assert worst < 2e-4, f"{file}: stress off by {worst} of {wanted}: {rows[0]}"
    return worst


def main():
    spricka, folder = sys.argv[1], Path(sys.argv[2])
    ccx = shutil.which("ccx")
    for line in (folder / "volumes.txt").read_text().splitlines():
        name, dim, volume = line.split()
        dim, volume = int(dim), float(volume)
        deck = folder / f"{name}.deck"
        for target in ("msh", "vtu"):
            convert(spricka, deck, folder / f"{name}.{target}")
        check_vtu(folder / f"{name}.vtu", deck, dim, volume)
        convert(spricka, folder / f"{name}.msh", folder / f"{name}_msh.vtu")
        check_vtu(folder / f"{name}_msh.vtu", deck, dim, volume)
        if name in NO_INP:
            print(f"{name}: volume")
            continue
        convert(spricka, folder / f"{name}.msh", folder / f"{name}_mesh.inp")
        convert(spricka, folder / f"{name}_mesh.inp", folder / f"{name}_inp.vtu")
        check_vtu(folder / f"{name}_inp.vtu", deck, dim, volume)
        convert(spricka, deck, folder / f"{name}.inp")
        worst = check_ccx(ccx, folder / f"{name}.inp", dim) if ccx else None
        print(f"{name}: volume" + (f", stress by ccx within {worst:.1e}" if ccx else ", no ccx"))


if __name__ == "__main__":
    main()
