// A quarter of a plate of half width W with a crack of up to 1.5 from its centre: elements of size h
// there, growing outwards.
DefineConstant[ W = 40, h = 0.1 ];
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Mesh.MeshSizeExtendFromBoundary = 1;
Point(1) = {0, 0, 0, h};
Point(2) = {3, 0, 0, 2 * h};
Point(3) = {W, 0, 0, W / 6};
Point(4) = {W, W, 0, W / 6};
Point(5) = {0, W, 0, W / 6};
Point(6) = {0, 3, 0, 2 * h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
Physical Surface("BODY") = {1};
Physical Curve("BELOW") = {1, 2};
Physical Curve("LEFT") = {5, 6};
