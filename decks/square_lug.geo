// A square lug of half width e with a bore of radius R at the origin. Values come from the deck;
// `fine` divides every mesh size.
DefineConstant[ R = 36, e = 86.5, fine = 1 ];
size_bore = 4 / fine;   // round the bore
size_lips = 1.2 / fine; // on the bore where cracks start and contact ends
size_far = 8 / fine;
Mesh.ElementOrder = 2;

Point(1) = {0, 0, 0};
// The bore, counter-clockwise from -22 degrees; finer arcs at both sides, where contact ends.
angle[] = {-22, 20, 90, 160, 202, 270, 338};
For i In {0:5}
  Point(10 + i) = {R * Cos(angle[i] * Pi / 180), R * Sin(angle[i] * Pi / 180), 0, size_bore};
EndFor
For i In {0:5}
  Circle(10 + i) = {10 + i, 1, 10 + (i + 1) % 6};
  span = (angle[i + 1] - angle[i]) * Pi / 180 * R;
  fine_arc = (i == 0 || i == 3);
  Transfinite Curve{10 + i} = Ceil(span / (fine_arc ? size_lips : size_bore)) + 1;
EndFor

Point(2) = {-e, -e, 0, size_far};
Point(3) = {e, -e, 0, size_far};
Point(4) = {e, e, 0, size_far};
Point(5) = {-e, e, 0, size_far};
Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 2};
Curve Loop(1) = {1:4};
Curve Loop(2) = {10:15};
Plane Surface(1) = {1, 2};

Physical Surface("BODY") = {1};
Physical Curve("BORE") = {10:15};
Physical Curve("FOOT") = {1};
