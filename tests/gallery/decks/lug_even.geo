// The paper's lug with a bore of equal sides, `edges` of them.
DefineConstant[ R = 36, e = 86.5, L0 = 232.5, edges = 72 ];
side = 2 * Pi * R / edges;
Mesh.ElementOrder = 2;
Point(1) = {0, 0, 0};
For i In {0:3}
  Point(10 + i) = {R * Cos(i * Pi / 2), R * Sin(i * Pi / 2), 0, side};
EndFor
For i In {0:3}
  Circle(10 + i) = {10 + i, 1, 10 + (i + 1) % 4};
  Transfinite Curve{10 + i} = edges / 4 + 1;
EndFor
Point(2) = {0, -e, 0, 10};
Point(3) = {e, 0, 0, 10};
Point(4) = {0, e, 0, 10};
Point(5) = {-L0, e, 0, 16};
Point(6) = {-L0, -e, 0, 16};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 2};
Curve Loop(1) = {1:5};
Curve Loop(2) = {10:13};
Plane Surface(1) = {1, 2};
Physical Surface("BODY") = {1};
Physical Curve("BORE") = {10:13};
Physical Curve("END") = {4};
