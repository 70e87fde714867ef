# SPDX-License-Identifier: GPL-3.0-or-later
"""The edge crack in a strip (benchmark F01), upper half, solved by the small program: width 1, height 2 of 4."""
from dataclasses import dataclass

import numpy as np

from meshes import graded, grid, quarter_points
from plane import Material, Mesh, edge_load, solve, stiffness

F_TENSION = {0.2: 1.367326, 0.3: 1.659866, 0.4: 2.111413, 0.5: 2.824579, 0.6: 4.033115, 0.7: 6.354877,
             0.8: 11.955346, 0.9: 34.63259, 0.95: 99.1303, 0.98: 394.647}
MATERIAL = Material(1e5, 0.3, True)


def exact(a):
    """K of tension 1 (collocation; agrees with Kaya and Erdogan 1987)."""
    return F_TENSION[a] * np.sqrt(np.pi * a)


@dataclass
class Strip:
    mesh: Mesh
    u: np.ndarray
    a: float
    tip: int

    @property
    def place(self):
        return np.array([self.a, 0.0])

    def face(self):
        x, y = self.mesh.x.T
        return np.flatnonzero((np.abs(y) < 1e-9) & (x < self.a - 1e-9))


def strip_mesh(a, n, ratio=12.0, fraction=0.25):
    """Graded towards the tip, n elements on each side of it; middles at the tip at `fraction`, 0.5 as they come."""
    xs = np.r_[(a - graded(0, a, n, ratio))[::-1], graded(a, 1, n, ratio)[1:]]
    mesh = grid(xs, graded(0, 2, 2 * n, 5 * ratio), "Q8", MATERIAL)
    tip = int(np.argmin(np.hypot(mesh.x[:, 0] - a, mesh.x[:, 1])))
    if fraction != 0.5:
        quarter_points(mesh, tip, fraction)
    return mesh, tip


def solved(mesh, tip, a):
    x, y = mesh.x.T
    f = edge_load(mesh, mesh.edges_in(np.flatnonzero(np.abs(y - 2) < 1e-9)), lambda *_: (0.0, 1.0))
    ligament = np.flatnonzero((np.abs(y) < 1e-9) & (x > a - 1e-9))
    u = solve(stiffness(mesh), f, np.r_[2 * ligament + 1, 2 * ligament[-1]])
    return Strip(mesh, u, a, tip)


def strip(a, n, ratio=12.0, fraction=0.25):
    mesh, tip = strip_mesh(a, n, ratio, fraction)
    return solved(mesh, tip, a)
