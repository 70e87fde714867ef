# SPDX-License-Identifier: GPL-3.0-or-later
"""A solid with a crack for CalculiX (ccx), on the very mesh that spricka made, and K1 along the front
by displacement extrapolation, as is usual where a program has no K of its own.
"""
import re
from pathlib import Path

import numpy as np

import measure

TYPES = {"TET10": "C3D10", "PENTAC15": "C3D15", "HEXEC20": "C3D20"}
# Corners of the faces of the types, and of those with four the middle nodes.
QUADRILATERALS = {
    "PENTAC15": (((0, 1, 4, 3), (6, 13, 9, 12)), ((1, 2, 5, 4), (7, 14, 10, 13)),
                 ((2, 0, 3, 5), (8, 12, 11, 14))),
    "HEXEC20": (((0, 1, 2, 3), (8, 9, 10, 11)), ((4, 5, 6, 7), (12, 13, 14, 15)),
                ((0, 1, 5, 4), (8, 17, 12, 16)), ((1, 2, 6, 5), (9, 18, 13, 17)),
                ((2, 3, 7, 6), (10, 19, 14, 18)), ((3, 0, 4, 7), (11, 16, 15, 19))),
}
TET_EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
TET_FACES = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3))
E, NU = 1000.0, 0.3


def tet_middles(x, nodes):
    """[element][TET_EDGES] the node in the middle of each edge, found by its place."""
    corners = nodes[:, :4]
    middle = np.empty((len(nodes), 6), dtype=int)
    for k, (i, j) in enumerate(TET_EDGES):
        place = 0.5 * (x[corners[:, i]] + x[corners[:, j]])
        away = np.linalg.norm(x[nodes[:, 4:]] - place[:, None, :], axis=2)
        middle[:, k] = nodes[np.arange(len(nodes)), 4 + np.argmin(away, axis=1)]
    return middle


def ties(elements, corners, middle):
    """Nodes in the middle of diagonals of quadrilaterals, as (node, corners, middles)."""
    edge = {}
    for k, (i, j) in enumerate(TET_EDGES):
        for a, b, m in zip(corners[:, i], corners[:, j], middle[:, k]):
            edge[min(a, b), max(a, b)] = m
    found = {}
    for name, nodes in elements:
        for face, mids in QUADRILATERALS.get(name, ()):
            for row in nodes:
                q = row[list(face)]
                for i, j in ((0, 2), (1, 3)):
                    key = (min(q[i], q[j]), max(q[i], q[j]))
                    if key in edge:
                        found[edge[key]] = (q, row[list(mids)])
    return found


def pull(x, corners, middle, half):
    """Consistent forces [node] along z of a unit traction on z = half, less those on z = -half."""
    force = np.zeros(len(x))
    edge_of = {frozenset(e): k for k, e in enumerate(TET_EDGES)}
    for side in (half, -half):
        for face in TET_FACES:
            tri = corners[:, face]
            for e in np.flatnonzero(np.all(np.abs(x[tri, 2] - side) < 1e-9 * half, axis=1)):
                a, b, c = x[tri[e]]
                area = 0.5 * np.linalg.norm(np.cross(b - a, c - a))
                for i, j in ((0, 1), (1, 2), (0, 2)):
                    m = middle[e, edge_of[frozenset((face[i], face[j]))]]
                    force[m] += np.sign(side) * area / 3.0
    return force


def faces_of_crack(x, used):
    """Pairs of nodes of z = 0 at one place: on the two faces of the crack."""
    flat = [n for n in used if abs(x[n, 2]) < 1e-9]
    places = {}
    for n in flat:
        places.setdefault((round(x[n, 0], 9), round(x[n, 1], 9)), []).append(n)
    return {place: nodes for place, nodes in places.items() if len(nodes) == 2}


def write(path, results):
    """The deck; returns what extrapolation needs: coordinates and the pairs of nodes."""
    x = results.mesh(1)["x"]
    half = np.abs(x).max()  # of the block
    elements = results.elements(1)
    tets = next(nodes for name, nodes in elements if name == "TET10")
    corners, middle = tets[:, :4], tet_middles(x, tets)
    used = np.unique(np.concatenate([nodes.ravel() for _, nodes in elements]))
    lines = ["*NODE, NSET=ALL"]  # ccx reads 20 characters of a number
    lines += [f"{n + 1},{x[n, 0]:.12g},{x[n, 1]:.12g},{x[n, 2]:.12g}" for n in used]
    number = 1
    for name, nodes in elements:
        rows = nodes if name != "TET10" else np.hstack([corners, middle])
        lines.append(f"*ELEMENT, TYPE={TYPES[name]}, ELSET=BODY")
        for row in rows:
            words = [str(number)] + [str(n + 1) for n in row]
            lines += [",".join(words[:11]) + ("," if len(words) > 11 else "")]
            lines += [",".join(words[11:])] if len(words) > 11 else []
            number += 1
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{E}, {NU}", "*SOLID SECTION, ELSET=BODY, MATERIAL=M"]
    for node, (q, mids) in ties(elements, corners, middle).items():
        for c in (1, 2, 3):
            terms = [(node, 1.0)] + [(n, 0.25) for n in q] + [(n, -0.5) for n in mids]
            lines += ["*EQUATION", str(len(terms))]
            words = [f"{n + 1},{c},{w}" for n, w in terms]
            lines += [",".join(words[k:k + 4]) for k in range(0, len(words), 4)]
    lines.append("*BOUNDARY")
    for place, last in (((-1, -1, -1), 1), ((1, -1, -1), 2), ((-1, 1, -1), 3)):
        n = used[np.argmin(np.linalg.norm(x[used] - half * np.array(place), axis=1))]
        lines.append(f"{n + 1},{last},3")
    pairs = faces_of_crack(x, used)
    lines += ["*NSET, NSET=FACES", *[f"{n + 1}," for pair in pairs.values() for n in pair]]
    lines += ["*STEP", "*STATIC", "*CLOAD"]
    force = pull(x, corners, middle, half)
    lines += [f"{n + 1},3,{force[n]:.12g}" for n in np.flatnonzero(force)]
    lines += ["*NODE PRINT, NSET=FACES", "U", "*END STEP"]
    Path(path).write_text("\n".join(lines) + "\n")
    return x, pairs


def run(folder, name):
    """(cost, {node: u}) of a deck NAME.inp."""
    cost = measure.run(["ccx", name], folder, f"{name}.log")
    moved = {}
    for line in (Path(folder) / f"{name}.dat").read_text().splitlines():
        if re.match(r"\s+\d+(\s+[-+.E\d]+){3}\s*$", line):
            words = line.split()
            moved[int(words[0]) - 1] = np.array([float(w) for w in words[1:]])
    return cost, moved


def extrapolated(points, out, pairs, moved):
    """K1 at points of the front [n, 3] with the directions `out` of growth: from the quarter point and
    the corner behind it, E'/8 sqrt(2 pi / r) times the opening, linear in r, at r = 0."""
    places = np.array(list(pairs))
    opening = np.array([abs(moved[a][2] - moved[b][2]) for a, b in pairs.values()])
    E_plane = E / (1.0 - NU * NU)
    K = []
    for p, m in zip(points[:, :2], out[:, :2]):
        d = places - p
        behind = -(d @ m)
        beside = np.abs(d @ np.array([-m[1], m[0]]))
        near = np.flatnonzero((behind > 1e-9) & (beside < 1e-3 * behind))
        first, second = near[np.argsort(behind[near])[:2]]
        r = behind[[first, second]]
        k = E_plane / 8.0 * np.sqrt(2.0 * np.pi / r) * opening[[first, second]]
        K.append(k[0] + (k[0] - k[1]) * r[0] / (r[1] - r[0]))
    return np.array(K)
