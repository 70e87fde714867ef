# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: node to segment in one pass. Each node of the one side is kept from passing through the other, nothing is
asked of the nodes of that other side, and the pressure is nodal force over nodal area."""
import numpy as np


def even_areas(mesh, slaves, edges):
    """Each side shared out evenly among the segments between its nodes: a middle node gets half of it."""
    area = {node: 0.0 for node in slaves}
    for edge in edges:
        nodes = edge[edge >= 0]
        order = nodes if len(nodes) == 2 else nodes[[0, 2, 1]]
        for a, b in zip(order, order[1:]):
            length = np.hypot(*(mesh.x[b] - mesh.x[a]))
            area[a] += length / 2
            area[b] += length / 2
    return np.array([area[node] for node in slaves])


def one_pass(joint, f, gap, area):
    """Displacements and pressures of the slave nodes."""
    u, force = joint.exact(f, gap)
    return u, force / area
