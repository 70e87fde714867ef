# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: the normal at a node is the mean of the normals of the sides that meet there."""
import numpy as np


def averaged_normals(mesh, slaves, edges, by_length=False):
    """Unit normals [n, 2] at the slave nodes, out of the body."""
    total = {node: np.zeros(2) for node in slaves}
    for edge in edges:
        along = mesh.x[edge[1]] - mesh.x[edge[0]]
        length = np.hypot(*along)
        normal = np.array([along[1], -along[0]]) / length
        for node in edge[:2]:
            total[node] += normal * (length if by_length else 1.0)
        if edge[2] >= 0:
            total[edge[2]] += normal
    return np.array([total[node] / np.hypot(*total[node]) for node in slaves])


def spin(x, normals):
    """How far a turn by 1/R about the origin runs into the other body, over the same of a shift by 1: 0 for a
    round shaft."""
    radius = np.hypot(*x.T).max()
    turn = np.stack([-x[:, 1], x[:, 0]], 1) / radius
    return np.linalg.norm((normals * turn).sum(1)) / np.linalg.norm(normals[:, 0])
