// A strip that is stepped in the middle, for script_parameters.deck: the names mix their letters.
DefineConstant[ Len = 10, WidthA = 1, WidthB = 1, nAlong = 2 ];
Mesh.ElementOrder = 2;
Point(1) = {0, 0, 0};
Point(2) = {Len, 0, 0};
Point(3) = {Len, WidthA, 0};
Point(4) = {0, WidthA, 0};
Point(5) = {0, 2 * WidthA, 0};
Point(6) = {WidthB, 2 * WidthA, 0};
Point(7) = {WidthB, 2 * WidthA + Len, 0};
Point(8) = {0, 2 * WidthA + Len, 0};
For b In {0:1}
  For k In {1:4}
    Line(4 * b + k) = {4 * b + k, 4 * b + 1 + k % 4};
    Transfinite Curve{4 * b + k} = nAlong + 1;
  EndFor
  Curve Loop(b + 1) = {4 * b + 1 : 4 * b + 4};
  Plane Surface(b + 1) = {b + 1};
  Transfinite Surface{b + 1};
  Recombine Surface{b + 1};
EndFor
Mesh.SecondOrderIncomplete = 1;
Physical Surface("A") = {1};
Physical Surface("B") = {2};
Physical Curve("LEFT") = {4};
Physical Curve("RIGHT") = {2};
Physical Curve("LOWER") = {5};
Physical Curve("UPPER") = {7};
