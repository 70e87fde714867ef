// Quarter section of a round block, R by R, with points on the axis, at the edge of a disc c and at the
// tip of a crack a; elements of size h at the last two.
DefineConstant[ c = 0.5, a = 1, R = 15, h = 0.005 ];
Mesh.ElementOrder = 2;
Point(1) = {0, 0, 0, 10*h};
Point(2) = {c, 0, 0, h};
Point(3) = {a, 0, 0, h};
Point(4) = {R, 0, 0, R/8};
Point(5) = {R, R, 0, R/8};
Point(6) = {0, R, 0, R/8};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1 : 6};
Plane Surface(1) = {1};
Physical Curve("UNDER") = {1};
Physical Curve("LINE") = {1, 2, 3};
Physical Surface("BODY") = {1};
