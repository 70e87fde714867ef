# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark problems for CalculiX (ccx): decks, runs, displacements.

Choices that make ccx as good as it can be: surface-to-surface contact with a stiffness of 1e7 N/mm^3
(softer falsifies K, harder does not converge), interference in the mesh (*CLEARANCE is 10 to 40 %
off on curved faces), a section thickness far below the tip element because its plane stress element
is a slab of one solid layer, and loads scaled to that thickness.
"""
import re
from pathlib import Path

import numpy as np

import measure

LUG_MATERIAL = {"LUG": (69800.0, 0.33), "SLEEVE": (206000.0, 0.32), "SHAFT": (196000.0, 0.32)}
STRIP_MATERIAL = (1000.0, 0.3)
THICKNESS = 0.14          # of the section; the lug is 14 mm thick
STRIP_THICKNESS = 1.0e-4
STIFFNESS = 1.0e7         # of the contact [N/mm^3]


class Deck:
    def __init__(self, mesh, element="CPS6"):
        self.mesh = mesh
        self.lines = ["*NODE, NSET=ALL"]
        self.lines += [f"{i},{x:.12g},{y:.12g},0." for i, (x, y) in enumerate(mesh.nodes, 1)]
        self.first = {}
        number = 1
        for name, triangles in mesh.bodies.items():
            self.first[name] = number
            self.lines.append(f"*ELEMENT, TYPE={element}, ELSET={name}")
            for t in triangles:
                self.lines.append(f"{number}," + ",".join(str(v + 1) for v in t))
                number += 1

    def add(self, *lines):
        self.lines += lines

    def section(self, body, material, thickness):
        self.add(f"*MATERIAL, NAME={body}", "*ELASTIC", f"{material[0]}, {material[1]}", "*DENSITY",
                 "1.", f"*SOLID SECTION, ELSET={body}, MATERIAL={body}", f"{thickness}")

    def node_set(self, name, nodes):
        self.add(f"*NSET, NSET={name}", *[f"{n + 1}," for n in nodes])

    def surface(self, name, body, sides):
        self.add(f"*SURFACE, NAME={name}",
                 *[f"{self.first[body] + k}, S{side + 1}" for k, side in sides])

    def node_at(self, body, x, y):
        corners = np.unique(self.mesh.bodies[body][:, :3])
        distance = np.hypot(self.mesh.nodes[corners, 0] - x, self.mesh.nodes[corners, 1] - y)
        return int(corners[np.argmin(distance)]) + 1

    def step(self, *loads):
        self.add("*STEP, INC=200", "*STATIC", "1., 1.", *loads, "*NODE PRINT, NSET=ALL", "U",
                 "*END STEP")


def lug_deck(mesh, stiffness=STIFFNESS):
    """Two steps: press fit, then the load as a body force of the shaft. No friction."""
    deck = Deck(mesh)
    for body, material in LUG_MATERIAL.items():
        deck.section(body, material, THICKNESS)
    for name, body, radius in (("BORE", "LUG", 36.0), ("OUTER", "SLEEVE", 36.042),
                               ("INNER", "SLEEVE", 30.0), ("PIN", "SHAFT", 30.0)):
        deck.surface(name, body, mesh.circle(body, radius))
    deck.add("*SURFACE INTERACTION, NAME=HARD", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
             f"{stiffness:g}, 1e-6")
    for slave, master in (("BORE", "OUTER"), ("INNER", "PIN")):
        deck.add("*CONTACT PAIR, INTERACTION=HARD, TYPE=SURFACE TO SURFACE", f"{slave}, {master}")
    deck.node_set("END", np.flatnonzero(mesh.nodes[:, 0] < -232.5 + 1e-6))
    deck.add("*BOUNDARY", "END, 1, 2")
    for body, radius in (("SLEEVE", 36.042), ("SHAFT", 30.0)):  # nothing else stops their rotation
        deck.add("*EQUATION", "2", f"{deck.node_at(body, radius, 0.0)}, 2, 1., "
                                   f"{deck.node_at(body, -radius, 0.0)}, 2, -1.")
    deck.step()
    force = 97100.0 / (np.pi * 30.0 ** 2 * 14.0)  # per volume
    deck.step("*DLOAD", f"SHAFT, GRAV, {force:.12g}, 1., 0., 0.")
    return deck


def strip_deck(mesh):
    """Half of the strip under unit tension; the line ahead of the crack is one of symmetry."""
    deck = Deck(mesh)
    deck.section("STRIP", STRIP_MATERIAL, STRIP_THICKNESS)
    x, y = mesh.nodes.T
    tip = mesh.nodes[mesh.tips[0], 0]
    deck.node_set("AHEAD", np.flatnonzero((np.abs(y) < 1e-9) & (x > tip - 1e-9)))
    deck.add("*BOUNDARY", "AHEAD, 2, 2", f"{deck.node_at('STRIP', 1.0, 0.0)}, 1, 1")
    top = [(k, side) for k, side, a, b, _ in mesh.boundary("STRIP") if min(y[a], y[b]) > 2.0 - 1e-9]
    deck.step("*DLOAD", *[f"{1 + k}, P{side + 1}, -1." for k, side in top])
    return deck


def displacements(path, nodes):
    """Blocks of the .dat file as (time, u [n, 2]), in the order of the increments."""
    blocks = []
    for line in Path(path).read_text().splitlines():
        head = re.match(r"\s*displacements .* time\s+(\S+)", line)
        if head:
            blocks.append((float(head.group(1)), np.zeros((nodes, 2))))
            continue
        fields = line.split()
        if len(fields) == 4 and fields[0].isdigit() and int(fields[0]) <= nodes:
            blocks[-1][1][int(fields[0]) - 1] = [float(fields[1]), float(fields[2])]
    return blocks


def solve(deck, folder):
    """Runs ccx; returns (cost, [displacement at the end of each step], facts from its log).
    The state of a step is that of its last increment: with stiff contact ccx accepts wrong
    increments on the way."""
    folder = Path(folder)
    (folder / "job.inp").write_text("\n".join(deck.lines) + "\n")
    for old in folder.glob("job.[!i]*"):
        old.unlink()
    cost = measure.run(["ccx", "-i", "job"], folder, "ccx.log")
    log = (folder / "ccx.log").read_text(errors="replace")
    equations = [int(v) for v in re.findall(r"number of equations\s+(\d+)", log)]
    facts = {"equations": max(equations, default=0),
             "iterations": len(re.findall(r"^\s*iteration\s+\d+", log, re.MULTILINE))}
    ends = {}
    if (folder / "job.dat").exists():
        for time, u in displacements(folder / "job.dat", len(deck.mesh.nodes)):
            ends[int(np.ceil(time - 1e-9))] = u
    return cost, [ends[step] for step in sorted(ends)], facts
