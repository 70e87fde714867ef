// A quarter of a ring 20 to 40 wide and 6 high about the axis z at x = 0; a quarter of the frustum of
// a cone with its tip at z = 0 on an axis at x = 200, 20 in radius at z = 40 and 30 at z = 60; an
// eighth of a ball of radius 20 about x = 300.
SetFactory("OpenCASCADE");
DefineConstant[ h = 5 ];
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MeshSizeMax = h;
Point(1) = {20, 0, 0};
Point(2) = {40, 0, 0};
Point(3) = {40, 0, 6};
Point(4) = {20, 0, 6};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Extrude{ {0, 0, 1}, {0, 0, 0}, Pi / 2 }{ Surface{1}; }
Point(101) = {200, 0, 40};
Point(102) = {220, 0, 40};
Point(103) = {230, 0, 60};
Point(104) = {200, 0, 60};
Line(101) = {101, 102};
Line(102) = {102, 103};
Line(103) = {103, 104};
Line(104) = {104, 101};
Curve Loop(101) = {101, 102, 103, 104};
Plane Surface(101) = {101};
Extrude{ {0, 0, 1}, {200, 0, 0}, Pi / 2 }{ Surface{101}; }
Sphere(3) = {300, 0, 0, 20, 0, Pi / 2, Pi / 2};
Physical Volume("RING") = {1};
Physical Volume("PLUG") = {2};
Physical Volume("BALL") = {3};
