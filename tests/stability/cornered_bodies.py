# SPDX-License-Identifier: GPL-3.0-or-later
"""Cracked bodies whose stresses have no bound elsewhere too: ends of supports, re-entrant corners, ends of
material borders, edges of punches. Each body is a polygon that gmsh meshes; `sharp` marks its singular
points, towards which the mesh of the truth is graded."""
import math

TYPES = ("TRIMC6", "QUAMC8", "QUAMC9")
HEAD = "$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='Sharp body, elements {}'\n"


class Body:
    """Points (x, y), which of them are sharp, lines (from, to, set) and surfaces (set, numbers of lines)."""

    def __init__(self, points, sharp, lines, surfaces):
        self.points, self.sharp, self.lines, self.surfaces = points, sharp, lines, surfaces

    def geo(self, sizes, host):
        text = [f"Point({i + 1}) = {{{x:.17g}, {y:.17g}, 0, {h:.6g}}};"
                for i, ((x, y), h) in enumerate(zip(self.points, sizes))]
        text += [f"Line({i + 1}) = {{{a + 1}, {b + 1}}};" for i, (a, b, _) in enumerate(self.lines)]
        for i, (name, lines) in enumerate(self.surfaces):
            text.append(f"Curve Loop({i + 1}) = {{{', '.join(str(n) for n in lines)}}};")
            text.append(f"Plane Surface({i + 1}) = {{{i + 1}}};")
            text.append(f'Physical Surface("{name}") = {{{i + 1}}};')
        for name in sorted({name for _, _, name in self.lines if name}):
            members = ", ".join(str(i + 1) for i, line in enumerate(self.lines) if line[2] == name)
            text.append(f'Physical Curve("{name}") = {{{members}}};')
        text += ["Mesh.ElementOrder = 2;", "Mesh.MeshSizeExtendFromBoundary = 1;",
                 f"Mesh.SecondOrderIncomplete = {int(host == 'QUAMC8')};"]
        if host != "TRIMC6":
            text += ["Mesh.RecombineAll = 1;", "Mesh.RecombinationAlgorithm = 1;"]
        return "\n".join(text) + "\n"

    def by_chance(self, h, dice, host):
        return self.geo([h * math.exp(dice.uniform(-0.4, 0.4)) for _ in self.points], host)

    def graded(self, h):
        """Elements that shrink towards the sharp points, to a thousandth."""
        text = self.geo([h for _ in self.points], "TRIMC6")
        text += "Mesh.MeshSizeFromPoints = 0;\nMesh.MeshSizeExtendFromBoundary = 0;\n"
        for i, n in enumerate(self.sharp):
            x, y = self.points[n]
            text += f'Field[{i + 1}] = MathEval;\nField[{i + 1}].F = "{1e-3 * h} + 0.25*Sqrt((x-({x}))^2+(y-({y}))^2)";\n'
        count = len(self.sharp)
        text += f'Field[{count + 1}] = MathEval;\nField[{count + 1}].F = "{h}";\nField[{count + 2}] = Min;\n'
        text += f"Field[{count + 2}].FieldsList = {{{', '.join(str(i + 1) for i in range(count + 1))}}};\n"
        return text + f"Background Field = {count + 2};\n"


def polygon(points, sharp, names):
    """A body of one surface; names [line], from each point to the next."""
    count = len(points)
    lines = [(i, (i + 1) % count, names[i]) for i in range(count)]
    return Body(points, sharp, lines, [("BODY", list(range(1, count + 1)))])


def material(E, nu, state, name="M", eset="BODY"):
    return f"$MATERIAL NAME={name} E={E} NU={nu}\n$PROPERTY ESET={eset} MATERIAL={name} STATE={state}\n"


def held(where, dof="XY"):
    return f"$FREEDOM CLASS=SUPPRESSED DOF={dof}\n  {where}\n"


def crack(x, y, a, angle):
    """From (x, y), by degrees against x."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return f"$CRACK NAME=C\n  {x}  {y}\n  {x + a * c:.17g}  {y + a * s:.17g}\n"


def pulled(*tractions):
    lines = "".join(f"  {where}  {x}  {y}\n" for where, x, y in tractions)
    return f"$LOAD CASE=T TYPE=TRACTION\n{lines}$STEP NAME=S\n  LOAD T 1\n"


def rectangle(width, height, sharp=()):
    return polygon([(0, 0), (width, 0), (width, height), (0, height)], sharp, ["SOUTH", "EAST", "NORTH", "WEST"])


def clamped(case):
    """A plate between clamped ends of which one is moved, or a cantilever; an edge crack."""
    kind, height, y0, a, angle, nu, state = case
    body = rectangle(1, height, (0, 1) if kind == "arm" else (0, 1, 2, 3))
    text = material(1000, nu, state) + held("SOUTH") + crack(0, y0, a, angle)
    if kind == "arm":
        return body, text + pulled(("NORTH", 0.3, 1)), a
    return body, text + ("$FREEDOM CLASS=PRESCRIBED DOF=XY\n  NORTH\n$LOAD CASE=T TYPE=DISP\n  NORTH  "
                         f"{2e-4 if kind == 'both' else 0}  1e-3\n$STEP NAME=S\n  LOAD T 1\n"), a


def notched(case):
    """A bar with a notch of an opening angle, cracked beside the notch or from the other side towards it."""
    opening, depth, x0, y0, a, angle, nu, state = case
    half = depth * math.tan(math.radians(opening / 2))
    body = polygon([(0, -1), (1.5, -1), (1.5, -half), (1.5 - depth, 0), (1.5, half), (1.5, 1), (0, 1)], (3,),
                   ["SOUTH", "SIDE", "FLANK1", "FLANK2", "SIDE", "NORTH", "WEST"])
    text = material(1000, nu, state) + held("SOUTH", "Y") + "$NSET NAME=P WHERE=(abs(x) < 1e-9 and abs(y+1) < 1e-9)\n"
    return body, text + held("P", "X") + crack(x0, y0, a, angle) + pulled(("NORTH", 0.2, 1)), a


def supported(case):
    """A block that is held along a part of its lower side, or at points; cracked beside the end of that."""
    kind, x0, a, angle, nu, state = case
    body = polygon([(0, 0), (0.6, 0), (1.4, 0), (2, 0), (2, 1), (0, 1)], (0, 1, 2, 3),
                   ["FOOT", "SOUTH", "FOOT2", "EAST", "NORTH", "WEST"])
    text = material(1000, nu, state)
    if kind == "foot":
        text += held("FOOT")
    elif kind == "feet":
        text += held("FOOT", "Y") + held("FOOT2", "XY")
    else:
        text += ("$NSET NAME=P1 WHERE=(abs(x-0.6) < 1e-9 and abs(y) < 1e-9)\n"
                 "$NSET NAME=P2 WHERE=(abs(x-1.4) < 1e-9 and abs(y) < 1e-9)\n") + held("P1", "XY") + held("P2", "Y")
    load = pulled(("NORTH", 0, -1)) if kind == "feet" else pulled(("NORTH", 0.5, 0), ("EAST", 1, 0))
    if kind == "points":
        load = pulled(("NORTH", 0, "(-3*x*(2-x))"))
    return body, text + crack(x0, 0, a, angle) + load, a


def two_materials(case):
    """Layers whose border ends at free sides, or a square inclusion; a crack beside."""
    kind, ratio, x0, y0, a, angle, state = case
    if kind == "layers":
        body = Body([(0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (0, 0)], (2, 5),
                    [(0, 1, "SOUTH"), (1, 2, "EAST"), (2, 3, "EAST"), (3, 4, "NORTH"), (4, 5, "WEST"), (5, 0, "WEST"),
                     (5, 2, "")], [("BODY", [1, 2, -7, 6]), ("UPPER", [3, 4, 5, 7])])
        other = "UPPER"
    else:
        body = Body([(0, -1), (1.6, -1), (1.6, 1), (0, 1), (0.6, -0.3), (1.1, -0.3), (1.1, 0.3), (0.6, 0.3), (0, 0), (0.6, 0),
                     (1.1, 0), (1.6, 0)], (4, 5, 6, 7),
                    [(0, 1, "SOUTH"), (1, 11, "EAST"), (11, 2, "EAST"), (2, 3, "NORTH"), (3, 8, "WEST"), (8, 0, "WEST"),
                     (8, 9, ""), (10, 11, ""), (9, 4, ""), (4, 5, ""), (5, 10, ""), (10, 6, ""), (6, 7, ""), (7, 9, "")],
                    [("BODY", [1, 2, -8, -11, -10, -9, -7, 6]), ("BODY2", [3, 4, 5, 7, -14, -13, -12, 8]),
                     ("UPPER", [9, 10, 11, 12, 13, 14])])
        other = "UPPER"
    text = material(1000, 0.3, state) + material(1000 * ratio, 0.3, state, "M2", other)
    if kind != "layers":
        text += f"$PROPERTY ESET=BODY2 MATERIAL=M STATE={state}\n"
    text += "$NSET NAME=P WHERE=(abs(x) < 1e-9 and abs(y+1) < 1e-9)\n" + held("SOUTH", "Y") + held("P", "X")
    return body, text + crack(x0, y0, a, angle) + pulled(("NORTH", 0.1, 1)), a


def punched(case):
    """A beam on two feet, pressed by a flat punch, elastic or rigid; a crack from below."""
    kind, x0, a, angle, state = case
    body = polygon([(0, 0), (0.4, 0), (2.6, 0), (3, 0), (3, 1), (1.8, 1), (1.2, 1), (0, 1)], (1, 2, 5, 6),
                   ["FOOT", "SOUTH", "FOOT2", "EAST", "NORTH", "TOP", "NORTH", "WEST"])
    text = material(1000, 0.3, state, eset="BEAM.BODY") + held("BEAM.FOOT", "XY" if kind == "clamp" else "Y")
    text += held("BEAM.FOOT2", "Y")
    if kind != "clamp":
        text += "$NSET NAME=P WHERE=(abs(x) < 1e-9 and abs(y) < 1e-9)\n" + held("P", "X")
    text += crack(x0, 0, a, angle).replace("NAME=C", "NAME=C NET=BEAM")
    punch = polygon([(1.2, 1), (1.8, 1), (1.8, 1.4), (1.2, 1.4)], (0, 1), ["FACE", "SIDE", "HEAD", "SIDE"])
    text += material(1000 if kind == "soft" else 5000, 0.3, state, "M2", "PUNCH.BODY") + held("PUNCH.HEAD", "X")
    text += "$CONTACT NAME=PRESS SLAVE=PUNCH.FACE MASTER=BEAM.TOP GAP=0\n" + pulled(("PUNCH.HEAD", 0, -1))
    return (body, punch), text, a


def framed(case):
    """Kept from what constants were read off: a clamped frame of two materials about a window, with a slanting lintel."""
    kind, x0, y0, a, angle, nu, state = case
    inner = [(0.5, 0.5), (1.5, 0.5), (1.5, 1.2), (0.8, 1.4)]
    body = Body([(0, 0), (2, 0), (2, 0.5), (2, 2), (0, 2), (0, 0.5), *inner], (0, 1, 2, 5, 6, 7, 8, 9),
                [(0, 1, "SOUTH"), (1, 2, "EAST"), (2, 3, "EAST2"), (3, 4, "NORTH"), (4, 5, "WEST"), (5, 0, "WEST"), (5, 6, ""),
                 (7, 2, ""), (6, 7, "HOLE"), (7, 8, "HOLE"), (8, 9, "HOLE"), (9, 6, "HOLE")],
                [("BODY", [1, 2, -8, -9, -7, 6]), ("UPPER", [3, 4, 5, 7, -12, -11, -10, 8])])
    text = material(1000, nu, state) + material(4000 if kind == "stiff" else 1000, 0.2, state, "M2", "UPPER") + held("SOUTH")
    return body, text + crack(x0, y0, a, angle) + pulled(("NORTH", 1, 0.4)), a


CASES = {
    "clamped": (clamped, [("move", 0.8, 0.4, 0.4, 0, 0.3, "STRAIN"), ("both", 1, 0.25, 0.25, 15, 0.45, "STRAIN"),
                          ("arm", 2, 0.12, 0.1, 0, 0.49, "STRAIN"), ("arm", 1.5, 0.3, 0.4, -10, 0.3, "STRESS"),
                          ("move", 2, 0.15, 0.3, 30, 0.2, "STRESS")]),
    "notch": (notched, [(90, 0.5, 0, 0, 0.5, 0, 0.3, "STRAIN"), (60, 0.4, 0, 0.15, 0.7, 0, 0.3, "STRESS"),
                        (0.5, 0.6, 0, 0.2, 0.4, 0, 0.3, "STRAIN"), (120, 0.5, 0, -0.3, 0.6, 20, 0.45, "STRAIN")]),
    "support": (supported, [("foot", 0.8, 0.2, 90, 0.3, "STRAIN"), ("foot", 0.7, 0.1, 60, 0.45, "STRAIN"),
                            ("feet", 1.0, 0.4, 90, 0.3, "STRESS"), ("feet", 1.2, 0.15, 110, 0.3, "STRAIN"),
                            ("points", 1.0, 0.3, 90, 0.3, "STRESS"), ("points", 0.75, 0.2, 80, 0.3, "STRAIN")]),
    "material": (two_materials, [("layers", 10, 0, -0.3, 0.4, 0, "STRAIN"), ("layers", 0.1, 0, -0.25, 0.25, 0, "STRESS"),
                                 ("layers", 100, 0, -0.4, 0.3, 25, "STRAIN"), ("square", 10, 0, -0.2, 0.45, 0, "STRAIN"),
                                 ("square", 0.05, 0, -0.35, 0.4, 0, "STRESS")]),
    "punch": (punched, [("hard", 1.5, 0.5, 90, "STRAIN"), ("soft", 1.5, 0.6, 90, "STRESS"), ("hard", 1.3, 0.4, 75, "STRAIN"),
                        ("clamp", 1.7, 0.4, 90, "STRESS")]),
    "frame": (framed, [("stiff", 0, 0.3, 0.3, 0, 0.3, "STRAIN"), ("even", 0, 1.4, 0.5, 0, 0.3, "STRESS"),
                       ("stiff", 2, 1.3, 0.25, 180, 0.4, "STRAIN"), ("even", 0.3, 2, 0.4, -80, 0.45, "STRAIN")]),
}


def deck_and_files(family, case, mesh_of, tip, host):
    """The deck of a case and its meshes; mesh_of(body) is a gmsh script."""
    bodies, text, a = CASES[family][0](case)
    if family == "punch":
        files = {"beam.geo": mesh_of(bodies[0]), "punch.geo": mesh_of(bodies[1])}
        nets = "".join(f"$NET NAME={name}\n  $IMPORT FILE='{name.lower()}.geo' FORMAT=GEO\n$ENDNET\n" for name in ("BEAM", "PUNCH"))
    else:
        files = {"body.geo": mesh_of(bodies)}
        nets = "$IMPORT FILE='body.geo' FORMAT=GEO\n"
    return HEAD.format(host) + nets + text + tip(a) + "$END\n", files


def random_case(family, case, dice, tip_card):
    """A mesh by chance: of a case, with 3 to 12 elements over a unit of length."""
    h = math.exp(dice.uniform(math.log(1 / 12), math.log(1 / 3.5)))
    host = dice.choice(TYPES)
    text, files = deck_and_files(family, case, lambda body: body.by_chance(h, dice, host), lambda a: tip_card("C", a, dice), host)
    return text, files, host


def true_case(family, case, h=0.1):
    """A mesh graded towards the sharp points and the tip."""
    def tip(a):
        return f"$TIPNET CRACK=C SIZE={0.02 * a} RADIUS={0.2 * a} RINGS=10 SECTORS=36\n"
    return deck_and_files(family, case, lambda body: body.graded(h), tip, "TRIMC6")
