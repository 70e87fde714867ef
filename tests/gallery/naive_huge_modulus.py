# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: what is to be rigid gets a huge modulus, and all is solved in one matrix."""
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg


def pressed_by_stiff(pair, K, G, free):
    """Displacements and contact forces of a pair whose rows are all closed, by multipliers in one factorisation."""
    system = sparse.bmat([[K[free][:, free], G[:, free].T], [G[:, free], None]]).tocsc()
    solution = linalg.splu(system).solve(np.r_[pair.f[free], pair.gap])
    u = np.zeros(len(pair.f))
    u[free] = solution[:len(free)]
    return u, solution[len(free):]
