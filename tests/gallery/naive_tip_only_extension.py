# SPDX-License-Identifier: GPL-3.0-or-later
"""Naive: virtual crack extension that moves the tip's node and nothing else, by a step that somebody chose."""
import numpy as np

from fracture import extension


def tip_move(mesh, tip, ahead, following):
    """Motion of nodes: the tip, and where `following` the middles beside it, which stay at the quarter (moving by
    three quarters of the tip's way)."""
    move = np.zeros_like(mesh.x)
    move[tip] = ahead
    for block in mesh.blocks if following else ():
        corners = 3 if block.kind == "T6" else 4
        for side in range(corners):
            a, b = block.nodes[:, side], block.nodes[:, (side + 1) % corners]
            beside = block.nodes[(a == tip) | (b == tip), corners + side]
            move[beside] = 0.75 * np.asarray(ahead, float)
    return move


def tip_only(mesh, u, tip, ahead, step, following=True):
    """Energy release rate."""
    return extension(mesh, u, tip_move(mesh, tip, ahead, following), step)
