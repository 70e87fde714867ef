// A quarter of a hub (radii b to c) and of the shaft in it, both `tall` high about the axis z, meshed apart by
// tetrahedra of `size` at the fit, growing away from it.
SetFactory("OpenCASCADE");
DefineConstant[ b = 20, c = 40, tall = 10, size = 2.5 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, 0, 0, 0, tall, c, Pi / 2};
Cylinder(2) = {0, 0, 0, 0, 0, tall, b, Pi / 2};
Cylinder(3) = {0, 0, 0, 0, 0, tall, b, Pi / 2};
BooleanDifference(5) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("HUB") = {5};
Physical Volume("SHAFT") = {3};
// The surfaces of the fit: tall ones, of the hub no wider than b, of the shaft curved.
s() = Abs(Boundary{ Volume{5}; });
bore() = {};
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(5) - bb(2) > tall / 2 && bb(3) < b + 0.1 && bb(4) < b + 0.1)
    bore() += s(i);
  EndIf
EndFor
Physical Surface("BORE") = {bore()};
s() = Abs(Boundary{ Volume{3}; });
back() = {};
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(5) - bb(2) > tall / 2 && bb(3) > b / 10 && bb(4) > b / 10)
    back() += s(i);
  EndIf
EndFor
Physical Surface("BACK") = {back()};
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.2*Abs(Sqrt(x*x + y*y) - %g)", size, b);
Background Field = 1;
