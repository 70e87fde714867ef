# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's lug on the very mesh that spricka solved, for the small program: lug, sleeve, shaft, contact rows at
the nodes of sleeve and shaft, normals radial, fits declared."""
import numpy as np
import scipy.sparse as sparse

from answers import Given, answer
from fracture import stress_intensities
from joint import Joint, consistent_matrix, contact_rows
from plane import Material, body_load, edge_load, solve, stiffness

R, INNER, BACK, F, FIT = 36.0, 30.0, -232.5, 97100.0 / 14.0, 0.042
A = 0.3 * R  # length of the crack in most scenes
KEPT = {}
PARTS = (Material(69800, 0.33), Material(206000, 0.32), Material(196000, 0.32))
# Two independent solvers, 1e-4: one crack and two, a/R = 0.3, all parts assembled at once.
SINGLE = {"PRESS": 229.705, "LOAD": 630.62}
DOUBLE = {"PRESS": 229.38, "LOAD": 664.467, "NO FIT": 758.551}


class Lug:
    """An increment of a run of the lug with all parts assembled at once."""

    def __init__(self, run, increment=1):
        given = Given(run, PARTS, increment)
        self.mesh, self.parts = given.mesh, given.parts
        edges, radius = self.mesh.edges(), np.hypot(*self.mesh.x.T)
        owner = np.full(len(self.mesh.x), -1)
        for part, blocks in enumerate(self.parts):
            for block in blocks:
                owner[block.nodes] = part

        def circle(part, r):
            on = (np.abs(radius - r) < 2e-3) & (owner == part)  # patches follow the curved sides, not the circle
            return edges[on[edges[:, 0]] & on[edges[:, 1]] & on[edges[:, 2]]]

        self.bore, self.skin = circle(0, R), circle(1, R)
        self.eye, self.pin = circle(1, INNER), circle(2, INNER)
        # the finer sides carry the rows: the bore, and the shaft
        self.walls, self.shaft = np.unique(self.bore), np.unique(self.pin)
        rows = []
        for slaves, sign, edges in ((self.walls, -1.0, self.skin), (self.shaft, 1.0, self.eye)):
            normals = sign * self.mesh.x[slaves] / radius[slaves, None]
            rows.append(contact_rows(self.mesh, slaves, normals, edges))
            assert len(rows[-1][1]) == len(slaves)
        self.slaves, self.sides = np.r_[self.walls, self.shaft], np.vstack([self.bore, self.pin])
        self.area = np.r_[consistent_matrix(self.mesh, self.walls, self.bore).sum(1),
                          consistent_matrix(self.mesh, self.shaft, self.pin).sum(1)]
        self.bush = np.arange(len(self.slaves)) < len(self.walls)
        self.owner = owner
        self.K = stiffness(self.mesh)
        self.held = freedoms = np.flatnonzero(np.repeat(np.abs(self.mesh.x[:, 0] - BACK) < 1e-6, 2))
        self.joint = Joint(self.K + self.rotations(), sparse.vstack([row[0] for row in rows]).tocsr(), freedoms)
        self.load = body_load(self.mesh, self.parts[2], (F, 0.0))

    def rotations(self):
        """Springs against rotations of sleeve and shaft, which nothing loads: they carry no force."""
        n = self.mesh.freedoms()
        total = sparse.csr_matrix((n, n))
        for part, blocks in ((1, self.parts[1]), (2, self.parts[2])):
            nodes = np.unique(np.concatenate([b.nodes.ravel() for b in blocks]))
            x = self.mesh.x[nodes]
            a, b = nodes[np.argmax(x[:, 0] - 10 * abs(x[:, 1]))], nodes[np.argmin(x[:, 0] + 10 * abs(x[:, 1]))]
            row = sparse.csr_matrix(([1.0, -1.0], ([0, 0], [2 * a + 1, 2 * b + 1])), (1, n))
            total = total + PARTS[part].E * (row.T @ row)
        return total

    def gap(self, fit=FIT):
        return np.where(self.bush, -fit, 0.0)

    def state(self, load=1.0, fit=FIT, may=None):
        """Displacements and contact forces, exact on this mesh."""
        return self.joint.exact(load * self.load, self.gap(fit), may)

    def K1(self, u, a):
        """Of the crack along +y, and its K2."""
        return stress_intensities(self.mesh, u, np.array([0.0, R + a]), (0.0, 1.0), (0.3 * a, 0.8 * a), self.parts[0])

    def lug_alone(self, pressure):
        """Displacements of the lug under a pressure(theta) on its bore, nothing else there."""
        f = edge_load(self.mesh, self.bore, lambda x, n: -pressure(np.arctan2(x[1], x[0])) * n)
        others = np.flatnonzero(self.owner != 0)
        return solve(self.K, f, np.r_[self.held, 2 * others, 2 * others + 1])

    def sleeve_forces(self):
        """Contact forces under load at the nodes of the sleeve, when those carry the rows: nodes, forces."""
        nodes = np.unique(self.skin)
        rows = [contact_rows(self.mesh, s, self.mesh.x[s] / np.hypot(*self.mesh.x[s].T)[:, None], edges)
                for s, edges in ((nodes, self.bore), (self.shaft, self.eye))]
        joint = Joint(self.K + self.rotations(), sparse.vstack([row[0] for row in rows]).tocsr(), self.held)
        fit = np.repeat((-FIT, 0.0), [len(row[1]) for row in rows])
        return nodes[rows[0][2]], joint.exact(self.load, fit)[1][:len(rows[0][1])]


def lug_of(program, name, increment=1, *definitions):
    """The small program's model on the mesh of a run, made once."""
    key = name, increment, definitions
    if key not in KEPT:
        KEPT[key] = Lug(answer(program, name, *definitions), increment)
    return KEPT[key]
