// Right half of a foundation under a layer: x >= 0, y <= 0. Elements of size s on the surface over
// `near`, growing away from it. Values come from the deck.
DefineConstant[ near = 2, length = 8, depth = 25, s = 0.1 ];
Mesh.ElementOrder = 2;

Point(1) = {0, -depth, 0, 3};
Point(2) = {depth, -depth, 0, 3};
Point(3) = {depth, 0, 0, 3};
Point(4) = {length, 0, 0, 1};
Point(5) = {near, 0, 0, s};
Point(6) = {0, 0, 0, s};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Transfinite Curve{5} = Round(near / s) + 1;
Curve Loop(1) = {1:6};
Plane Surface(1) = {1};

Physical Surface("BODY") = {1};
Physical Curve("TOP") = {4, 5};
Physical Curve("SYM") = {6};
Physical Curve("BASE") = {1};
