// MacNeal and Harder's plane patch, one quad or two triangles to each of its five fields.
// type: 1 TRIM3, 2 TRIMC6, 3 QUAM4, 4 QUAMC8, 5 QUAMC9; bulge: sagitta of the inner field's sides.
DefineConstant[ type = 4, bulge = 0 ];
Mesh.ElementOrder = (type == 1 || type == 3) ? 1 : 2;
Mesh.SecondOrderIncomplete = (type == 4);
x[] = {0, 0.24, 0.24, 0, 0.04, 0.18, 0.16, 0.08};
y[] = {0, 0, 0.12, 0.12, 0.02, 0.03, 0.08, 0.08};
For i In {0:7}
  Point(1 + i) = {x[i], y[i], 0};
EndFor
For i In {0:3}
  j = (i + 1) % 4;
  Line(1 + i) = {1 + i, 1 + j};
  dx = x[4 + j] - x[4 + i];
  dy = y[4 + j] - y[4 + i];
  Point(11 + i) = {x[4 + i] + dx / 2 - 2 * bulge * dy, y[4 + i] + dy / 2 + 2 * bulge * dx, 0};
  Bezier(5 + i) = {5 + i, 11 + i, 5 + j}; // a parabola
  Line(9 + i) = {1 + i, 5 + i};
EndFor
For i In {0:3}
  Curve Loop(1 + i) = {1 + i, 9 + (i + 1) % 4, -(5 + i), -(9 + i)};
EndFor
Curve Loop(5) = {5, 6, 7, 8};
For i In {1:5}
  Plane Surface(i) = {i};
EndFor
Transfinite Curve{:} = 2;
Transfinite Surface{:};
If (type > 2)
  Recombine Surface{:};
EndIf
Physical Surface("PATCH") = {1:5};
Physical Curve("RIM") = {1:4};
Physical Curve("YMIN") = {1};
Physical Curve("XMAX") = {2};
Physical Curve("YMAX") = {3};
Physical Curve("XMIN") = {4};
