# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: elements that have been pulled inside out are integrated like others; their area counts as negative."""
import numpy as np

from plane import points_of


def shaken(mesh, keep, amount, seed):
    """Corners moved by `amount` of the shortest side there, those of `keep` not, middles in the middle again."""
    dice = np.random.default_rng(seed)
    size = np.full(len(mesh.x), np.inf)
    for block in mesh.blocks:
        for side in range(4):
            a, b = block.nodes[:, side], block.nodes[:, (side + 1) % 4]
            length = np.hypot(*(mesh.x[a] - mesh.x[b]).T)
            np.minimum.at(size, a, length)
            np.minimum.at(size, b, length)
    corners = np.unique(np.concatenate([block.nodes[:, :4].ravel() for block in mesh.blocks]))
    move = dice.uniform(-1, 1, mesh.x.shape) * amount
    some = np.setdiff1d(corners, keep)
    mesh.x[some] += move[some] * size[some, None]
    fixed = np.zeros(len(mesh.x), bool)
    fixed[keep] = True
    for block in mesh.blocks:
        for side in range(4):
            a, b, m = block.nodes[:, side], block.nodes[:, (side + 1) % 4], block.nodes[:, 4 + side]
            free = ~fixed[m]
            mesh.x[m[free]] = (mesh.x[a[free]] + mesh.x[b[free]]) / 2


def inside_out_elements(mesh):
    """Of each block, which elements have a point where they are inside out."""
    found = []
    for block in mesh.blocks:
        bad = np.zeros(len(block.nodes), bool)
        for _, _, weight in points_of(block.kind, mesh.x[block.nodes]):
            bad |= weight <= 0
        found.append(bad)
    return found
