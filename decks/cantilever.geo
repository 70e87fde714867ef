// Cantilever of n elements in a row, l x h. The sides between them are upright (form = 0) or
// inclined by 45 degrees, all the same way for parallelograms (form = 1), in turn for trapezia (form = 2). A
// width of b > 0 makes bricks, 0 <= z <= b.
DefineConstant[ l = 6, h = 0.2, b = 0, n = 6, form = 0, serendipity = 1 ];
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = serendipity;

For i In {0:n}
  shift = (form == 0 || i == 0 || i == n) ? 0 : (form == 2 && i % 2 == 0) ? -h / 2 : h / 2;
  Point(2 * i + 1) = {i * l / n + shift, -h / 2, 0};
  Point(2 * i + 2) = {i * l / n - shift, h / 2, 0};
  Line(100 + i) = {2 * i + 1, 2 * i + 2};
EndFor
For i In {1:n}
  Line(200 + i) = {2 * i - 1, 2 * i + 1};
  Line(300 + i) = {2 * i, 2 * i + 2};
  Curve Loop(i) = {200 + i, 100 + i, -(300 + i), -(99 + i)};
  Plane Surface(i) = {i};
EndFor
Transfinite Curve{:} = 2;
Transfinite Surface{:};
Recombine Surface{:};

If (b == 0)
  Physical Surface("BODY") = {1:n};
Else
  Extrude{0, 0, b}{ Surface{1:n}; Layers{1}; Recombine; }
  Physical Volume("BODY") = {1:n};
EndIf
