// Two round bodies of radius R that touch in the origin, each a box of half width L and height H
// with a round end. The arcs |x| < w that may touch have edges of length edge, far edges that of L / 4.
DefineConstant[ R = 20, L = 4, H = 8, w = 0.5, edge = 0.008 ];
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
yw = R - Sqrt(R^2 - w^2);
yl = R - Sqrt(R^2 - L^2);
n = 2 * Floor(w / edge) + 1;
For b In {0:1}
  s = 1 - 2 * b; // the upper one, then the lower one
  k = 10 * b;
  Point(k + 1) = {0, s * R, 0};
  Point(k + 2) = {-w, s * yw, 0, edge};
  Point(k + 3) = {w, s * yw, 0, edge};
  Point(k + 4) = {L, s * yl, 0, L / 4};
  Point(k + 5) = {L, s * H, 0, L / 4};
  Point(k + 6) = {-L, s * H, 0, L / 4};
  Point(k + 7) = {-L, s * yl, 0, L / 4};
  Circle(k + 1) = {k + 2, k + 1, k + 3};
  Circle(k + 2) = {k + 3, k + 1, k + 4};
  Line(k + 3) = {k + 4, k + 5};
  Line(k + 4) = {k + 5, k + 6};
  Line(k + 5) = {k + 6, k + 7};
  Circle(k + 6) = {k + 7, k + 1, k + 2};
  Transfinite Curve{k + 1} = n;
  Curve Loop(k + 1) = {k + 1, k + 2, k + 3, k + 4, k + 5, k + 6};
  Plane Surface(k + 1) = {k + 1};
EndFor
Physical Surface("UPPER") = {1};
Physical Surface("LOWER") = {11};
Physical Curve("UPPER_ARC") = {1};
Physical Curve("LOWER_ARC") = {11};
Physical Curve("TOP") = {4};
Physical Curve("LEFT") = {5};
Physical Curve("RIGHT") = {3};
Physical Curve("BASE") = {14};
