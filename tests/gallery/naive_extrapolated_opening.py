# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: K from the opening of the faces behind the tip, drawn on to the tip, with elements that know nothing of the
root of r."""
import numpy as np


def apparent(mesh, u, face, tip, material):
    """Distances and K of v = 4 K / E' sqrt(r / 2 pi) at nodes of one face of a symmetric crack, nearest first."""
    r = np.hypot(*(mesh.x[face] - tip).T)
    order = np.argsort(r)
    r, v = r[order], u[2 * np.asarray(face)[order] + 1]
    return r, material.modulus() / 4 * np.sqrt(2 * np.pi / r) * v


def extrapolated(mesh, u, face, tip, material, nodes=6):
    """The line through the nearest nodes, the very nearest left out, at r = 0 (Chan, Tuba and Wilson 1970)."""
    r, K = apparent(mesh, u, face, tip, material)
    return np.polyfit(r[1:nodes], K[1:nodes], 1)[1]


def quarter_point_formula(mesh, u, face, tip, material):
    """4 v_B - v_C of the two nodes nearest to the tip, as if the first were at a quarter (Ingraffea and Manu
    1980)."""
    r = np.hypot(*(mesh.x[face] - tip).T)
    b, c = np.asarray(face)[np.argsort(r)[:2]]
    length = np.sort(r)[1]
    return material.modulus() / 4 * np.sqrt(2 * np.pi / length) * (4 * u[2 * b + 1] - u[2 * c + 1])
