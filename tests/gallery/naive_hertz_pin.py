# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: a pin in a hole as two cylinders that touch along a line (Hertz 1882)."""
import numpy as np


def hertz(clearance):
    """Half the angle in degrees (None beyond 90) and the largest pressure times R / Q, of E dR / Q; one material,
    plane stress."""
    width = np.sqrt(4 / (np.pi * clearance / 2))  # a / R: 1/R1 - 1/R2 = dR/R^2, E* = E/2
    return (np.degrees(np.arcsin(width)) if width <= 1 else None), 2 / (np.pi * width)
