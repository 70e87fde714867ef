// A quarter of a bush (radii a to b) and of the ring round it (b to c), both t high, meshed apart,
// with elements of `deg` degrees at the fit, growing outwards.
SetFactory("OpenCASCADE");
DefineConstant[ deg = 6.4, t = 8, a = 30, b = 36, c = 86.5 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, 0, 0, 0, t, c, Pi / 2};
Cylinder(2) = {0, 0, 0, 0, 0, t, b, Pi / 2};
Cylinder(3) = {0, 0, 0, 0, 0, t, b, Pi / 2};
Cylinder(4) = {0, 0, 0, 0, 0, t, a, Pi / 2};
BooleanDifference(5) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(6) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Physical Volume("RING") = {5};
Physical Volume("BUSH") = {6};
// The surfaces of the fit: of the ring the one no wider than b, of the bush the tall one that wide.
s() = Abs(Boundary{ Volume{5}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(3) < b + 0.1 && bb(4) < b + 0.1)
    Physical Surface("BORE") = {s(i)};
  EndIf
EndFor
s() = Abs(Boundary{ Volume{6}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(3) > b - 0.1 && bb(4) > b - 0.1 && bb(5) - bb(2) > t / 2)
    Physical Surface("BACK") = {s(i)};
  EndIf
EndFor
h = b * deg * Pi / 180;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.24*(Sqrt(x*x + y*y) - %g + Abs(Sqrt(x*x + y*y) - %g))/2", h, b, b);
Background Field = 1;
