// The sleeve with equal sides, as many as the bore.
DefineConstant[ R = 36, ri = 30, edges = 72 ];
Mesh.ElementOrder = 2;
Point(1) = {0, 0, 0};
For i In {0:3}
  c = Cos(i * Pi / 2);
  s = Sin(i * Pi / 2);
  Point(10 + i) = {R * c, R * s, 0, 4};
  Point(20 + i) = {ri * c, ri * s, 0, 4};
EndFor
For i In {0:3}
  Circle(10 + i) = {10 + i, 1, 10 + (i + 1) % 4};
  Circle(20 + i) = {20 + i, 1, 20 + (i + 1) % 4};
  Transfinite Curve{10 + i, 20 + i} = edges / 4 + 1;
EndFor
Curve Loop(1) = {10:13};
Curve Loop(2) = {20:23};
Plane Surface(1) = {1, 2};
Physical Surface("BODY") = {1};
Physical Curve("OUTER") = {10:13};
Physical Curve("INNER") = {20:23};
