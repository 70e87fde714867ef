// An eighth of a spherical shell (radii a to b) and of the one round it (b to c), meshed apart, with
// elements of `deg` degrees at the fit, growing away from it.
SetFactory("OpenCASCADE");
DefineConstant[ deg = 8, a = 12, b = 20, c = 40 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Sphere(1) = {0, 0, 0, c, 0, Pi / 2, Pi / 2};
Sphere(2) = {0, 0, 0, b, 0, Pi / 2, Pi / 2};
Sphere(3) = {0, 0, 0, b, 0, Pi / 2, Pi / 2};
Sphere(4) = {0, 0, 0, a, 0, Pi / 2, Pi / 2};
BooleanDifference(5) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(6) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Physical Volume("HULL") = {5};
Physical Volume("CORE") = {6};
// Round surfaces have a box as wide as long as high: the fit's is b wide.
For v In {5 : 6}
  s() = Abs(Boundary{ Volume{v}; });
  For i In {0 : #s() - 1}
    bb() = BoundingBox Surface { s(i) };
    If (bb(3) > 1 && bb(4) > 1 && bb(5) > 1 && Abs(bb(3) - b) < 0.1)
      If (v == 5)
        Physical Surface("SEAT") = {s(i)};
      Else
        Physical Surface("BALL") = {s(i)};
      EndIf
    EndIf
  EndFor
EndFor
h = b * deg * Pi / 180;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.3*(Sqrt(x*x + y*y + z*z) - %g + Abs(Sqrt(x*x + y*y + z*z) - %g))/2", h, b, b);
Background Field = 1;
