# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: friction without a history. Shear follows from the loads of the moment alone, as if they had come in one
go; what was locked in on the way is not known.

Two equal cylinders, strips of even shear on a half-plane (Johnson 1985, 2.3): shear |q| <= mu p, no relative motion
where it sticks.
"""
import numpy as np


def strips(a, n):
    """Middles, width, and relative tangential displacement by shear 1 on each strip, times the modulus E*."""
    edges = np.linspace(-a, a, n + 1)
    x, h = (edges[1:] + edges[:-1]) / 2, edges[1] - edges[0]

    def antiderivative(s):
        return s * np.log(np.abs(s)) - s

    d = x[:, None] - x[None, :]
    return x, h, -2 / np.pi * (antiderivative(d + h / 2) - antiderivative(d - h / 2))


def partial_slip(A, h, limit, Q, before=0.0, locked=0.0):
    """Shear of a tangential force Q, |q| <= limit, strips that stick keep the shift `before` of theirs but for one
    shift of all; `locked` is the shear they began with."""
    n = len(limit)
    stuck, sign = np.ones(n, bool), np.ones(n)
    for _ in range(n):
        q = np.where(stuck, 0.0, sign * limit)
        k = stuck.sum()
        M = np.zeros((k + 1, k + 1))
        M[:k, :k] = A[np.ix_(stuck, stuck)]
        M[:k, k] = -1.0
        M[k, :k] = h
        rest = np.zeros(n) + before
        right = np.r_[(rest - A @ q)[stuck], Q - h * q.sum()]
        q[stuck] = np.linalg.solve(M, right)[:k]
        over = stuck & (np.abs(q) > limit)
        if not over.any():
            return q
        sign[over] = np.sign(q[over])
        stuck &= ~over
    return q
