// Half of a half plane y < 0 (about an axis: a half space), a block of side L, with elements of size h on the first `fine` of its
// surface, growing from there on.
DefineConstant[ L = 20, fine = 1.2, h = 0.04 ];
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Mesh.MeshSizeExtendFromBoundary = 1;
coarse = L / 8;
Point(1) = {0, 0, 0, h};
Point(2) = {fine, 0, 0, h};
Point(3) = {L, 0, 0, coarse};
Point(4) = {L, -L, 0, coarse};
Point(5) = {0, -L, 0, coarse};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {-1};
Transfinite Curve{1} = Round(fine / h) + 1;
Physical Surface("BODY") = {1};
Physical Curve("FLAT") = {1, 2};
Physical Curve("SIDE") = {3};
Physical Curve("BOTTOM") = {4};
Physical Curve("AXIS") = {5};
