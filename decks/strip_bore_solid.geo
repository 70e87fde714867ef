// A strip x0 < x < x1, z0 < z < z1 of thickness t along y with a bore of radius R about the y axis:
// size h at the bore, growing outwards.
SetFactory("OpenCASCADE");
DefineConstant[ R = 10, t = 10, x0 = -80, x1 = 80, z0 = -160, z1 = 160, h = 2 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMax = 20;
Box(1) = {x0, 0, z0, x1 - x0, t, z1 - z0};
Cylinder(3) = {0, 0, 0, 0, t, 0, R};
BooleanDifference(5) = { Volume{1}; Delete; }{ Volume{3}; Delete; };
Physical Volume("STRIP") = {5};
s() = Abs(Boundary{ Volume{5}; });
bore() = {};
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(3) < R + 0.1 && bb(5) < R + 0.1 && bb(0) > -R - 0.1 && bb(2) > -R - 0.1)
    bore() += s(i);
  EndIf
EndFor
Physical Surface("BORE") = {bore()};
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.3*Abs(Sqrt(x*x + z*z) - %g)", h, R);
Background Field = 1;
