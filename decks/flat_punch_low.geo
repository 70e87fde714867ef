// A quarter of a cylinder of radius and depth L below z = 0, elements of size hb round the origin.
SetFactory("OpenCASCADE");
DefineConstant[ b = 1, L = 10, hb = 0.0625 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, -L, 0, 0, L, L, Pi / 2};
Physical Volume("BLOCK") = {1};
s() = Abs(Boundary{ Volume{1}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(2) > -0.1)
    Physical Surface("FLAT") = {s(i)};
  EndIf
EndFor
r = 1.25 * b;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.35*(Sqrt(x*x + y*y + z*z) - %g + Abs(Sqrt(x*x + y*y + z*z) - %g))/2", hb, r, r);
Background Field = 1;
