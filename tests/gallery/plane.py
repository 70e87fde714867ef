# SPDX-License-Identifier: GPL-3.0-or-later
"""A small finite-element program of the plane, plain and open, under the naive methods of the gallery.

A mesh is nodes [n, 2] and blocks: a type, nodes of its elements [k, m], a material. Four-node and eight-node
quadrilaterals and six-node triangles; corners first, then the middles of the sides 1-2, 2-3, ... Thickness 1.
Freedom 2 i + d is direction d of node i.
"""
from dataclasses import dataclass, field

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg


@dataclass
class Material:
    E: float
    nu: float
    strain: bool = False  # plane strain, else plane stress

    def matrix(self):
        """Stress xx, yy, xy of strain xx, yy, 2 xy."""
        E, nu = (self.E / (1.0 - self.nu ** 2), self.nu / (1.0 - self.nu)) if self.strain else (self.E, self.nu)
        return E / (1.0 - nu * nu) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])

    def modulus(self):
        """E' of G = K^2 / E'."""
        return self.E / (1.0 - self.nu ** 2) if self.strain else self.E


@dataclass
class Block:
    kind: str
    nodes: np.ndarray
    material: Material


@dataclass
class Mesh:
    x: np.ndarray
    blocks: list = field(default_factory=list)

    def freedoms(self):
        return 2 * len(self.x)

    def edges(self):
        """Sides on the boundary [k, 3]: first corner, last corner, middle (-1 on linear sides), the body on the
        left of first to last."""
        seen = {}
        for block in self.blocks:
            corners = 3 if block.kind == "T6" else 4
            for side in range(corners):
                a, b = block.nodes[:, side], block.nodes[:, (side + 1) % corners]
                m = np.full(len(a), -1) if block.kind == "Q4" else block.nodes[:, corners + side]
                for edge in zip(a.tolist(), b.tolist(), m.tolist()):
                    seen.setdefault((min(edge[:2]), max(edge[:2])), []).append(edge)
        return np.array([found[0] for found in seen.values() if len(found) == 1])

    def edges_in(self, nodes):
        """Sides on the boundary whose nodes are all in a list."""
        edges, inside = self.edges(), np.zeros(len(self.x), bool)
        inside[nodes] = True
        return edges[inside[edges[:, 0]] & inside[edges[:, 1]]]


def gauss(order):
    x, w = np.polynomial.legendre.leggauss(order)
    return np.stack(np.meshgrid(x, x, indexing="ij"), -1).reshape(-1, 2), np.outer(w, w).ravel()


def triangle_points():
    """Seven points, degree 5 (Radon 1948)."""
    root = np.sqrt(15.0)
    points, weights = [(1 / 3, 1 / 3)], [9 / 80]
    for b, w in (((6 - root) / 21, (155 - root) / 2400), ((6 + root) / 21, (155 + root) / 2400)):
        points += [(b, b), (1 - 2 * b, b), (b, 1 - 2 * b)]
        weights += 3 * [w]
    return np.array(points), np.array(weights)


CORNERS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)


def shape_q4(p):
    f = 1 + CORNERS * p
    return f.prod(1) / 4, np.stack([CORNERS[:, 0] * f[:, 1], f[:, 0] * CORNERS[:, 1]], 1) / 4


def shape_q8(p):
    r, s = p
    N, dN = np.empty(8), np.empty((8, 2))
    for i, (a, b) in enumerate(CORNERS):
        N[i] = (1 + a * r) * (1 + b * s) * (a * r + b * s - 1) / 4
        dN[i] = a * (1 + b * s) * (2 * a * r + b * s) / 4, b * (1 + a * r) * (2 * b * s + a * r) / 4
    for i, (a, b) in enumerate(((0, -1), (1, 0), (0, 1), (-1, 0)), 4):
        if a == 0:
            N[i], dN[i] = (1 - r * r) * (1 + b * s) / 2, (-r * (1 + b * s), b * (1 - r * r) / 2)
        else:
            N[i], dN[i] = (1 - s * s) * (1 + a * r) / 2, (a * (1 - s * s) / 2, -s * (1 + a * r))
    return N, dN


def shape_t6(p):
    r, s = p
    t = 1 - r - s
    return (np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * r * t, 4 * r * s, 4 * s * t]),
            np.array([[1 - 4 * t, 1 - 4 * t], [4 * r - 1, 0], [0, 4 * s - 1], [4 * (t - r), -4 * r],
                      [4 * s, 4 * r], [-4 * s, 4 * (t - s)]]))


KINDS = {"Q4": (shape_q4, gauss(2)), "Q8": (shape_q8, gauss(3)), "T6": (shape_t6, triangle_points())}


def points_of(kind, x):
    """At the integration points of elements with corners x [k, m, 2]: N [m], gradients of N [k, m, 2], weight
    [k] in turn. A negative weight is an element inside out: nobody looks."""
    shape, (points, weights) = KINDS[kind]
    for p, w in zip(points, weights):
        N, dN = shape(p)
        J = np.einsum("kmi,mj->kij", x, dN)
        det = J[:, 0, 0] * J[:, 1, 1] - J[:, 0, 1] * J[:, 1, 0]
        inverse = np.stack([np.stack([J[:, 1, 1], -J[:, 0, 1]], 1),
                            np.stack([-J[:, 1, 0], J[:, 0, 0]], 1)], 1) / det[:, None, None]
        yield N, np.einsum("mj,kji->kmi", dN, inverse), w * det


def strain_matrix(gradient):
    """[k, 3, 2 m] of gradients [k, m, 2]."""
    k, m = gradient.shape[:2]
    B = np.zeros((k, 3, 2 * m))
    B[:, 0, 0::2] = B[:, 2, 1::2] = gradient[:, :, 0]
    B[:, 1, 1::2] = B[:, 2, 0::2] = gradient[:, :, 1]
    return B


def element_stiffness(kind, x, material):
    D = material.matrix()
    total = 0.0
    for _, gradient, weight in points_of(kind, x):
        B = strain_matrix(gradient)
        total = total + np.einsum("kai,ab,kbj,k->kij", B, D, B, weight, optimize=True)
    return total


def freedoms_of(nodes):
    """[k, 2 m] of nodes [k, m]."""
    return np.stack([2 * nodes, 2 * nodes + 1], -1).reshape(len(nodes), -1)


def stiffness(mesh):
    rows, columns, values = [], [], []
    for block in mesh.blocks:
        at = freedoms_of(block.nodes)
        rows.append(np.repeat(at, at.shape[1], axis=1).ravel())
        columns.append(np.tile(at, (1, at.shape[1])).ravel())
        values.append(element_stiffness(block.kind, mesh.x[block.nodes], block.material).ravel())
    n = mesh.freedoms()
    return sparse.csc_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (n, n))


def edge_quadrature(mesh, edge):
    """Nodes of a side, and at three Gauss points: N, place, tangent times weight."""
    quadratic = edge[2] >= 0
    nodes = edge if quadratic else edge[:2]
    result = []
    for t, w in zip(*np.polynomial.legendre.leggauss(3)):
        if quadratic:
            N, dN = np.array([t * (t - 1) / 2, t * (t + 1) / 2, 1 - t * t]), np.array([t - 0.5, t + 0.5, -2 * t])
        else:
            N, dN = np.array([(1 - t) / 2, (1 + t) / 2]), np.array([-0.5, 0.5])
        result.append((N, N @ mesh.x[nodes], w * (dN @ mesh.x[nodes])))
    return nodes, result


def edge_load(mesh, edges, traction):
    """Nodal forces of traction(place, outer normal) on sides."""
    f = np.zeros(mesh.freedoms())
    for edge in edges:
        nodes, points = edge_quadrature(mesh, edge)
        for N, place, along in points:
            length = np.hypot(*along)
            force = np.asarray(traction(place, np.array([along[1], -along[0]]) / length)) * length
            for node, value in zip(nodes, N):
                f[2 * node:2 * node + 2] += value * force
    return f


def body_load(mesh, blocks, total):
    """Nodal forces of a force that is spread evenly over blocks."""
    f, area = np.zeros(mesh.freedoms()), 0.0
    for block in blocks:
        for N, _, weight in points_of(block.kind, mesh.x[block.nodes]):
            area += weight.sum()
            for d in range(2):
                np.add.at(f, 2 * block.nodes + d, weight[:, None] * N * total[d])
    return f / area


def solve(K, f, held):
    """Displacements with some freedoms held at 0."""
    u = np.zeros(len(f))
    free = np.setdiff1d(np.arange(len(f)), held)
    u[free] = linalg.splu(K[free][:, free], permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                          options={"SymmetricMode": True}).solve(f[free])
    return u


def point_stress(mesh, u):
    """Places [n, 2] and stress xx, yy, xy [n, 3] at the integration points."""
    places, stress = [], []
    for block in mesh.blocks:
        x, v = mesh.x[block.nodes], u[freedoms_of(block.nodes)]
        for N, gradient, _ in points_of(block.kind, x):
            places.append(np.einsum("m,kmi->ki", N, x))
            stress.append(np.einsum("ab,kbj,kj->ka", block.material.matrix(), strain_matrix(gradient), v))
    return np.concatenate(places), np.concatenate(stress)


def nodal_stress(mesh, u):
    """Stress xx, yy, xy at nodes [n, 3]: taken at the nodes of each element and averaged."""
    places = {"Q4": CORNERS, "Q8": np.vstack([CORNERS, [(0, -1), (1, 0), (0, 1), (-1, 0)]]),
              "T6": np.array([(0, 0), (1, 0), (0, 1), (0.5, 0), (0.5, 0.5), (0, 0.5)])}
    total, count = np.zeros((len(mesh.x), 3)), np.zeros(len(mesh.x))
    for block in mesh.blocks:
        x, v = mesh.x[block.nodes], u[freedoms_of(block.nodes)]
        for i, p in enumerate(places[block.kind]):
            _, dN = KINDS[block.kind][0](p)
            J = np.einsum("kmi,mj->kij", x, dN)
            gradient = np.einsum("mj,kji->kmi", dN, np.linalg.inv(J))
            stress = np.einsum("ab,kbj,kj->ka", block.material.matrix(), strain_matrix(gradient), v)
            np.add.at(total, block.nodes[:, i], stress)
            np.add.at(count, block.nodes[:, i], 1)
    return total / np.maximum(count, 1)[:, None]
