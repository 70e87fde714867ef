// A quarter of a cylinder of radius and height b standing on z = 0, elements of size hp at its foot.
SetFactory("OpenCASCADE");
DefineConstant[ b = 1, hp = 0.125 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, 0, 0, 0, b, b, Pi / 2};
Physical Volume("PUNCH") = {1};
s() = Abs(Boundary{ Volume{1}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(5) < 0.1)
    Physical Surface("FOOT") = {s(i)};
  EndIf
EndFor
Field[1] = MathEval;
Field[1].F = Sprintf("%g*(1 + 2*z*z)", hp);
Background Field = 1;
