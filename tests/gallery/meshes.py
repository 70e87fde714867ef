# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of our own for closed forms: blocks, rings, a strip with an edge crack."""
import numpy as np

from plane import Block, Mesh


def grid(xs, ys, kind, material, place=lambda x, y: (x, y)):
    """Quadrilaterals between the lines xs and ys; `place` maps them elsewhere (counter-clockwise)."""
    if kind == "Q4":
        at = {}
        x = [(a, b) for b in ys for a in xs]
        at = np.arange(len(x)).reshape(len(ys), len(xs))
        nodes = np.stack([at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]], -1).reshape(-1, 4)
    else:
        half = [np.insert(v, range(1, len(v)), (np.array(v[1:]) + v[:-1]) / 2) for v in (xs, ys)]
        at = np.full((len(half[1]), len(half[0])), -1)
        x = []
        for j, b in enumerate(half[1]):
            for i, a in enumerate(half[0]):
                if i % 2 == 0 or j % 2 == 0:
                    at[j, i] = len(x)
                    x.append((a, b))
        c = [at[0:-1:2, 0:-1:2], at[0:-1:2, 2::2], at[2::2, 2::2], at[2::2, 0:-1:2],
             at[0:-1:2, 1::2], at[1::2, 2::2], at[2::2, 1::2], at[1::2, 0:-1:2]]
        nodes = np.stack(c, -1).reshape(-1, 8)
    return Mesh(np.array([place(a, b) for a, b in x], float), [Block(kind, nodes, material)])


def ring(radii, angles, kind, material):
    """Sector between the radii and angles given; a whole ring if the angles go round once."""
    mesh = grid(radii, angles, kind, material, lambda r, t: (r * np.cos(t), r * np.sin(t)))
    if abs(angles[-1] - angles[0] - 2 * np.pi) < 1e-9:
        join(mesh)
    return mesh


def join(mesh):
    """Makes nodes of one place one node."""
    scale = 1e-9 * np.abs(mesh.x).max()
    _, first, to = np.unique(np.round(mesh.x / scale / 10), axis=0, return_index=True, return_inverse=True)
    mesh.x = mesh.x[first]
    for block in mesh.blocks:
        block.nodes = to[block.nodes]


def together(*meshes):
    """One mesh of several that share no node."""
    shift, x, blocks = 0, [], []
    for mesh in meshes:
        x.append(mesh.x)
        blocks += [Block(b.kind, b.nodes + shift, b.material) for b in mesh.blocks]
        shift += len(mesh.x)
    return Mesh(np.vstack(x), blocks)


def graded(first, last, count, ratio):
    """Lines from first to last, the last part `ratio` times as wide as the first."""
    steps = np.geomspace(1.0, ratio, count)
    return first + (last - first) * np.insert(np.cumsum(steps), 0, 0.0) / steps.sum()


def quarter_points(mesh, tip, fraction=0.25):
    """Moves the middles of the sides at node `tip` to a fraction of them."""
    for block in mesh.blocks:
        corners = 3 if block.kind == "T6" else 4
        for side in range(corners):
            a, b = block.nodes[:, side], block.nodes[:, (side + 1) % corners]
            middle = block.nodes[:, corners + side]
            for i in np.flatnonzero(a == tip):
                mesh.x[middle[i]] = mesh.x[tip] + fraction * (mesh.x[b[i]] - mesh.x[tip])
            for i in np.flatnonzero(b == tip):
                mesh.x[middle[i]] = mesh.x[tip] + fraction * (mesh.x[a[i]] - mesh.x[tip])
