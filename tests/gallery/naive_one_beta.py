# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: one beta, K in proportion to the load, so that a load that goes down to zero takes K down to zero."""
import numpy as np


def paris_life(a, swing, C, m):
    """Cycles of da/dN = C dK^m over lengths a with dK between them as a power of a."""
    total = 0.0
    for a0, a1, k0, k1 in zip(a, a[1:], swing, swing[1:]):
        q = np.log(k1 / k0) / np.log(a1 / a0)
        rate = 1.0 - m * q
        total += (a1 / k1 ** m - a0 / k0 ** m) / rate
    return total / C


def one_beta(a, largest, C, m):
    """Cycles between zero and full load with K of full load as the swing."""
    return paris_life(a, largest, C, m)
