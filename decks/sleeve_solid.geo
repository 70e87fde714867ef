// The sleeve of sleeve.geo as a solid, t thick from z = 0 upwards in nz layers of wedges; with both = 1 the
// mirror image below z = 0, too.
DefineConstant[ R = 36, ri = 30, fine = 1, t = 7, nz = 2, both = 0, line = 0 ];
size_arc = 4 / fine;
size_lips = 2 / fine;
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

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

o() = Extrude{0, 0, t}{ Surface{1}; Layers{nz}; Recombine; };
body() = {o(1)}; top() = {o(0)}; outer() = {o(2):o(7)}; inner() = {o(8):o(13)}; low() = {1};
If (both)
  q() = Extrude{0, 0, -t}{ Surface{1}; Layers{nz}; Recombine; };
  body() += q(1); low() = {q(0)};
  For i In {2:7}
    outer() += q(i);
    inner() += q(6 + i);
  EndFor
EndIf
Physical Volume("BODY") = {body()};
Physical Surface("ZMIN") = {low()};
Physical Surface("ZMAX") = {top()};
Physical Surface("OUTER") = {outer()};
Physical Surface("INNER") = {inner()};
