// The sleeve: a ring from ri to R about the origin; finer where the lug's cracks start and contact
// ends. Values come from the deck; `fine` divides every mesh size.
DefineConstant[ R = 36, ri = 30, fine = 1, line = 0 ]; // line: as in lug.geo
size_arc = 4 / fine;
size_lips = 2 / fine;
Mesh.ElementOrder = 2;

Point(1) = {0, 0, 0};
angle[] = {0, 70, 112, 180, 248, 290, 360};
For i In {0:5}
  c = Cos(angle[i] * Pi / 180);
  s = Sin(angle[i] * Pi / 180);
  Point(10 + i) = {R * c, R * s, 0, size_arc};
  Point(20 + i) = {ri * c, ri * s, 0, size_arc};
EndFor
For i In {0:5}
  Circle(10 + i) = {10 + i, 1, 10 + (i + 1) % 6};
  Circle(20 + i) = {20 + i, 1, 20 + (i + 1) % 6};
  turn = (angle[i + 1] - angle[i]) * Pi / 180;
  size = (i == 1 || i == 4) ? size_lips : size_arc;
  Transfinite Curve{10 + i} = Ceil(turn * R / size) + 1;
  Transfinite Curve{20 + i} = Ceil(turn * ri / size) + 1;
EndFor
Curve Loop(1) = {10:15};
Curve Loop(2) = {20:25};
Plane Surface(1) = {1, 2};
If (line)
  Line(1) = {20, 10};
  Line(2) = {13, 23};
  Curve{1, 2} In Surface{1};
EndIf

Physical Surface("BODY") = {1};
Physical Curve("OUTER") = {10:15};
Physical Curve("INNER") = {20:25};
