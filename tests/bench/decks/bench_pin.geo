// A plate of radius c, `tall` high, with a bore of radius b about the axis z, and a pin in it from z = -below
// on, `long` long; halves y > 0, meshed apart by tetrahedra: of `size` at the fit, by `coarser` larger for
// every unit of length away from it.
SetFactory("OpenCASCADE");
DefineConstant[ b = 5, c = 20, tall = 14, below = 2, long = 30, size = 0.5, coarser = 0.7 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Cylinder(1) = {0, 0, 0, 0, 0, tall, c, Pi};
Cylinder(2) = {0, 0, 0, 0, 0, tall, b, Pi};
Cylinder(3) = {0, 0, -below, 0, 0, long, b, Pi};
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
  If (bb(5) - bb(2) > long / 2 && bb(4) > b / 10)
    back() += s(i);
  EndIf
EndFor
Physical Surface("BACK") = {back()};
Field[1] = MathEval;
Field[1].F = Sprintf("%g + %g*Abs(Sqrt(x*x + y*y) - %g) + %g*(Abs(z - 7) - 8 + Abs(Abs(z - 7) - 8))/2", size, coarser, b, coarser);
Background Field = 1;
