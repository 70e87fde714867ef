# SPDX-License-Identifier: GPL-3.0-or-later
"""K1 and K2 from nodal displacements by the interaction integral, plane stress, six-node triangles.

Yau, Wang and Corten 1980: with the fields of a unit K of one mode as auxiliary state,
    I = int (s_ij ua_i,1 + sa_ij u_i,1 - s_ij ea_ij delta_1j) q,j dA,    K = E I / 2,
where q falls from 1 to 0 between two circles about the tip.
"""
import numpy as np


def gauss7():
    """Points [7, 2] and weights [7] on the unit triangle, exact to degree 5 (Radon 1948)."""
    root = np.sqrt(15.0)
    b1, b2 = (6.0 - root) / 21.0, (6.0 + root) / 21.0
    points = [(1.0 / 3.0, 1.0 / 3.0)]
    for b in (b1, b2):
        points += [(b, b), (1.0 - 2.0 * b, b), (b, 1.0 - 2.0 * b)]
    weights = [9.0 / 80.0] + 3 * [(155.0 - root) / 2400.0] + 3 * [(155.0 + root) / 2400.0]
    return np.array(points), np.array(weights)


def shape(r, s):
    """N [6] and its gradient [6, 2] on the unit triangle."""
    t = 1.0 - r - s
    N = np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * r * t, 4 * r * s, 4 * s * t])
    dN = np.array([[1 - 4 * t, 1 - 4 * t], [4 * r - 1, 0], [0, 4 * s - 1],
                   [4 * (t - r), -4 * r], [4 * s, 4 * r], [-4 * s, 4 * (t - s)]])
    return N, dN


def unit_fields(mode, x, E, nu):
    """Stress [k, 2, 2] and displacement gradient [k, 2, 2] of K = 1 at x [k, 2] from the tip, crack
    along -x1 (Williams 1957), plane stress."""
    r, t = np.hypot(*x.T), np.arctan2(x[:, 1], x[:, 0])
    mu, kappa = E / (2.0 * (1.0 + nu)), (3.0 - nu) / (1.0 + nu)
    c, s, c3, s3 = np.cos(t / 2), np.sin(t / 2), np.cos(1.5 * t), np.sin(1.5 * t)
    f = 1.0 / np.sqrt(2.0 * np.pi * r)
    if mode == 1:
        s11, s22, s12 = c * (1 - s * s3), c * (1 + s * s3), s * c * c3
        u = np.array([c * (kappa - np.cos(t)), s * (kappa - np.cos(t))])
        du = np.array([-s / 2 * (kappa - np.cos(t)) + c * np.sin(t),
                       c / 2 * (kappa - np.cos(t)) + s * np.sin(t)])
    else:
        s11, s22, s12 = -s * (2 + c * c3), s * c * c3, c * (1 - s * s3)
        u = np.array([s * (kappa + 2 + np.cos(t)), -c * (kappa - 2 + np.cos(t))])
        du = np.array([c / 2 * (kappa + 2 + np.cos(t)) - s * np.sin(t),
                       s / 2 * (kappa - 2 + np.cos(t)) + c * np.sin(t)])
    stress = np.moveaxis(np.array([[f * s11, f * s12], [f * s12, f * s22]]), 2, 0)
    # u_i = sqrt(r / 2 pi) / (2 mu) u(t): by r and t, then by x1 and x2
    scale = f / (2.0 * mu)
    by_1 = scale * (0.5 * np.cos(t) * u - np.sin(t) * du)
    by_2 = scale * (0.5 * np.sin(t) * u + np.cos(t) * du)
    return stress, np.moveaxis(np.array([by_1, by_2]), (0, 1, 2), (2, 1, 0))


def stress_intensities(nodes, triangles, u, tip, direction, material, radii):
    """(K1, K2) at the point tip with the crack ahead along `direction`; u [n, 2]."""
    E, nu = material
    ahead = np.asarray(direction, float) / np.hypot(*direction)
    turn = np.array([ahead, [-ahead[1], ahead[0]]])  # rows: local axes
    x = (nodes - tip) @ turn.T
    v = u @ turn.T
    q = np.clip((radii[1] - np.hypot(*x.T)) / (radii[1] - radii[0]), 0.0, 1.0)
    t = triangles[np.ptp(q[triangles], axis=1) > 0.0]
    C = E / (1.0 - nu * nu) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    result = [0.0, 0.0]
    points, weights = gauss7()
    for (r, s), w in zip(points, weights):
        N, dN = shape(r, s)
        J = np.einsum("kai,aj->kij", x[t], dN)
        grad = np.einsum("aj,kji->kai", dN, np.linalg.inv(J))
        H = np.einsum("kai,kaj->kij", v[t], grad)  # u_i,j
        e = np.stack([H[:, 0, 0], H[:, 1, 1], H[:, 0, 1] + H[:, 1, 0]], axis=1) @ C
        S = np.moveaxis(np.array([[e[:, 0], e[:, 2]], [e[:, 2], e[:, 1]]]), 2, 0)
        dq = np.einsum("ka,kaj->kj", q[t], grad)
        at = np.einsum("a,kai->ki", N, x[t])
        dA = w * np.linalg.det(J)
        for mode in (1, 2):
            Sa, Ha = unit_fields(mode, at, E, nu)
            flow = (np.einsum("kij,ki,kj->k", S, Ha[:, :, 0], dq) +
                    np.einsum("kij,ki,kj->k", Sa, H[:, :, 0], dq) -
                    np.einsum("kij,kij->k", S, Ha) * dq[:, 0])
            result[mode - 1] += 0.5 * E * float(np.sum(flow * dA))
    return tuple(result)
