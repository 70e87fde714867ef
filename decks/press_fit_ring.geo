// A quarter of a ring (radii b to c), t high, with elements of `ring` degrees at its bore, growing
// outwards.
SetFactory("OpenCASCADE");
DefineConstant[ ring = 12.7, t = 8, b = 36, c = 86.5 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, 0, 0, 0, t, c, Pi / 2};
Cylinder(2) = {0, 0, 0, 0, 0, t, b, Pi / 2};
BooleanDifference(5) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("RING") = {5};
// The bore is no wider than b.
s() = Abs(Boundary{ Volume{5}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(3) < b + 0.1 && bb(4) < b + 0.1)
    Physical Surface("BORE") = {s(i)};
  EndIf
EndFor
h = b * ring * Pi / 180;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.24*(Sqrt(x*x + y*y) - %g + Abs(Sqrt(x*x + y*y) - %g))/2", h, b, b);
Background Field = 1;
