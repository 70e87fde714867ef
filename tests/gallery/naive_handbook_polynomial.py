# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: a polynomial from a handbook, used beyond the lengths it was fitted to."""
import numpy as np


def edge_crack_in_tension(x):
    """F of a/W = x, good to 0.5 % for x up to 0.6 (Gross 1964, Brown 1966; in the
    handbook of Tada, Paris and Irwin)."""
    return np.polyval([30.39, -21.72, 10.55, -0.231, 1.12], x)
