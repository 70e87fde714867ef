// A cube of side 2 A and the block that fills a cavity of 8 x 10 x 6 in it, meshed apart by tetrahedra.
SetFactory("OpenCASCADE");
DefineConstant[ A = 10, size = 2.5 ];
Mesh.ElementOrder = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Box(1) = {-A, -A, -A, 2 * A, 2 * A, 2 * A};
Box(2) = {-4, -5, -3, 8, 10, 6};
Box(3) = {-4, -5, -3, 8, 10, 6};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("CUBE") = {4};
Physical Volume("BLOCK") = {3};
s() = Abs(Boundary{ Volume{4}; });
outer() = {};
wall() = {};
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(3) - bb(0) > 1.9 * A || bb(4) - bb(1) > 1.9 * A)
    outer() += s(i);
  Else
    wall() += s(i);
  EndIf
EndFor
Physical Surface("OUTER") = {outer()};
Physical Surface("WALL") = {wall()};
s() = Abs(Boundary{ Volume{3}; });
Physical Surface("SKIN") = {s()};
// Five elements along each edge of the block, so that no nodes match those of the cavity.
For i In {0 : #s() - 1}
  c() = Abs(Boundary{ Surface{s(i)}; });
  Transfinite Curve{c()} = 6;
EndFor
Field[1] = MathEval;
Field[1].F = Sprintf("%g", size);
Background Field = 1;
