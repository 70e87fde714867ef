// The shaft with equal sides, as many as the bore.
DefineConstant[ ri = 30, edges = 72 ];
Mesh.ElementOrder = 2;
Point(1) = {0, 0, 0, 6};
For i In {0:3}
  Point(20 + i) = {ri * Cos(i * Pi / 2), ri * Sin(i * Pi / 2), 0, 4};
EndFor
For i In {0:3}
  Circle(20 + i) = {20 + i, 1, 20 + (i + 1) % 4};
  Transfinite Curve{20 + i} = edges / 4 + 1;
EndFor
Curve Loop(1) = {20:23};
Plane Surface(1) = {1};
Point{1} In Surface{1};
Physical Surface("BODY") = {1};
Physical Curve("OUTER") = {20:23};
