// Quarter of a cylinder of radius R that rests on the origin: centre (0, side R), side = 1 above,
// -1 below. The arc runs from the line of contact to the cut through the middle; elements of size h
// over `near`, growing away from it. Values come from the deck.
DefineConstant[ R = 20, near = 0.3, h = 0.03, side = 1, far = 2.5 ];
Mesh.ElementOrder = 2;

turn = near / R;
Point(1) = {0, side * R, 0, far};
Point(2) = {0, 0, 0, h};
Point(3) = {R * Sin(turn), side * R * (1 - Cos(turn)), 0, h};
Point(4) = {R, side * R, 0, far};
Point(5) = {0, side * 2 * near, 0, 4 * h};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 1};
Line(4) = {1, 5};
Line(5) = {5, 2};
Transfinite Curve{1} = Round(near / h) + 1;
If (side > 0)
  Curve Loop(1) = {1, 2, 3, 4, 5};
Else
  Curve Loop(1) = {-5, -4, -3, -2, -1};
EndIf
Plane Surface(1) = {1};

Physical Surface("BODY") = {1};
Physical Curve("FACE") = {1};
Physical Curve("CUT") = {3};
Physical Curve("SYM") = {4, 5};
