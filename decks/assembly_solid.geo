// A quarter of a shaft (radius a), of a sleeve (a to b) and of a ring (b to c), all t high, meshed
// apart, with elements of `deg` degrees at the fits, growing outwards.
SetFactory("OpenCASCADE");
DefineConstant[ deg = 12.7, t = 8, a = 30, b = 36, c = 86.5 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, 0, 0, 0, t, c, Pi / 2};
Cylinder(2) = {0, 0, 0, 0, 0, t, b, Pi / 2};
Cylinder(3) = {0, 0, 0, 0, 0, t, b, Pi / 2};
Cylinder(4) = {0, 0, 0, 0, 0, t, a, Pi / 2};
Cylinder(5) = {0, 0, 0, 0, 0, t, a, Pi / 2};
BooleanDifference(6) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(7) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Physical Volume("SHAFT") = {5};
Physical Volume("RING") = {6};
Physical Volume("SLEEVE") = {7};
// Round surfaces are those as wide as high of their box, and tall: by their width and their body.
For v In {5 : 7}
  s() = Abs(Boundary{ Volume{v}; });
  For i In {0 : #s() - 1}
    bb() = BoundingBox Surface { s(i) };
    If (bb(5) - bb(2) > t / 2 && bb(3) > 1 && bb(4) > 1)
      If (v == 5)
        Physical Surface("OUTER") = {s(i)};
      ElseIf (v == 6 && bb(3) < b + 0.1)
        Physical Surface("BORE") = {s(i)};
      ElseIf (v == 6)
        Physical Surface("RIM") = {s(i)};
      ElseIf (bb(3) < a + 0.1)
        Physical Surface("INNER") = {s(i)};
      Else
        Physical Surface("BACK") = {s(i)};
      EndIf
    EndIf
  EndFor
EndFor
h = b * deg * Pi / 180;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.24*(Sqrt(x*x + y*y) - %g + Abs(Sqrt(x*x + y*y) - %g))/2", h, b, b);
Background Field = 1;
