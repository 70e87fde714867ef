# SPDX-License-Identifier: GPL-3.0-or-later
"""Two blocks and two rings for the small program, with contact rows between them."""
from dataclasses import dataclass

import numpy as np

from joint import Joint, contact_rows
from meshes import grid, ring, together
from plane import Material, Mesh, edge_load, stiffness


@dataclass
class Pair:
    mesh: Mesh
    slaves: np.ndarray
    edges: np.ndarray   # of the slave
    targets: np.ndarray
    gap: np.ndarray
    joint: Joint
    f: np.ndarray


def pair_of(first, second, touching, slave_first, normals, held, load):
    """Joins two meshes; `touching(x)` says which nodes are on the common side, `held(mesh)` and `load(mesh)` give
    freedoms and forces."""
    mesh = together(first, second)
    edges, on = mesh.edges(), touching(mesh.x)
    side = edges[on[edges[:, 0]] & on[edges[:, 1]]]
    mine = (side[:, 0] < len(first.x)) == slave_first
    own, other = side[mine], side[~mine]
    slaves = np.unique(own[own >= 0])
    G, gap, used = contact_rows(mesh, slaves, normals(mesh.x[slaves]), other)
    assert len(used) == len(slaves)
    return Pair(mesh, slaves, own, other, gap, Joint(stiffness(mesh), G, held(mesh)), load(mesh))


def stacked(kind, lower, upper, pressure=1000.0):
    """Benchmark C01: blocks of 10 by 5 on each other, an even pressure on top, the upper one's nodes the slaves."""
    material = Material(1e6, 0.3, True)
    first = grid(np.linspace(0, 10, lower + 1), np.linspace(0, 5, 4), kind, material)
    second = grid(np.linspace(0, 10, upper + 1), np.linspace(5, 10, 3), kind, material)

    def held(mesh):
        x, y = mesh.x.T
        return np.r_[2 * np.flatnonzero(np.abs(x) < 1e-9), 2 * np.flatnonzero(np.abs(y) < 1e-9) + 1]

    def load(mesh):
        top = mesh.edges_in(np.flatnonzero(np.abs(mesh.x[:, 1] - 10) < 1e-9))
        return edge_load(mesh, top, lambda *_: (0.0, -pressure))

    return pair_of(first, second, lambda x: np.abs(x[:, 1] - 5) < 1e-9, False,
                   lambda x: np.tile((0.0, -1.0), (len(x), 1)), held, load)


def fitted(unit):
    """Two blocks of 10 mm that overlap by 0.01 mm, in a unit of length of so many mm: E and lengths as numbers."""
    side, material = 10.0 / unit, Material(70e3 * unit ** 2, 0.3)  # N per unit^2
    first = grid(np.linspace(0, side, 3), np.linspace(0, side, 3), "Q8", material)
    second = grid(np.linspace(side, 2 * side, 4), np.linspace(0, side, 4), "Q8", material)

    def held(mesh):
        x, y = mesh.x.T
        ends = (np.abs(x) < 1e-9 * side) | (np.abs(x - 2 * side) < 1e-9 * side)
        return np.r_[2 * np.flatnonzero(ends), 2 * np.flatnonzero(np.abs(y) < 1e-9 * side) + 1]

    return pair_of(first, second, lambda x: np.abs(x[:, 0] - side) < 1e-9 * side, True,
                   lambda x: np.tile((1.0, 0.0), (len(x), 1)), held, lambda mesh: np.zeros(mesh.freedoms()))


def quarter(mesh):
    """Freedoms of the two lines of symmetry."""
    x, y = mesh.x.T
    return np.r_[2 * np.flatnonzero(np.abs(x) < 1e-9), 2 * np.flatnonzero(np.abs(y) < 1e-9) + 1]


def radial(x):
    return x / np.hypot(*x.T)[:, None]


def sleeve_in_ring(n):
    """Sleeve 30 to 36 in a ring 36 to 86.5, quarter, plane strain, meshes that do not match."""
    outer = ring(36 + 50.5 * (np.geomspace(1, 4, 4 * n + 1) - 1) / 3, np.linspace(0, np.pi / 2, 9 * n + 1), "Q8",
                 Material(69800, 0.33, True))
    inner = ring(np.linspace(30, 36, n + 1), np.linspace(0, np.pi / 2, 8 * n + 1), "Q8", Material(206000, 0.32, True))
    return pair_of(inner, outer, lambda x: np.abs(np.hypot(*x.T) - 36) < 1e-6, True, radial, quarter,
                   lambda mesh: np.zeros(mesh.freedoms()))


def rings(kind, inner, outer):
    """Benchmark C02: rings 0.5 to 1 to 2, half of each, pressure 1 from outside, so many sides round each half."""
    material = Material(5000.0, 0.3)
    first = ring(np.linspace(0.5, 1, 4), np.linspace(0, np.pi, inner + 1), kind, material)
    second = ring(np.linspace(1, 2, 5), np.linspace(0, np.pi, outer + 1), kind, material)

    def load(mesh):
        rim = mesh.edges_in(np.flatnonzero(np.abs(np.hypot(*mesh.x.T) - 2) < 1e-9))
        return edge_load(mesh, rim, lambda _, n: -n)

    return pair_of(first, second, lambda x: np.abs(np.hypot(*x.T) - 1) < 1e-9, True, radial, quarter, load)
