# SPDX-License-Identifier: GPL-3.0-or-later
"""K of displacements: by the interaction integral (the fair reader of a naive solution) and by virtual crack
extension with a finite shift, for whichever nodes move."""
import numpy as np

from plane import element_stiffness, freedoms_of, points_of


def unit_fields(mode, x, material):
    """Stress [k, 2, 2] and displacement gradient [k, 2, 2] of K = 1 at x [k, 2] from a tip, crack along -x1
    (Williams 1957)."""
    nu = material.nu
    mu = material.E / (2 * (1 + nu))
    kappa = 3 - 4 * nu if material.strain else (3 - nu) / (1 + nu)
    r, t = np.hypot(*x.T), np.arctan2(x[:, 1], x[:, 0])
    c, s, c3, s3 = np.cos(t / 2), np.sin(t / 2), np.cos(1.5 * t), np.sin(1.5 * t)
    if mode == 1:
        stress = np.array([[c * (1 - s * s3), s * c * c3], [s * c * c3, c * (1 + s * s3)]])
        v = np.array([c, s]) * (kappa - np.cos(t))
        dv = np.array([-s, c]) / 2 * (kappa - np.cos(t)) + np.array([c, s]) * np.sin(t)
    else:
        stress = np.array([[-s * (2 + c * c3), c * (1 - s * s3)], [c * (1 - s * s3), s * c * c3]])
        v = np.array([s * (kappa + 2 + np.cos(t)), -c * (kappa - 2 + np.cos(t))])
        dv = np.array([c / 2 * (kappa + 2 + np.cos(t)) - s * np.sin(t),
                       s / 2 * (kappa - 2 + np.cos(t)) + c * np.sin(t)])
    scale = 1 / np.sqrt(2 * np.pi * r)
    by_r, by_t = v / 2, dv
    gradient = np.array([by_r * np.cos(t) - by_t * np.sin(t), by_r * np.sin(t) + by_t * np.cos(t)])
    return np.moveaxis(stress * scale, 2, 0), np.transpose(gradient * scale / (2 * mu), (2, 1, 0))


def stress_intensities(mesh, u, tip, ahead, radii, blocks=None):
    """K1, K2 at the place `tip` of a straight crack with free faces, `ahead` its direction; the domain lies
    between the radii (Yau, Wang and Corten 1980). A half model gives half of K1."""
    ahead = np.asarray(ahead, float) / np.hypot(*ahead)
    turn = np.array([ahead, [-ahead[1], ahead[0]]])
    weight = np.clip((radii[1] - np.hypot(*(mesh.x - tip).T)) / (radii[1] - radii[0]), 0, 1)
    found = np.zeros(2)
    for block in blocks or mesh.blocks:
        q = weight[block.nodes]
        some = np.ptp(q, axis=1) > 0
        nodes, D = block.nodes[some], block.material.matrix()
        if not len(nodes):
            continue
        x = (mesh.x[nodes] - tip) @ turn.T
        v = u[freedoms_of(nodes)].reshape(len(nodes), -1, 2) @ turn.T
        for N, gradient, w in points_of(block.kind, x):
            du = np.einsum("kmi,kmj->kij", v, gradient)
            e = np.stack([du[:, 0, 0], du[:, 1, 1], du[:, 0, 1] + du[:, 1, 0]], 1) @ D
            s = np.stack([np.stack([e[:, 0], e[:, 2]], 1), np.stack([e[:, 2], e[:, 1]], 1)], 1)
            dq = np.einsum("km,kmj->kj", q[some], gradient)
            for mode in (1, 2):
                sa, da = unit_fields(mode, np.einsum("m,kmi->ki", N, x), block.material)
                flux = np.einsum("kij,ki->kj", s, da[:, :, 0]) + np.einsum("kij,ki->kj", sa, du[:, :, 0])
                flux[:, 0] -= np.einsum("kij,kij->k", s, da)
                found[mode - 1] += block.material.modulus() / 2 * np.einsum("kj,kj,k->", flux, dq, w)
    return found


def extension(mesh, u, move, step):
    """Energy release rate by a finite virtual crack extension (Parks 1974, Hellen 1975): `move` [n, 2] is how
    nodes go along with a tip that moves by 1, `step` how far it is moved. Displacements stay what they are."""
    total = 0.0
    for block in mesh.blocks:
        some = np.abs(move[block.nodes]).max((1, 2)) > 0
        nodes = block.nodes[some]
        if len(nodes):
            before = element_stiffness(block.kind, mesh.x[nodes], block.material)
            after = element_stiffness(block.kind, mesh.x[nodes] + step * move[nodes], block.material)
            v = u[freedoms_of(nodes)]
            total += np.einsum("ki,kij,kj->", v, after - before, v)
    return -total / (2 * step)


def ring_move(mesh, tip, ahead, inner, outer):
    """All within `inner` go along, beyond `outer` none."""
    weight = np.clip((outer - np.hypot(*(mesh.x - tip).T)) / (outer - inner), 0, 1)
    return weight[:, None] * np.asarray(ahead, float)
