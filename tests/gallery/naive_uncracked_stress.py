# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: K from the stress that the uncracked body has where the tip will be, as for a crack at a free edge."""
import math


def edge_crack(stress, a):
    """1.12 s sqrt(pi a)."""
    return 1.12 * stress * math.sqrt(math.pi * a)
