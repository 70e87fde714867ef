# SPDX-License-Identifier: GPL-3.0-or-later
"""The joint of write_joint.cpp in decks: from its STEP file, and drawn by scripts."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "terminal"))

JOINT = Path(sys.argv.pop(2)).resolve()

FROM_STEP = """$NET NAME=LUG
  $IMPORT FILE='joint.step' SOLID=LUG SIZE=({size})
    CYLINDER 15          = BORE ({size}/3)
    PLANE Z              = ZMAX
    PLANE -X (x < -99.9) = END
$ENDNET
$NET NAME=BUSH
  $IMPORT FILE='joint.step' FORMAT=STEP SOLID=BUSH SIZE=({size}/3)
    CYLINDER (30/2) = OUTER
    F4              = INNER
$ENDNET
$NET NAME=PIN
  $IMPORT FILE='joint.step' SOLID=PIN SIZE=({size}/2)
    CYLINDER      = OUTER
    PLANE (z > 0) = TOP
    PLANE (z < 0) = FOOT
$ENDNET
"""

FROM_SCRIPTS = """$NET NAME=LUG
  $IMPORT FILE='lug.geo'
$ENDNET
$NET NAME=BUSH
  $IMPORT FILE='bush.geo'
$ENDNET
$NET NAME=PIN
  $IMPORT FILE='pin.geo'
$ENDNET
"""

REST = """$MATERIAL NAME=ALUMINIUM E=71[GPa]  NU=0.33
$MATERIAL NAME=STEEL     E=205[GPa] NU=0.3
$PROPERTY ESET=LUG.BODY  MATERIAL=ALUMINIUM STATE=SOLID
$PROPERTY ESET=BUSH.BODY MATERIAL=STEEL     STATE=SOLID
$PROPERTY ESET=PIN.BODY  MATERIAL=STEEL     STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  LUG.END
$FREEDOM CLASS=SUPPRESSED DOF=YZ
  PIN.TOP PIN.FOOT
$CONTACT NAME=FIT SLAVE=BUSH.OUTER MASTER=LUG.BORE DIAMETRAL=0.03
$CONTACT NAME=SHAFT SLAVE=PIN.OUTER MASTER=BUSH.INNER GAP=0
$LOAD CASE=PULL TYPE=RESULTANT
  PIN.BODY  20[kN]  0  0
$STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=LOAD
  LOAD PULL 1
$CRACK NAME=FLAW NET=LUG AT=BORE,ZMAX ANGLE=90[deg] DEPTH=2 LENGTH=2
$END
"""

# What the program asks of gmsh for a STEP file.
SIZES = """Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1; Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeMax = {size}; Mesh.MeshSizeMin = {size}/10; Mesh.MeshSizeFromCurvature = 12;
"""

SCRIPTS = {
    "lug.geo": """SetFactory("OpenCASCADE");
Box(1) = {-100, -32, 0, 100, 64, 12}; Cylinder(2) = {0, 0, 0, 0, 0, 12, 32};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, 0, 0, 0, 12, 15};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
bore() = Surface In BoundingBox{-15.1, -15.1, -0.1, 15.1, 15.1, 12.1};
top() = Surface In BoundingBox{-101, -33, 11.9, 33, 33, 12.1};
end() = Surface In BoundingBox{-100.1, -33, -0.1, -99.9, 33, 12.1};
Physical Volume("BODY") = {5}; Physical Surface("BORE") = {bore()};
Physical Surface("ZMAX") = {top()}; Physical Surface("END") = {end()};
Field[1] = MathEval; Field[1].F = "Min(SIZE, SIZE/3 + 0.3*Max(0, Sqrt(x*x + y*y) - 15))"; Background Field = 1;
""",
    "bush.geo": """SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 12, 15}; Cylinder(2) = {0, 0, 0, 0, 0, 12, 12};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
inner() = Surface In BoundingBox{-12.1, -12.1, -0.1, 12.1, 12.1, 12.1};
low() = Surface In BoundingBox{-16, -16, -0.1, 16, 16, 0.1}; top() = Surface In BoundingBox{-16, -16, 11.9, 16, 16, 12.1};
outer() = Abs(Boundary{ Volume{3}; }); outer() -= inner(); outer() -= low(); outer() -= top();
Physical Volume("BODY") = {3}; Physical Surface("INNER") = {inner()}; Physical Surface("OUTER") = {outer()};
""",
    "pin.geo": """SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, -4, 0, 0, 20, 12};
low() = Surface In BoundingBox{-13, -13, -4.1, 13, 13, -3.9}; top() = Surface In BoundingBox{-13, -13, 15.9, 13, 13, 16.1};
outer() = Abs(Boundary{ Volume{1}; }); outer() -= low(); outer() -= top();
Physical Volume("BODY") = {1}; Physical Surface("OUTER") = {outer()};
Physical Surface("TOP") = {top()}; Physical Surface("FOOT") = {low()};
""",
}


def deck_from_step(size):
    head = "$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Joint of a STEP file'\n"
    return head + FROM_STEP.format(size=size) + REST


def write_scripts(folder, size):
    for (name, text), part in zip(SCRIPTS.items(), (1, 3, 2)):
        text = SIZES.format(size=size / part) + text.replace("SIZE", f"{size}")
        (folder / name).write_text(text)
    return "$DECK VERSION=1 LENGTH=MM FORCE=N TITLE='Joint of scripts'\n" + FROM_SCRIPTS + REST
