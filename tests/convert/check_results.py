# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a run with every element type, read back by VTK.

Usage: check_results.py SPRICKA FOLDER (of write_blocks). The blocks follow a linear displacement
field on their rim, so that displacement and stress are known everywhere, and the supports' forces
R at x obey sum R_i x_j = stress_ij times the volume.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np
import vtk
from check_convert import GRADIENT, grid_of, stress, volume_by_vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

THICKNESS = {2: 0.4, 3: 1.0}


def arrays_of(data):
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {array.GetName(): vtk_to_numpy(array) for array in arrays}


def near(found, wanted, scale, what):
    worst = np.abs(found - wanted).max()
    tolerance = 1e-9 if found.dtype == np.float64 else 2e-7
    assert worst < tolerance * scale, f"{what}: off by {worst}"


def tensor(s):
    return np.array([[s[0], s[3], s[5]], [s[3], s[1], s[4]], [s[5], s[4], s[2]]])


def check_positive(grid, dim, name):
    if grid.GetCellType(0) == vtk.VTK_TRIQUADRATIC_HEXAHEDRON:
        return  # whose size VTK 9.1 cannot tell; volume_by_vtk does
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    size = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume" if dim == 3 else "Area"))
    assert (size > 0).all(), f"{name}: turned over"


def check(file, name, dim, volume):
    grid = grid_of(file)
    found = volume_by_vtk(grid)
    assert abs(found - volume) < 1e-12, f"{name}: volume {found}, not {volume}"
    check_positive(grid, dim, name)
    x = vtk_to_numpy(grid.GetPoints().GetData())
    wanted = np.array(stress(dim))
    scale = np.abs(wanted).max()
    p = np.sort(np.linalg.eigvalsh(tensor(wanted)))[::-1]
    deviator = tensor(wanted) - np.trace(tensor(wanted)) / 3.0 * np.eye(3)
    mises = np.sqrt(1.5 * (deviator**2).sum())
    points, cells = arrays_of(grid.GetPointData()), arrays_of(grid.GetCellData())
    u = 1e-3 * x @ np.array(GRADIENT[dim]).T
    near(points["displacement"], u, 1e-3, f"{name}: displacement")
    for prefix, data in (("", points), ("element_", cells)):
        near(data[prefix + "stress"], wanted, scale, f"{name}: {prefix}stress")
        near(data[prefix + "principal"], p, scale, f"{name}: {prefix}principal")
        near(data[prefix + "von_mises"], mises, scale, f"{name}: {prefix}von_mises")
    reaction = points["reaction"]
    virial = reaction.T @ x
    force = tensor(wanted)[:dim, :dim] * volume * THICKNESS[dim]
    near(reaction.sum(axis=0), 0.0, np.abs(force).max(), f"{name}: reactions in all")
    near(virial[:dim, :dim], force, np.abs(force).max(), f"{name}: moments of the reactions")


LAYERS = """$DECK VERSION=1 LENGTH=mm FORCE=N
$MESH SHAPE=BLOCK TYPE=QUAMC8 LX=10 LY=2 NX=5 NY=2
$ESET NAME=SOFT WHERE=(y < 1)
$ESET NAME=STIFF WHERE=(y > 1)
$MATERIAL NAME=S E=1000 NU=0
$MATERIAL NAME=H E=5000 NU=0
$PROPERTY ESET=SOFT MATERIAL=S STATE=STRESS
$PROPERTY ESET=STIFF MATERIAL=H STATE=STRESS
$FREEDOM CLASS=PRESCRIBED DOF=X
  XMIN XMAX
$FREEDOM CLASS=SUPPRESSED DOF=Y
  YMIN
$LOAD CASE=PULL TYPE=DISP
  XMAX 0.1
$STEP NAME=FULL
  LOAD PULL 1
$END
"""


def check_layers(spricka, folder):
    """Two layers stretched together: every cell sees its own stress at all its points."""
    (folder / "layers.deck").write_text(LAYERS)
    run(spricka, folder / "layers.deck", folder / "layers.pictures")
    (file,) = (folder / "layers.pictures").glob("*.vtu")
    grid = grid_of(file)
    x = vtk_to_numpy(grid.GetPoints().GetData())
    border = np.abs(x[:, 1] - 1.0) < 1e-12
    points = arrays_of(grid.GetPointData())
    # 5 x 2 elements of 8 nodes have 45; the 11 of the border are there twice, no others
    assert len(x) == 45 + 11 and border.sum() == 22, (len(x), border.sum())
    assert len(set(points["label"][border])) == 11
    for c in range(grid.GetNumberOfCells()):
        ids = [grid.GetCell(c).GetPointId(i) for i in range(8)]
        wanted = 10.0 if x[ids, 1].mean() < 1.0 else 50.0
        near(points["stress"][ids, 0], wanted, 50.0, f"cell {c}")
        near(arrays_of(grid.GetCellData())["element_stress"][c, 0], wanted, 50.0, f"cell {c}")
    left = np.abs(x[:, 0]) < 1e-12
    near(points["reaction"][left].sum(axis=0), [-60.0, 0.0, 0.0], 60.0, "reactions counted once")


def run(spricka, deck, out):
    command = [spricka, "run", deck, "--out", out, "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, f"{deck}: {done.returncode}\n{done.stderr}"


def main():
    spricka, folder = sys.argv[1], Path(sys.argv[2])
    seen = set()
    for line in (folder / "volumes.txt").read_text().splitlines():
        name, dim, volume = line.split()
        out = folder / f"{name}.pictures"
        run(spricka, folder / f"{name}.deck", out)
        (file,) = out.glob("*.vtu")
        check(file, name, int(dim), float(volume))
        seen.add(grid_of(file).GetCellType(0))
    assert len(seen) == 12, seen
    check_layers(spricka, folder)


main()
