# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: pressure from nodal forces by the consistent matrix, M p = f. It is right inside an even pressure and
swings where the pressure ends."""
import numpy as np

from joint import consistent_matrix


def consistent(mesh, slaves, edges, force):
    return np.linalg.solve(consistent_matrix(mesh, slaves, edges), force)


def lumped(mesh, slaves, edges, force):
    """Row sums of that matrix: what the paper uses, and what a node stands for."""
    return force / consistent_matrix(mesh, slaves, edges).sum(1)
