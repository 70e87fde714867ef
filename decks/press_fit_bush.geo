// A quarter of a bush (radii a to b), t high, with elements of `bush` degrees at its back.
SetFactory("OpenCASCADE");
DefineConstant[ bush = 8.5, t = 8, a = 30, b = 36 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(3) = {0, 0, 0, 0, 0, t, b, Pi / 2};
Cylinder(4) = {0, 0, 0, 0, 0, t, a, Pi / 2};
BooleanDifference(6) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Physical Volume("BUSH") = {6};
// The back is b wide and tall.
s() = Abs(Boundary{ Volume{6}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(3) > b - 0.1 && bb(4) > b - 0.1 && bb(5) - bb(2) > t / 2)
    Physical Surface("BACK") = {s(i)};
  EndIf
EndFor
h = b * bush * Pi / 180;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.24*(Sqrt(x*x + y*y) - %g + Abs(Sqrt(x*x + y*y) - %g))/2", h, b, b);
Background Field = 1;
