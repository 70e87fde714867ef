# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of six-node triangles for the benchmarks, by gmsh from a .geo text of ours.

A mesh has nodes [n, 2] in mm and, for each body, triangles [k, 6]: three corners, then the middles
of the sides 1-2, 2-3, 3-1. Crack faces are doubled nodes; the tip is a rosette of quarter-point
triangles, as any careful analyst would make it by hand.
"""
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

SECTORS = 16  # triangles of a full rosette
SIDES = ((0, 1, 3), (1, 2, 4), (2, 0, 5))  # corner, corner, middle


@dataclass
class Mesh:
    nodes: np.ndarray
    bodies: dict = field(default_factory=dict)
    tips: list = field(default_factory=list)  # node numbers

    def freedoms(self):
        return 2 * len(self.nodes)

    def boundary(self, body):
        """Outer sides of a body: (triangle, side 0..2, corner, corner, middle)."""
        seen = {}
        triangles = self.bodies[body]
        for side, (i, j, m) in enumerate(SIDES):
            for k, t in enumerate(triangles):
                key = (min(t[i], t[j]), max(t[i], t[j]))
                seen.setdefault(key, []).append((k, side, t[i], t[j], t[m]))
        return [sides[0] for sides in seen.values() if len(sides) == 1]

    def circle(self, body, radius):
        """Outer sides of a body on the circle about the origin, as (triangle, side)."""
        r = np.hypot(self.nodes[:, 0], self.nodes[:, 1])
        on = np.abs(r - radius) < 1e-3
        return [(k, side) for k, side, a, b, _ in self.boundary(body) if on[a] and on[b]]


class Geo:
    """Collects the lines of a .geo file; every call gives the number of what it made."""

    def __init__(self):
        self.lines = ["Mesh.MeshSizeExtendFromBoundary = 0;", "Mesh.MeshSizeFromPoints = 0;",
                      "Mesh.ElementOrder = 2;", "Mesh.Algorithm = 6;", "Mesh.MshFileVersion = 2.2;"]
        self.count = 0

    def _add(self, text):
        self.count += 1
        self.lines.append(text.format(self.count))
        return self.count

    def point(self, x, y):
        return self._add(f"Point({{}}) = {{{{{x!r}, {y!r}, 0}}}};")

    def line(self, a, b):
        return self._add(f"Line({{}}) = {{{{{a}, {b}}}}};")

    def arc(self, a, centre, b):
        return self._add(f"Circle({{}}) = {{{{{a}, {centre}, {b}}}}};")

    def loop(self, curves):
        return self._add(f"Curve Loop({{}}) = {{{{{', '.join(map(str, curves))}}}}};")

    def surface(self, loops):
        return self._add(f"Plane Surface({{}}) = {{{{{', '.join(map(str, loops))}}}}};")

    def circle(self, centre, radius):
        """Four quarter arcs from angle 0; returns (arcs, points)."""
        p = [self.point(radius, 0.0), self.point(0.0, radius), self.point(-radius, 0.0),
             self.point(0.0, -radius)]
        return [self.arc(p[i], centre, p[(i + 1) % 4]) for i in range(4)], p

    def rosette(self, tip, radius, start, sectors):
        """Triangles round a tip; the angle runs from `start` anticlockwise over `sectors` of the 16.
        Returns (points on the rim, rim lines, spokes, surfaces)."""
        full = sectors == SECTORS
        angles = start + 2.0 * np.pi * np.arange(sectors + (0 if full else 1)) / SECTORS
        centre = self.point(*tip)
        rim = [self.point(tip[0] + radius * np.cos(t), tip[1] + radius * np.sin(t)) for t in angles]
        spokes = [self.line(centre, p) for p in rim]
        nxt = [(i + 1) % len(rim) for i in range(sectors)]
        sides = [self.line(rim[i], rim[nxt[i]]) for i in range(sectors)]
        faces = [self.surface([self.loop([spokes[i], sides[i], -spokes[nxt[i]]])])
                 for i in range(sectors)]
        self.lines.append(f"Transfinite Curve {{{', '.join(map(str, spokes + sides))}}} = 2;")
        return rim, sides, spokes, faces

    def body(self, name, surfaces):
        self.lines.append(f'Physical Surface("{name}") = {{{", ".join(map(str, surfaces))}}};')

    def edge(self, name, curve):
        self.lines.append(f'Physical Curve("{name}") = {{{curve}}};')

    def sizes(self, rules):
        for i, rule in enumerate(rules, 1):
            self.lines += [f"Field[{i}] = MathEval;", f'Field[{i}].F = "{rule}";']
        last = len(rules) + 1
        fields = ", ".join(str(i) for i in range(1, last))
        self.lines += [f"Field[{last}] = Min;", f"Field[{last}].FieldsList = {{{fields}}};",
                       f"Background Field = {last};"]

    def mesh(self, folder):
        geo, msh = Path(folder) / "mesh.geo", Path(folder) / "mesh.msh"
        geo.write_text("\n".join(self.lines) + "\n")
        subprocess.run(["gmsh", "-2", "-nt", "1", "-v", "1", geo, "-o", msh], check=True,
                       stdout=subprocess.DEVNULL)
        return read_msh(msh)


def read_msh(path):
    """Triangles of every physical surface of a version 2.2 file; nodes not used are dropped."""
    lines = Path(path).read_text().splitlines()
    at = {name: i for i, name in enumerate(lines) if name.startswith("$")}
    names = {}
    for line in lines[at["$PhysicalNames"] + 2:at["$EndPhysicalNames"]]:
        _, number, name = line.split()
        names[int(number)] = name.strip('"')
    table = np.array([line.split() for line in lines[at["$Nodes"] + 2:at["$EndNodes"]]], float)
    place = {int(label): i for i, label in enumerate(table[:, 0])}
    bodies = {}
    for line in lines[at["$Elements"] + 2:at["$EndElements"]]:
        f = [int(v) for v in line.split()]
        if f[1] == 9:  # six-node triangle
            bodies.setdefault(names[f[3]], []).append([place[v] for v in f[3 + f[2]:]])
    bodies = {name: np.array(t) for name, t in bodies.items()}
    used = np.unique(np.concatenate([t.ravel() for t in bodies.values()]))
    new = np.full(len(table), -1)
    new[used] = np.arange(len(used))
    return Mesh(table[used, 1:3], {name: new[t] for name, t in bodies.items()})


def open_crack(mesh, body, on_crack, side):
    """Doubles the nodes where on_crack(x, y) for the triangles of body with side(centre) > 0."""
    x, y = mesh.nodes.T
    triangles = mesh.bodies[body]
    doubled = np.intersect1d(np.flatnonzero(on_crack(x, y)), triangles)
    new = np.arange(len(mesh.nodes))
    new[doubled] = len(mesh.nodes) + np.arange(len(doubled))
    mesh.nodes = np.vstack([mesh.nodes, mesh.nodes[doubled]])
    centre = mesh.nodes[triangles[:, :3]].mean(axis=1)
    beyond = side(centre) > 0.0
    triangles[beyond] = new[triangles[beyond]]


def quarter_points(mesh, body, x, y):
    """Moves the middles next to the tip at (x, y) to a quarter of their side."""
    tip = int(np.argmin(np.hypot(mesh.nodes[:, 0] - x, mesh.nodes[:, 1] - y)))
    for i, j, m in SIDES:
        for a, b in ((i, j), (j, i)):
            t = mesh.bodies[body][mesh.bodies[body][:, a] == tip]
            mesh.nodes[t[:, m]] = 0.75 * mesh.nodes[tip] + 0.25 * mesh.nodes[t[:, b]]
    mesh.tips.append(tip)


def lug(folder, level, a, double):
    """Lug, sleeve (outer radius 36.042: the interference is in the mesh) and shaft; the load pulls
    along +x, cracks of length a run from the bore along +y, and along -y too when double."""
    e, back, bore, outer, inner = 86.5, -232.5, 36.0, 36.042, 30.0
    far, near, tip = 24.0 / 2.0 ** (0.75 * level), 6.0 / 2.0 ** level, 1.2 / 2.0 ** level
    geo = Geo()
    o = geo.point(0.0, 0.0)
    p = [geo.point(0.0, -e), geo.point(e, 0.0), geo.point(0.0, e), geo.point(back, e),
         geo.point(back, -e)]
    outline = [geo.arc(p[0], o, p[1]), geo.arc(p[1], o, p[2]), geo.line(p[2], p[3]),
               geo.line(p[3], p[4]), geo.line(p[4], p[0])]
    hole, mouth = geo.circle(o, bore)
    loops, faces, cuts = [geo.loop(outline), geo.loop(hole)], [], []
    ends = [1.0, -1.0] if double else [1.0]
    for s in ends:
        rim, sides, _, triangles = geo.rosette((0.0, s * (bore + a)), tip, -s * np.pi / 2.0, SECTORS)
        loops.append(geo.loop(sides))
        faces += triangles
        cuts.append(geo.line(mouth[1] if s > 0.0 else mouth[3], rim[0]))
    plate = geo.surface(loops)
    geo.lines.append(f"Curve {{{', '.join(map(str, cuts))}}} In Surface {{{plate}}};")
    geo.body("LUG", [plate] + faces)
    ring, _ = geo.circle(o, outer)
    ring_hole, _ = geo.circle(o, inner)
    geo.body("SLEEVE", [geo.surface([geo.loop(ring), geo.loop(ring_hole)])])
    disk, _ = geo.circle(o, inner)
    geo.body("SHAFT", [geo.surface([geo.loop(disk)])])
    first = tip * 2.0 * np.pi / SECTORS
    rules = [f"{far!r}"] + [f"{near!r}+0.3*Max(0,Abs(Sqrt(x^2+y^2)-{r})-{near!r})"
                            for r in (bore, inner)]
    rules += [f"{first!r}+0.3*Max(0,Sqrt(x^2+(y-({s * (bore + a)!r}))^2)-{tip!r})" for s in ends]
    geo.sizes(rules)
    mesh = geo.mesh(folder)
    for s in ends:
        open_crack(mesh, "LUG", lambda x, y, s=s: (np.abs(x) < 1e-7) & (s * y > bore - 1e-6) &
                   (s * y < bore + a - 1e-7), lambda c: c[:, 0])
        quarter_points(mesh, "LUG", 0.0, s * (bore + a))
    return mesh


def edge_strip(folder, level, a):
    """Upper half of a strip of width 1 and height 4 with an edge crack of length a from x = 0."""
    far, tip = 0.4 / 2.0 ** level, 0.04 / 2.0 ** level
    geo = Geo()
    rim, sides, _, faces = geo.rosette((a, 0.0), tip, 0.0, SECTORS // 2)
    p = [geo.point(1.0, 0.0), geo.point(1.0, 2.0), geo.point(0.0, 2.0), geo.point(0.0, 0.0)]
    outline = [geo.line(rim[0], p[0]), geo.line(p[0], p[1]), geo.line(p[1], p[2]),
               geo.line(p[2], p[3]), geo.line(p[3], rim[-1])] + [-s for s in reversed(sides)]
    geo.body("STRIP", [geo.surface([geo.loop(outline)])] + faces)
    first = tip * 2.0 * np.pi / SECTORS
    geo.sizes([f"{far!r}", f"{first!r}+0.35*Max(0,Sqrt((x-{a!r})^2+y^2)-{tip!r})"])
    mesh = geo.mesh(folder)
    quarter_points(mesh, "STRIP", a, 0.0)
    return mesh
