# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: no contact at all; the pin's pressure is assumed, over the loaded half of the bore."""
import numpy as np


def cosine(force, radius):
    """2 F / (pi R) cos theta."""
    return lambda theta: 2.0 * force / (np.pi * radius) * max(0.0, np.cos(theta))


def uniform(force, radius):
    """F / (2 R)."""
    return lambda theta: force / (2.0 * radius) if abs(theta) < np.pi / 2 else 0.0
