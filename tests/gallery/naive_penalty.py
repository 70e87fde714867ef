# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: contact by springs. Every slave node that has come too far is pushed back by a stiffness times area times
penetration; somebody has to choose the stiffness, and it has a unit."""
import numpy as np


def penalty(joint, f, gap, area, stiffness, iterations=40):
    """Displacements, forces, and the number of iterations, or None for it where the status of nodes still changes.

    Open and closed are looked at after each solution, as the contact iterations of a program do it."""
    spring = stiffness * area
    d = joint.G @ joint.factor.solve(f[joint.free])
    base = np.eye(len(gap)) - joint.stiff * joint.C
    closed = np.ones(len(gap), bool)
    for count in range(1, iterations + 1):
        k = np.where(closed, spring, 0.0)
        w = np.linalg.solve(base + joint.C * k, d + joint.C @ (k * gap))
        new = w > gap
        if (new == closed).all():
            break
        closed = new
    else:
        count = None
    force = k * (w - gap)
    return joint.respond(f, w, force), force, count
