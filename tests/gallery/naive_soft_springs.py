# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: a body that only contact holds gets weak springs to the ground, so that the matrix can be solved; and a body
that nothing holds is solved as it is."""
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg


def grounded(K, freedoms, spring):
    """Stiffness with a spring to the ground at each freedom."""
    add = np.zeros(K.shape[0])
    add[freedoms] = spring
    return (K + sparse.diags(add)).tocsc()


def solved_anyway(K, f):
    """Displacements of a body without supports: round-off stands in for them."""
    return linalg.splu(K).solve(f)
