# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: the gap between two round surfaces is measured on their straight-sided meshes."""
import numpy as np

from joint import contact_rows


def faceted(mesh, slaves, edges):
    """Rows and gaps along radial normals to the sides as they are drawn."""
    normals = mesh.x[slaves] / np.hypot(*mesh.x[slaves].T)[:, None]
    return contact_rows(mesh, slaves, normals, edges)
