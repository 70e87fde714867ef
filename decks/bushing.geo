// The bushing of bushed_lug.geo: a ring of quadratic wedges, finer beside the flaw at x = 0,
// z = thick.
DefineConstant[ inner = 24, outer = 30, thick = 12, fine = 1 ];
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(1) = {0, 0, 0};
For k In {0:1}
  p = 10 + 10 * k;
  r = (k == 0 ? inner : outer) / 2;
  For i In {0:3}
    Point(p + i) = {r * Cos(i * Pi / 2), r * Sin(i * Pi / 2), 0, (i == 1 ? 0.9 : 3) / fine};
  EndFor
  For i In {0:3}
    Circle(p + i) = {p + i, 1, p + (i + 1) % 4};
  EndFor
  Curve Loop(k + 1) = {p:p + 3};
EndFor

Plane Surface(1) = {2, 1};
bushing[] = Extrude{0, 0, thick}{ Surface{1}; Layers{{2, 2, 3}, {0.5, 0.8, 1}}; Recombine; };
Physical Volume("BODY") = {bushing[1]};
Physical Surface("OUTSIDE") = {bushing[2], bushing[3], bushing[4], bushing[5]};
Physical Surface("INSIDE") = {bushing[6], bushing[7], bushing[8], bushing[9]};
