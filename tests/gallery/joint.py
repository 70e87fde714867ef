# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that meet: rows of contact at the nodes of one side, and the exact solution of them, with which a naive
one is compared on the same mesh.

A row says how far a slave node comes towards the other side, G u <= gap. All that follows works on the rows only:
the stiffness with stiff rows added holds all bodies and is factorised once, and what was added is taken out again.
"""
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

from plane import edge_quadrature


def on_edge(mesh, edge, t):
    """Shape functions of a side at t in [-1, 1] for its nodes first, last, middle."""
    if edge[2] < 0:
        return edge[:2], np.array([(1 - t) / 2, (1 + t) / 2])
    return edge, np.array([t * (t - 1) / 2, t * (t + 1) / 2, 1 - t * t])


def hit(mesh, edges, place, normal):
    """Where the line from `place` along `normal` meets one of the sides: nodes, weights, distance."""
    best = None
    across = np.array([-normal[1], normal[0]])
    for edge in edges:
        ends = (mesh.x[edge[:2]] - place) @ across
        if min(ends) > 1e-6 * np.ptp(ends) or max(ends) < -1e-6 * np.ptp(ends):
            continue
        t = -ends.sum() / (ends[1] - ends[0])
        for _ in range(20):
            nodes, N = on_edge(mesh, edge, t)
            slope = (on_edge(mesh, edge, t + 1e-6)[1] - on_edge(mesh, edge, t - 1e-6)[1]) / 2e-6
            t -= (N @ (mesh.x[nodes] - place) @ across) / (slope @ (mesh.x[nodes] @ across))
        nodes, N = on_edge(mesh, edge, np.clip(t, -1, 1))
        distance = N @ (mesh.x[nodes] - place) @ normal
        if best is None or abs(distance) < abs(best[2]):
            best = nodes, N, distance
    return best


def contact_rows(mesh, slaves, normals, edges):
    """One row for each slave node that meets a side of the other body: G [m, n], gap measured along the normal
    [m], which of the slaves have one."""
    rows, columns, values, gaps, used = [], [], [], [], []
    for i, (node, normal) in enumerate(zip(slaves, normals)):
        found = hit(mesh, edges, mesh.x[node], normal)
        if found is None:
            continue
        nodes, N, distance = found
        for at, weight in [(node, 1.0)] + [(m, -v) for m, v in zip(nodes, N)]:
            rows += 2 * [len(gaps)]
            columns += [2 * at, 2 * at + 1]
            values += list(weight * normal)
        gaps.append(distance)
        used.append(i)
    G = sparse.csr_matrix((values, (rows, columns)), (len(gaps), mesh.freedoms()))
    return G, np.array(gaps), np.array(used)


def consistent_matrix(mesh, slaves, edges):
    """Matrix of the pressure's nodal forces, f = M p, on sides of the slave (paper's equation 8)."""
    at = {node: i for i, node in enumerate(slaves)}
    M = np.zeros((len(slaves), len(slaves)))
    for edge in edges:
        nodes, points = edge_quadrature(mesh, edge)
        here = [at[node] for node in nodes]
        for N, _, along in points:
            M[np.ix_(here, here)] += np.outer(N, N) * np.hypot(*along)
    return M


class Joint:
    """Bodies with rows of contact between them; `held` are freedoms that do not move."""

    def __init__(self, K, G, held):
        self.n = K.shape[0]
        self.free = np.setdiff1d(np.arange(self.n), held)
        self.G = G[:, self.free]
        self.stiff = 0.1 * abs(K.diagonal()).max()
        whole = (K[self.free][:, self.free] + self.stiff * (self.G.T @ self.G)).tocsc()
        self.factor = linalg.splu(whole, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                                  options={"SymmetricMode": True})
        self.C = self.G @ self.factor.solve(self.G.T.toarray())

    def respond(self, f, w, force):
        """Displacements of the loads and of the contact forces, G u = w."""
        u = np.zeros(self.n)
        u[self.free] = self.factor.solve(f[self.free] + self.G.T @ (self.stiff * w - force))
        return u

    def exact(self, f, gap, may=None):
        """Displacements and contact forces >= 0 of all rows, or of those that may carry: primal-dual active set."""
        m = len(gap)
        may = np.ones(m, bool) if may is None else may
        d = self.G @ self.factor.solve(f[self.free])
        closed, seen = may.copy(), []
        for _ in range(100):
            # unknown is the force of a closed row, the motion of an open one
            A = np.eye(m) - self.stiff * self.C
            left = np.where(closed, self.C, A)
            z = np.linalg.solve(left, d - A[:, closed] @ gap[closed])
            force, w = np.where(closed, z, 0.0), np.where(closed, gap, z)
            tiny = 1e-12 * abs(force).max()
            new = may & np.where(closed, force > -tiny, w > gap)
            if (new == closed).all():
                return self.respond(f, w, force), force
            if any((new == old).all() for old in seen):  # one row at a time from here: this ends
                worst = np.argmax(np.where(new != closed, np.maximum(-force / (abs(force).max() or 1),
                                                                     (w - gap) / (abs(w - gap).max() or 1)), -1))
                new = closed.copy()
                new[worst] = ~closed[worst]
            seen.append(closed)
            closed = new
        raise RuntimeError("the active set does not settle")
