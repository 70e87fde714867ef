// The solid shaft of radius ri about the origin. Values come from the deck; `fine` divides every
// mesh size.
DefineConstant[ ri = 30, fine = 1, line = 0 ]; // line: as in lug.geo
size_arc = 4 / fine;
size_ends = 2 / fine;
size_middle = 10 / fine;
Mesh.ElementOrder = 2;

Point(1) = {0, 0, 0, size_middle};
angle[] = {0, 70, 112, 180, 248, 290, 360};
For i In {0:5}
  Point(20 + i) = {ri * Cos(angle[i] * Pi / 180), ri * Sin(angle[i] * Pi / 180), 0, size_arc};
EndFor
For i In {0:5}
  Circle(20 + i) = {20 + i, 1, 20 + (i + 1) % 6};
  turn = (angle[i + 1] - angle[i]) * Pi / 180;
  size = (i == 1 || i == 4) ? size_ends : size_arc;
  Transfinite Curve{20 + i} = Ceil(turn * ri / size) + 1;
EndFor
Curve Loop(1) = {20:25};
Plane Surface(1) = {1};
If (line)
  Line(1) = {23, 1};
  Line(2) = {1, 20};
  Curve{1, 2} In Surface{1};
Else
  Point{1} In Surface{1};
EndIf

Physical Surface("BODY") = {1};
Physical Curve("OUTER") = {20:25};
