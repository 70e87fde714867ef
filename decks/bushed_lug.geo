// A lug with a round head, of quadratic wedges. The centre of the bore is the origin. The bushing in it is bushing.geo; both
// are drawn with the diameter `outer`, as the interference fit is a number of the deck.
DefineConstant[ outer = 30, width = 64, length = 100, thick = 12, layers = 3, fine = 1 ];
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
near = 2 / fine;
far = 8 / fine;

Point(1) = {0, 0, 0};
For i In {0:3}
  Point(10 + i) = {outer / 2 * Cos(i * Pi / 2), outer / 2 * Sin(i * Pi / 2), 0, near};
EndFor
For i In {0:3}
  Circle(10 + i) = {10 + i, 1, 10 + (i + 1) % 4};
EndFor
Curve Loop(1) = {10:13};

Point(2) = {0, -width / 2, 0, far};
Point(3) = {width / 2, 0, 0, far};
Point(4) = {0, width / 2, 0, far};
Point(5) = {-length, width / 2, 0, far};
Point(6) = {-length, -width / 2, 0, far};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 2};
Curve Loop(2) = {1:5};

Plane Surface(1) = {2, 1};
lug[] = Extrude{0, 0, thick}{ Surface{1}; Layers{layers}; Recombine; };
Physical Volume("BODY") = {lug[1]};
Physical Surface("END") = {lug[5]};
Physical Surface("BORE") = {lug[7], lug[8], lug[9], lug[10]};
