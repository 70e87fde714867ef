// Half of a ring (radii R to 3 R) and half of a pin of radius R - c in it, both t high.
SetFactory("OpenCASCADE");
DefineConstant[ R = 10, c = 0, t = 3, h = 1.5 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, 0, 0, 0, t, 3 * R, Pi};
Cylinder(2) = {0, 0, 0, 0, 0, t, R, Pi};
Cylinder(3) = {0, 0, 0, 0, 0, t, R - c, Pi};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("RING") = {4};
Physical Volume("PIN") = {3};
s() = Abs(Boundary{ Volume{4}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(3) < R + 0.1 && bb(4) > R - 0.1 && bb(5) - bb(2) > t / 2)
    Physical Surface("BORE") = {s(i)};
  EndIf
EndFor
s() = Abs(Boundary{ Volume{3}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(4) > R / 2 && bb(5) - bb(2) > t / 2)
    Physical Surface("SIDE") = {s(i)};
  EndIf
EndFor
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.2*(Sqrt(x*x + y*y) - %g + Abs(Sqrt(x*x + y*y) - %g))/2", h, R, R);
Background Field = 1;
