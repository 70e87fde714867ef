// A quarter (or more, by `turn`) of a block with a spherical end of radius R (above) on a flat one (below),
// both of radius and height L, about the axis z. What may touch ends at the radius `touch`. Elements of size h up to 1.3 contact radii, those of
// the block below larger by `ratio`, growing from there on.
SetFactory("OpenCASCADE");
DefineConstant[ R = 20, L = 4, h = 0.08, ratio = 1.25, fine = 0.66, turn = Pi / 2, touch = L ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMax = 1.5;
Point(1) = {0, 0, R}; // centre of the sphere
Point(2) = {0, 0, 0};
Point(3) = {L, 0, R - Sqrt(R * R - L * L)};
Point(4) = {L, 0, L};
Point(5) = {0, 0, L};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 2};
If (touch < L)
  Point(6) = {touch, 0, R - Sqrt(R * R - touch * touch)};
  Circle(1) = {2, 1, 6};
  Circle(5) = {6, 1, 3};
  Curve Loop(1) = {1, 5, 2, 3, 4};
Else
  Circle(1) = {2, 1, 3};
  Curve Loop(1) = {1, 2, 3, 4};
EndIf
Plane Surface(1) = {1};
Extrude{ {0, 0, 1}, {0, 0, 0}, turn }{ Surface{1}; }
Point(101) = {0, 0, 0};
Point(102) = {L, 0, 0};
Point(103) = {L, 0, -L};
Point(104) = {0, 0, -L};
Line(102) = {102, 103};
Line(103) = {103, 104};
Line(104) = {104, 101};
If (touch < L)
  Point(105) = {touch, 0, 0};
  Line(101) = {101, 105};
  Line(105) = {105, 102};
  Curve Loop(200) = {101, 105, 102, 103, 104};
Else
  Line(101) = {101, 102};
  Curve Loop(200) = {101, 102, 103, 104};
EndIf
Plane Surface(100) = {200};
Extrude{ {0, 0, 1}, {0, 0, 0}, turn }{ Surface{100}; }
Physical Volume("SPHERE") = {1};
Physical Volume("FLOOR") = {2};
// The lowest surface of the sphere, the highest of the floor.
s() = Abs(Boundary{ Volume{1}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(5) < 0.6 && bb(3) < 1.1 * touch)
    Physical Surface("CAP") = {s(i)};
  EndIf
EndFor
s() = Abs(Boundary{ Volume{2}; });
For i In {0 : #s() - 1}
  bb() = BoundingBox Surface { s(i) };
  If (bb(2) > -0.1 && bb(3) < 1.1 * touch)
    Physical Surface("FLAT") = {s(i)};
  EndIf
EndFor
Field[1] = MathEval;
Field[1].F = Sprintf("%g*(1 - %g*(z - 0.0003)/(Abs(z - 0.0003) + 1e-7)) + 0.3*(Sqrt(x*x + y*y + z*z) - %g + Abs(Sqrt(x*x + y*y + z*z) - %g))/2",
                     h, (ratio - 1) / 2, fine, fine);
Background Field = 1;
