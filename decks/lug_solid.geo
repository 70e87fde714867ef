// The paper's lug as a solid: lug.geo, t thick from z = 0 upwards in nz layers of wedges; with both = 1 the
// mirror image below z = 0, too; with line = 1 a line of the mesh along y = 0. Values come from the deck;
// `fine` divides mesh sizes in the plane.
DefineConstant[ R = 36, e = 86.5, L0 = 232.5, fine = 1, t = 7, nz = 2, both = 0, line = 0 ];
size_bore = 4 / fine;   // round the bore
size_lips = 1.2 / fine; // on the bore where cracks start and contact ends
size_far = 10 / fine;
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(1) = {0, 0, 0};
// The bore, counter-clockwise from 0 degrees; finer arcs 70 to 112 degrees on both sides.
angle[] = {0, 70, 112, 180, 248, 290, 360};
For i In {0:5}
  Point(10 + i) = {R * Cos(angle[i] * Pi / 180), R * Sin(angle[i] * Pi / 180), 0, size_bore};
EndFor
For i In {0:5}
  Circle(10 + i) = {10 + i, 1, 10 + (i + 1) % 6};
  span = (angle[i + 1] - angle[i]) * Pi / 180 * R;
  fine_arc = (i == 1 || i == 4);
  Transfinite Curve{10 + i} = Ceil(span / (fine_arc ? size_lips : size_bore)) + 1;
EndFor

// The outer edge, counter-clockwise from the lower end of the head.
Point(2) = {0, -e, 0, size_far};
Point(3) = {e, 0, 0, size_far};
Point(4) = {0, e, 0, size_far};
Point(5) = {-L0, e, 0, 1.6 * size_far};
Point(6) = {-L0, -e, 0, 1.6 * size_far};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
If (line)
  Point(7) = {-L0, 0, 0, 1.6 * size_far};
  Line(4) = {5, 7};
  Line(6) = {7, 6};
  rim[] = {1:4, 6, 5};
Else
  Line(4) = {5, 6};
  rim[] = {1:5};
EndIf
Line(5) = {6, 2};
Curve Loop(1) = {rim[]};
Curve Loop(2) = {10:15};
Plane Surface(1) = {1, 2};
If (line)
  Line(7) = {7, 13};
  Line(8) = {10, 3};
  Curve{7, 8} In Surface{1};
EndIf

o() = Extrude{0, 0, t}{ Surface{1}; Layers{nz}; Recombine; };
body() = {o(1)}; top() = {o(0)}; end() = {o(5)}; low() = {1};
first = 7;
If (line)
  first = 8;
  end() += o(6);
EndIf
bore() = {o(first):o(first + 5)};
If (both)
  q() = Extrude{0, 0, -t}{ Surface{1}; Layers{nz}; Recombine; };
  body() += q(1); low() = {q(0)};
  For i In {first:first + 5}
    bore() += q(i);
  EndFor
  For i In {5:first - 2}
    end() += q(i);
  EndFor
EndIf
Physical Volume("BODY") = {body()};
Physical Surface("ZMIN") = {low()};
Physical Surface("ZMAX") = {top()};
Physical Surface("BORE") = {bore()};
Physical Surface("END") = {end()};
