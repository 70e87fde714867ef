// A pin of radius R about the y axis, 0 < y < t: size h at its back, growing inwards.
SetFactory("OpenCASCADE");
DefineConstant[ R = 10, t = 10, h = 2 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMax = 20;
Cylinder(1) = {0, 0, 0, 0, t, 0, R};
Physical Volume("PIN") = {1};
s() = Abs(Boundary{ Volume{1}; });
back() = {};
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(4) - bb(1) > t / 2)
    back() += s(i);
  EndIf
EndFor
Physical Surface("BACK") = {back()};
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.3*Abs(Sqrt(x*x + z*z) - %g)", h, R);
Background Field = 1;
